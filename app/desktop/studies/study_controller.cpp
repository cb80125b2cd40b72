// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/desktop/studies/study_controller.h"

#include <algorithm>
#include <QAction>
#include <QDockWidget>

#include "app/desktop/editing/setting_writer.h"
#include "app/desktop/studies/study_panels.h"
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
      gradient_(parts.panels->get<GradientPanel>()),
      histogram_(parts.panels->get<HistogramPanel>()),
      accuracy_(parts.panels->get<AccuracyPanel>()),
      ray_(parts.panels->get<RayPanel>()),
      effects_(parts.panels->get<EffectsPanel>()),
      section_(parts.panels->get<SectionPanel>()),
      rest_(new RestWatch(parts.viewport, parts.parameters, this)),
      surveyor_(new CostSurveyor(parts.parameters, this)) {
    verdicts_ = new VerdictController({parts.viewport, parts.editor, parts.session, parts.problems, gradient_,
                                       section_, parts.docks->gradient, parts.badge},
                                      this);
    connect(parts.badge, &VerdictBadge::mendRequested, parts.settings, &SettingWriter::setMaxGradients);
    connectPanels();
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
    for (const StudyPanels::Entry& entry : parts_.panels->entries()) entry.panel->setScene(scene);
    verdicts_->setScene(scene);
    surveyor_->setScene(scene);
    rest_->disturb();
}

void StudyController::setExportSize(QSize size) {
    surveyor_->setPictureSize(size);
    rest_->disturb();
}

void StudyController::leaveDocument() {
    setScene({});
    parts_.actions->overlayNone->trigger();
    parts_.actions->inspectRay->setChecked(false);
    parts_.actions->sectionPlane->setChecked(false);
    section_->leaveScene();
}

void StudyController::stop() {
    verdicts_->setScene({});
    gradient_->setWanted(false);
    for (const StudyPanels::Entry& entry : parts_.panels->entries()) entry.panel->endWork();
    surveyor_->stop();
    parts_.viewport->overlay().stop();
}

void StudyController::followView() {
    const QSize size = parts_.viewport->size();
    const Camera camera = fittedCamera(parts_.viewport->camera(), size.width(), size.height());
    for (const StudyPanels::Entry& entry : parts_.panels->entries()) entry.panel->setView(camera, size);
    surveyor_->setView(parts_.viewport->camera());
}

void StudyController::connectPanels() {
    const QList<StudyPanels::Entry>& entries = parts_.panels->entries();
    for (qsizetype i = 0; i < entries.size(); ++i) {
        StudyPanel* panel = entries[i].panel;
        connect(panel, &StudyPanel::said, this, &StudyController::said);
        connect(parts_.docks->studies[i], &QDockWidget::visibilityChanged, panel, &StudyPanel::setActive);
        connect(rest_, &RestWatch::rested, panel, [panel] { panel->setResting(true); });
        connect(rest_, &RestWatch::moved, panel, [panel] { panel->setResting(false); });
    }
}

void StudyController::connectGradient() {
    // The histogram shows what the Gradient panel measures, so either of them makes it work.
    for (QDockWidget* dock : {parts_.docks->gradient, parts_.docks->histogram})
        connect(dock, &QDockWidget::visibilityChanged, this, [this, dock](bool visible) {
            shown_[dock] = visible;
            gradient_->setWanted(std::any_of(shown_.begin(), shown_.end(), [](bool on) { return on; }));
        });
    connect(gradient_, &GradientPanel::reported, histogram_, &HistogramPanel::show);
    connect(gradient_, &GradientPanel::settingRequested, parts_.settings, &SettingWriter::setMaxGradient);
}

void StudyController::connectAccuracy() {
    connect(accuracy_, &AccuracyPanel::settingRequested, parts_.settings,
            [this](StudiedSetting setting, double value) {
                parts_.settings->setForAll(setting == StudiedSetting::accuracy ? ParameterRole::accuracy
                                                                               : ParameterRole::maxGradient,
                                           value);
            });
}

void StudyController::connectCosts() {
    connect(rest_, &RestWatch::rested, surveyor_, &CostSurveyor::rest);
    connect(rest_, &RestWatch::moved, surveyor_, &CostSurveyor::stop);
}

void StudyController::connectRay() {
    connect(parts_.actions->inspectRay, &QAction::toggled, this, [this](bool on) {
        parts_.viewport->setPicking(on);
        if (!on) return parts_.viewport->setPicked({});
        parts_.docks->bringUp(parts_.docks->ray);
    });
    connect(parts_.viewport, &Viewport::picked, this, [this](QPointF place) {
        parts_.viewport->setPicked(place);
        ray_->setPixel(place);
        tellPictured();
        parts_.docks->bringUp(parts_.docks->ray);
    });
    connect(&parts_.viewport->overlay(), &ViewOverlay::changed, this, &StudyController::tellPictured);
}

void StudyController::connectEffects() {
    connect(parts_.viewport, &Viewport::progressed, effects_, &EffectsPanel::show);
    connect(effects_, &EffectsPanel::leftOutChanged, parts_.viewport, &Viewport::setLeftOut);
    connect(effects_, &EffectsPanel::movingSecondsChanged, parts_.viewport, &Viewport::setMovingSeconds);
}

/// What the hole map says about the pixel whose ray is shown.
void StudyController::tellPictured() {
    const HoleMap& map = parts_.viewport->overlay().holes();
    const auto& place = ray_->pixel();
    if (!place || !map.complete || map.pixels.empty()) return ray_->setPictured({});
    const int x = std::clamp(static_cast<int>(place->x() * map.width), 0, map.width - 1);
    const int y = std::clamp(static_cast<int>(place->y() * map.height), 0, map.height - 1);
    ray_->setPictured(map.pixels[static_cast<std::size_t>(y) * static_cast<std::size_t>(map.width) +
                                 static_cast<std::size_t>(x)]);
}

void StudyController::connectSection() {
    PlaneHandle& handle = parts_.viewport->planeHandle();
    connect(parts_.actions->sectionPlane, &QAction::toggled, this, [this, &handle](bool on) {
        handle.setShown(on);
        if (!on) return;
        parts_.docks->bringUp(parts_.docks->section);
    });
    connect(section_, &SectionPanel::planeChanged, this, &StudyController::showPlane);
    connect(section_, &SectionPanel::freed, parts_.actions->sectionPlane,
            [this] { parts_.actions->sectionPlane->setChecked(true); });
    connect(&handle, &PlaneHandle::moved, section_, &SectionPanel::setPosition);
    connect(&handle, &PlaneHandle::turned, section_, [this](double x, double y, double z) {
        section_->turnTowards({x, y, z});
    });
    showPlane();
}

void StudyController::showPlane() {
    PlaneHandle& handle = parts_.viewport->planeHandle();
    const SceneIsosurface* subject = section_->subject();
    if (!subject) return handle.clear();
    handle.setPlane(section_->plane(), subject->shape->settings().container, subject->transform);
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
