// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <functional>
#include <map>
#include <QObject>
#include <vector>

#include "widgets/numbers/setting_text.h"

namespace isoscope {

class SceneEditor;
class SceneSession;

/// Writes settings that a panel found into the text, as one undo step each.
class SettingWriter : public QObject {
    Q_OBJECT
  public:
    SettingWriter(SceneEditor* editor, SceneSession* session, QObject* parent);

    /// Gives isosurface number `isosurface` another max_gradient. A text that is newer than its parse is
    /// parsed first, for the places to be right.
    void setMaxGradient(std::size_t isosurface, double value);
    /// The same for several at once, in one undo step. Of those that one statement makes the largest counts.
    void setMaxGradients(const std::map<std::size_t, double>& values);
    /// The same for the accuracy or max_gradient of all isosurfaces of the text.
    void setForAll(ParameterRole role, double value);
    /// Gives isosurface number `isosurface` `evaluate` with these numbers, and the first of them as
    /// max_gradient, with which POV-Ray begins.
    void setEvaluate(std::size_t isosurface, const std::array<double, 3>& numbers);

  signals:
    /// For the status line.
    void said(const QString& message);

  private:
    /// Calls `write` as soon as there is a parse of the present text.
    void whenParsed(std::function<void()> write);
    void write(const std::vector<TextChange>& changes, ParameterRole role, double value);

    SceneEditor* editor_;
    SceneSession* session_;
    std::function<void()> waiting_;
};

}  // namespace isoscope
