// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <QObject>

#include "core/language/parse.h"

namespace isoscope {

class NoticeBar;
class SceneEditor;
class SceneSession;

/// Offers to show objects without a pigment, which POV-Ray draws black, in grey: in the picture of the window
/// only. What it offers is asked once for each document.
class PreviewLight : public QObject {
    Q_OBJECT
  public:
    PreviewLight(SceneEditor* editor, SceneSession* session, NoticeBar* notices, QObject* parent);

    /// The scene as the window shows it.
    std::shared_ptr<const Scene> shown(const std::shared_ptr<const Scene>& scene) const;
    /// Another document: everything is as POV-Ray shows it.
    void begin();
    bool isOn() const { return on_; }

  signals:
    /// shown() is another one now.
    void changed();

  private:
    void consider(const ParseResult& result);

    SceneSession* session_;
    NoticeBar* notices_;
    QString notice_;
    bool asked_ = false;
    bool on_ = false;
};

}  // namespace isoscope
