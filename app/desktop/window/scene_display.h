// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <QObject>
#include <QTimer>

#include "core/scene/scene.h"
#include "widgets/document/scene_session.h"

namespace isoscope {

class PreviewLight;
class StudyController;
class Viewport;

/// Shows the scene of the session: in the picture at once, in the study panels when that leaves them the
/// processors; and says over the picture how it stands to the text.
class SceneDisplay : public QObject {
    Q_OBJECT
  public:
    /// What takes part; the display owns none of it.
    struct Parts {
        SceneSession* session;
        Viewport* viewport;
        PreviewLight* light;
        StudyController* studies;
    };
    SceneDisplay(const Parts& parts, QObject* parent);

    /// Another document is shown from now on; its scene is still to come.
    void begin();
    /// The panels do not show the session's scene yet.
    bool panelsBehind() const { return panelsBehind_; }

    /// A slider plays: its pictures come first, the panels follow a few times in a second.
    void setPlaying(bool playing);

  private:
    void showScene(const std::shared_ptr<const Scene>& scene, bool sameLook);
    void schedulePanels();
    void showInPanels();
    void showState(SceneSession::Shown shown);

    Parts parts_;
    SceneSession::Shown shown_ = SceneSession::Shown::complete;
    bool panelsBehind_ = false;
    bool playing_ = false;
    QTimer panelTimer_;  ///< when they follow
};

}  // namespace isoscope
