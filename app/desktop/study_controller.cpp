// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/desktop/study_controller.h"

#include <QAction>

#include "app/desktop/actions.h"
#include "widgets/viewport.h"

namespace isoscope {

StudyController::StudyController(const Parts& parts, QObject* parent) : QObject(parent), parts_(parts) {
    connectOverlays();
}

void StudyController::connectOverlays() {
    const auto on = [this](QAction* action, OverlayKind kind) {
        connect(action, &QAction::triggered, this,
                [this, kind] { parts_.viewport->overlay().setKind(kind); });
    };
    const Actions& actions = *parts_.actions;
    on(actions.overlayNone, OverlayKind::none);
    on(actions.overlayHoles, OverlayKind::holes);
    on(actions.overlaySplit, OverlayKind::split);
    on(actions.overlayDifference, OverlayKind::difference);
    on(actions.overlayGradient, OverlayKind::gradient);
}

}  // namespace isoscope
