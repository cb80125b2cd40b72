// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/desktop/window/scene_display.h"

#include <utility>

#include "app/desktop/editing/preview_light.h"
#include "app/desktop/studies/study_controller.h"
#include "widgets/timing.h"
#include "widgets/viewport/viewport.h"

namespace isoscope {

SceneDisplay::SceneDisplay(const Parts& parts, QObject* parent) : QObject(parent), parts_(parts) {
    connect(parts.session, &SceneSession::sceneChanged, this, &SceneDisplay::showScene);
    connect(parts.session, &SceneSession::shownChanged, this, &SceneDisplay::showState);
    connect(parts.light, &PreviewLight::changed, this, [this] { showScene(parts_.session->scene(), false); });
    // What was under way is there.
    connect(parts.viewport, &Viewport::pictureFinished, this, [this] {
        if (shown_ == SceneSession::Shown::older) showState(shown_);
    });
    connect(parts.viewport, &Viewport::progressed, this, &SceneDisplay::schedulePanels);
    panelTimer_.setSingleShot(true);
    connect(&panelTimer_, &QTimer::timeout, this, &SceneDisplay::showInPanels);
}

void SceneDisplay::begin() {
    panelsBehind_ = false;
    parts_.studies->leaveDocument();
    parts_.viewport->setNotice({});
    shown_ = SceneSession::Shown::complete;
}

void SceneDisplay::showScene(const std::shared_ptr<const Scene>& scene, bool sameLook) {
    parts_.viewport->setScene(parts_.light->shown(scene), sameLook);
    panelsBehind_ = true;
    schedulePanels();
}

void SceneDisplay::setPlaying(bool playing) {
    playing_ = playing;
    schedulePanels();
}

void SceneDisplay::schedulePanels() {
    if (!panelsBehind_) return;
    if (playing_) {
        if (!panelTimer_.isActive()) panelTimer_.start(timing::playedPanelInterval);
        return;
    }
    // The picture comes first: the panels would take half of its processors. They do not wait for slow ones,
    // but for that of a new document: they may have to start OpenGL, which takes far longer.
    if (parts_.viewport->finished())
        panelTimer_.start(0);  // once it is painted
    else if (!panelTimer_.isActive() && !parts_.viewport->picture().isNull())
        panelTimer_.start(timing::panelPatience);
}

void SceneDisplay::showInPanels() {
    if (!std::exchange(panelsBehind_, false)) return;
    parts_.studies->setScene(parts_.session->scene());
}

void SceneDisplay::showState(SceneSession::Shown shown) {
    shown_ = shown;
    Viewport* viewport = parts_.viewport;
    switch (shown) {
        case SceneSession::Shown::complete: return viewport->setNotice({});
        case SceneSession::Shown::partial:
            return viewport->setNotice(tr("The text has errors; what was understood of it is shown."));
        case SceneSession::Shown::older:
            if (viewport->picture().isNull())
                return viewport->setNotice(
                    tr("The text has errors; the first picture, of the text before them, is under way."));
            return viewport->setNotice(tr("The text has errors; this is the picture from before."),
                                       Viewport::Dimmed::yes);
        case SceneSession::Shown::nothing:
            return viewport->setNotice(
                tr("The text has errors, listed under Problems; nothing can be shown yet."));
    }
}

}  // namespace isoscope
