// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/desktop/study_controller.h"

#include <QAction>

#include "app/desktop/actions.h"
#include "app/desktop/setting_writer.h"
#include "widgets/accuracy_panel.h"
#include "widgets/viewport.h"

namespace isoscope {

StudyController::StudyController(const Parts& parts, QObject* parent) : QObject(parent), parts_(parts) {
    connectOverlays();
    connectAccuracy();
    connect(parts.viewport, &Viewport::viewChanged, this, &StudyController::followView);
    connect(parts.viewport, &Viewport::pictureFinished, this, &StudyController::followView);
}

void StudyController::setScene(const std::shared_ptr<const Scene>& scene) {
    followView();
    parts_.accuracy->setScene(scene);
}

void StudyController::followView() {
    const QSize size = parts_.viewport->size();
    parts_.accuracy->setView(fittedCamera(parts_.viewport->camera(), size.width(), size.height()), size);
}

void StudyController::connectAccuracy() {
    connect(parts_.accuracy, &AccuracyPanel::settingRequested, parts_.settings,
            [this](StudiedSetting setting, double value) {
                parts_.settings->setForAll(setting == StudiedSetting::accuracy ? ParameterRole::accuracy
                                                                               : ParameterRole::maxGradient,
                                           value);
            });
    connect(parts_.accuracy, &AccuracyPanel::said, this, &StudyController::said);
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
