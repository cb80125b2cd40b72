// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/desktop/studies/study_controller.h"

#include <algorithm>
#include <QAction>
#include <QDockWidget>

#include "app/desktop/editing/setting_writer.h"
#include "app/desktop/studies/verdict_controller.h"
#include "app/desktop/window/actions.h"
#include "app/desktop/window/docks.h"
#include "app/desktop/window/rest_watch.h"
#include "widgets/section/section_panel.h"
#include "widgets/studies/accuracy_panel.h"
#include "widgets/studies/cost_surveyor.h"
#include "widgets/studies/effects_panel.h"
#include "widgets/studies/gradient_panel.h"
#include "widgets/studies/histogram_panel.h"
#include "widgets/studies/ray_panel.h"
#include "widgets/verdicts/verdict_badge.h"
#include "widgets/viewport/viewport.h"

namespace isoscope {

StudyController::StudyController(const Parts& parts, QObject* parent)
    : QObject(parent),
      parts_(parts),
      rest_(new RestWatch(parts.viewport, parts.parameters, this)),
      surveyor_(new CostSurveyor(parts.parameters, this)) {
    verdicts_ = new VerdictController({parts.viewport, parts.editor, parts.session, parts.problems,
                                       parts.gradient, parts.section, parts.docks->gradient, parts.badge},
                                      this);
    connect(parts.badge, &VerdictBadge::mendRequested, parts.settings, &SettingWriter::setMaxGradients);
    connectOverlays();
    connectGradient();
    connectAccuracy();
    connectCosts();
    connectRay();
    connectEffects();
    connectSection();
    connect(parts.viewport, &Viewport::viewChanged, this, &StudyController::followView);
    connect(parts.viewport, &Viewport::pictureFinished, this, &StudyController::followView);
}

void StudyController::setScene(const std::shared_ptr<const Scene>& scene) {
    followView();
    verdicts_->setScene(scene);
    parts_.gradient->setScene(scene);
    parts_.accuracy->setScene(scene);
    surveyor_->setScene(scene);
    rest_->disturb();
    parts_.ray->setScene(scene);
}

void StudyController::leaveDocument() {
    setScene({});
    parts_.section->setScene({});
    parts_.actions->overlayNone->trigger();
    parts_.actions->inspectRay->setChecked(false);
    parts_.actions->sectionPlane->setChecked(false);
    parts_.section->leaveScene();
}

void StudyController::stop() {
    parts_.gradient->setActive(false);
    parts_.ray->setActive(false);
    parts_.accuracy->setScene({});
    parts_.section->setScene({});
    surveyor_->stop();
    parts_.viewport->overlay().stop();
}

void StudyController::followView() {
    const QSize size = parts_.viewport->size();
    const Camera camera = fittedCamera(parts_.viewport->camera(), size.width(), size.height());
    parts_.gradient->setView(camera, size);
    parts_.accuracy->setView(camera, size);
    surveyor_->setView(parts_.viewport->camera());
    parts_.ray->setView(camera, size);
}

void StudyController::connectGradient() {
    // The histogram shows what the Gradient panel measures, so either of them makes it work.
    for (QDockWidget* dock : {parts_.docks->gradient, parts_.docks->histogram})
        connect(dock, &QDockWidget::visibilityChanged, this, [this, dock](bool visible) {
            shown_[dock] = visible;
            parts_.gradient->setActive(std::any_of(shown_.begin(), shown_.end(), [](bool on) { return on; }));
        });
    connect(parts_.histogram, &HistogramPanel::said, this, &StudyController::said);
    connect(parts_.gradient, &GradientPanel::reported, parts_.histogram, &HistogramPanel::show);
    connect(parts_.gradient, &GradientPanel::settingRequested, parts_.settings,
            &SettingWriter::setMaxGradient);
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

void StudyController::connectCosts() {
    connect(rest_, &RestWatch::rested, surveyor_, &CostSurveyor::rest);
    connect(rest_, &RestWatch::moved, surveyor_, &CostSurveyor::stop);
    connect(rest_, &RestWatch::rested, parts_.accuracy, [this] { parts_.accuracy->setResting(true); });
    connect(rest_, &RestWatch::moved, parts_.accuracy, [this] { parts_.accuracy->setResting(false); });
}

void StudyController::connectRay() {
    connect(parts_.docks->ray, &QDockWidget::visibilityChanged, parts_.ray, &RayPanel::setActive);
    connect(parts_.ray, &RayPanel::said, this, &StudyController::said);
    connect(parts_.actions->inspectRay, &QAction::toggled, this, [this](bool on) {
        parts_.viewport->setPicking(on);
        if (!on) return parts_.viewport->setPicked({});
        parts_.docks->bringUp(parts_.docks->ray);
    });
    connect(parts_.viewport, &Viewport::picked, this, [this](QPointF place) {
        parts_.viewport->setPicked(place);
        parts_.ray->setPixel(place);
        tellPictured();
        parts_.docks->bringUp(parts_.docks->ray);
    });
    connect(&parts_.viewport->overlay(), &ViewOverlay::changed, this, &StudyController::tellPictured);
}

void StudyController::connectEffects() {
    connect(parts_.viewport, &Viewport::progressed, parts_.effects, &EffectsPanel::show);
    connect(parts_.effects, &EffectsPanel::leftOutChanged, parts_.viewport, &Viewport::setLeftOut);
    connect(parts_.effects, &EffectsPanel::movingSecondsChanged, parts_.viewport,
            &Viewport::setMovingSeconds);
}

/// What the hole map says about the pixel whose ray is shown.
void StudyController::tellPictured() {
    const HoleMap& map = parts_.viewport->overlay().holes();
    const auto& place = parts_.ray->pixel();
    if (!place || !map.complete || map.pixels.empty()) return parts_.ray->setPictured({});
    const int x = std::clamp(static_cast<int>(place->x() * map.width), 0, map.width - 1);
    const int y = std::clamp(static_cast<int>(place->y() * map.height), 0, map.height - 1);
    parts_.ray->setPictured(map.pixels[static_cast<std::size_t>(y) * static_cast<std::size_t>(map.width) +
                                       static_cast<std::size_t>(x)]);
}

void StudyController::connectSection() {
    PlaneHandle& handle = parts_.viewport->planeHandle();
    connect(parts_.actions->sectionPlane, &QAction::toggled, this, [this, &handle](bool on) {
        handle.setShown(on);
        if (!on) return;
        parts_.docks->bringUp(parts_.docks->section);
    });
    connect(parts_.section, &SectionPanel::planeChanged, this, &StudyController::showPlane);
    connect(parts_.section, &SectionPanel::freed, parts_.actions->sectionPlane,
            [this] { parts_.actions->sectionPlane->setChecked(true); });
    connect(parts_.section, &SectionPanel::said, this, &StudyController::said);
    connect(&handle, &PlaneHandle::moved, parts_.section, &SectionPanel::setPosition);
    connect(&handle, &PlaneHandle::turned, parts_.section, [this](double x, double y, double z) {
        parts_.section->turnTowards({x, y, z});
    });
    showPlane();
}

void StudyController::showPlane() {
    PlaneHandle& handle = parts_.viewport->planeHandle();
    const SceneIsosurface* subject = parts_.section->subject();
    if (!subject) return handle.clear();
    handle.setPlane(parts_.section->plane(), subject->shape->settings().container, subject->transform);
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
