// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QPointer>

#include "core/scene/scene.h"

class QAbstractButton;

namespace isoscope {

struct NumberLiteral;
class NumberPopup;
class ParameterBinding;
class SceneEditor;

/// Makes any number of the text a slider: a small handle under the number at the caret opens one, as do a key
/// and a click with Ctrl. Numbers with a slider among the parameters have the same range there.
class NumberTool : public QObject {
    Q_OBJECT
  public:
    /// Both must outlive the tool.
    NumberTool(SceneEditor* editor, const ParameterBinding* binding, QObject* parent = nullptr);
    ~NumberTool() override;

    /// Opens the slider of the number at the caret.
    void open();
    /// Null while none is open.
    NumberPopup* popup() const;
    QAbstractButton* handle() const { return handle_; }

  signals:
    /// For the status line.
    void said(const QString& message);

  private:
    SceneParameter describe(const NumberLiteral& number) const;
    void placeHandle();

    SceneEditor* editor_;
    const ParameterBinding* binding_;
    QAbstractButton* handle_;
    QPointer<NumberPopup> popup_;
};

}  // namespace isoscope
