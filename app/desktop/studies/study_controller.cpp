// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/desktop/studies/study_controller.h"

#include <QAction>
#include <QClipboard>
#include <QDockWidget>
#include <QGuiApplication>

#include "app/desktop/editing/quick_fixer.h"
#include "app/desktop/editing/scene_repairer.h"
#include "app/desktop/editing/setting_writer.h"
#include "app/desktop/studies/study_panels.h"
#include "app/desktop/studies/verdict_controller.h"
#include "app/desktop/window/actions.h"
#include "app/desktop/window/docks.h"
#include "app/desktop/window/rest_watch.h"
#include "core/exchange/formulas/difference_text.h"
#include "widgets/document/scene_session.h"
#include "widgets/linked_probe.h"
#include "widgets/section/section_panel.h"
#include "widgets/studies/cost_surveyor.h"
#include "widgets/studies/gradient_panel.h"
#include "widgets/studies/range_surveyor.h"
#include "widgets/studies/repair_panel.h"
#include "widgets/verdicts/verdict_badge.h"
#include "widgets/viewport/viewport.h"

namespace isoscope {

StudyController::StudyController(const Parts& parts, QObject* parent)
    : QObject(parent),
      parts_(parts),
      rest_(new RestWatch(parts.viewport, parts.parameters, this)),
      surveyor_(new CostSurveyor(parts.parameters, this)),
      ranges_(new RangeSurveyor(parts.parameters, this)),
      probe_(new LinkedProbe(this)) {
    verdicts_ =
        new VerdictController({parts.viewport, parts.editor, parts.session, parts.problems,
                               parts.panels->get<GradientPanel>(), parts.panels->get<RepairPanel>(),
                               parts.panels->get<SectionPanel>(), parts.docks->find("gradient"), parts.badge},
                              this);
    connect(parts.badge, &VerdictBadge::mendRequested, parts.settings, &SettingWriter::setMaxGradients);
    connect(rest_, &RestWatch::rested, surveyor_, &CostSurveyor::rest);
    connect(rest_, &RestWatch::moved, surveyor_, &CostSurveyor::stop);
    connect(rest_, &RestWatch::rested, ranges_, &RangeSurveyor::rest);
    connect(rest_, &RestWatch::moved, ranges_, &RangeSurveyor::stop);
    connectPanels();
    connectOverlays();
    connectProbe();
    connect(parts.viewport, &Viewport::viewChanged, this, &StudyController::followView);
    connect(parts.viewport, &Viewport::pictureFinished, this, &StudyController::followView);
    connect(parts.session, &SceneSession::shownChanged, this, [this](SceneSession::Shown shown) {
        // No scene follows a text that cannot be shown.
        if (shown == SceneSession::Shown::nothing || shown == SceneSession::Shown::older)
            surveyor_->judgeStrips();
    });
}

void StudyController::setScene(const std::shared_ptr<const Scene>& scene) {
    followView();
    for (const StudyPanels::Entry& entry : parts_.panels->entries()) entry.panel->setScene(scene);
    verdicts_->setScene(scene);
    surveyor_->setScene(scene);
    ranges_->setScene(scene);
    probe_->setScene(scene);
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
    for (const StudyPanels::Entry& entry : parts_.panels->entries()) entry.panel->leaveDocument();
}

void StudyController::stop() {
    verdicts_->setScene({});
    for (const StudyPanels::Entry& entry : parts_.panels->entries()) entry.panel->endWork();
    surveyor_->stop();
    ranges_->stop();
    probe_->setScene({});
    parts_.viewport->overlay().stop();
}

void StudyController::followView() {
    const QSize size = parts_.viewport->size();
    const Camera camera = fittedCamera(parts_.viewport->camera(), size.width(), size.height());
    for (const StudyPanels::Entry& entry : parts_.panels->entries()) entry.panel->setView(camera, size);
    surveyor_->setView(parts_.viewport->camera());
    probe_->setSight([view = parts_.viewport->projection()](const glm::dvec3& point) -> std::optional<Ray> {
        const auto pixel = view.pixelOf(point);
        if (!pixel) return {};
        return view.rayAt(*pixel);
    });
    probePicture();
}

void StudyController::connectProbe() {
    Viewport* viewport = parts_.viewport;
    auto* hover = new HoverWatch(viewport);
    connect(hover, &HoverWatch::hovered, this, [this](QPointF pixel) {
        hovered_ = pixel;
        probePicture();
    });
    connect(hover, &HoverWatch::ended, this, [this, viewport] {
        hovered_.reset();
        probe_->release(viewport);
    });
    for (const StudyPanels::Entry& entry : parts_.panels->entries()) {
        StudyPanel* panel = entry.panel;
        connect(panel, &StudyPanel::probed, probe_,
                [this, panel](std::size_t isosurface, const glm::dvec3& at) {
                    probe_->probe(panel, isosurface, at);
                });
        connect(panel, &StudyPanel::probeEnded, probe_, [this, panel] { probe_->release(panel); });
    }
    connect(probe_, &LinkedProbe::changed, this, &StudyController::showProbe);
}

void StudyController::probePicture() {
    if (hovered_) probe_->probeRay(parts_.viewport, parts_.viewport->projection().rayAt(*hovered_));
}

void StudyController::showProbe() {
    const auto& point = probe_->point();
    // Under the mouse itself a mark would only be in the way.
    const bool seen = point && !probe_->hidden() && probe_->source() != parts_.viewport;
    parts_.viewport->probeMark().set(seen ? std::optional(point->inScene) : std::nullopt);
    for (const StudyPanels::Entry& entry : parts_.panels->entries())
        entry.panel->showProbe(point ? &*point : nullptr);
}

void StudyController::connectPanels() {
    auto* fixer = new QuickFixer(parts_.editor, parts_.session, this);
    connect(fixer, &QuickFixer::said, this, &StudyController::said);
    auto* repairer =
        new SceneRepairer({parts_.editor, parts_.session, parts_.settings, parts_.notices}, this);
    connect(repairer, &SceneRepairer::said, this, &StudyController::said);
    const StudyLinks links{parts_.actions,    parts_.viewport, parts_.docks,  parts_.settings,
                           parts_.parameters, parts_.session,  parts_.editor, fixer,
                           repairer,          parts_.problems, parts_.panels};
    for (const StudyPanels::Entry& entry : parts_.panels->entries()) {
        StudyPanel* panel = entry.panel;
        connect(panel, &StudyPanel::said, this, &StudyController::said);
        connect(parts_.docks->find(entry.id), &QDockWidget::visibilityChanged, panel, &StudyPanel::setActive);
        connect(rest_, &RestWatch::rested, panel, [panel] { panel->setResting(true); });
        connect(rest_, &RestWatch::moved, panel, [panel] { panel->setResting(false); });
        if (entry.connect) entry.connect(links);
    }
}

void StudyController::copyDifference() {
    const auto &kept = parts_.viewport->overlay().kept(), &now = parts_.session->scene();
    if (!kept || kept->isosurfaces.empty() || !now || now->isosurfaces.empty()) {
        emit said(tr("There are no two isosurfaces to compare."));
        return;
    }
    const DifferenceText difference = differenceText(*kept->isosurfaces.front().shape, *kept->parameterTable,
                                                     *now->isosurfaces.front().shape, *now->parameterTable);
    if (difference.text.empty()) {
        emit said(QString::fromStdString(difference.problem));
        return;
    }
    QGuiApplication::clipboard()->setText(QString::fromStdString(difference.text));
    emit said(tr("The difference surface, f kept less f now, is on the clipboard."));
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
    on(actions.overlayCost, OverlayKind::cost);
    on(actions.overlayPovray, OverlayKind::besidePovray);
    on(actions.overlayPovrayDifference, OverlayKind::povrayDifference);
    connect(actions.overlayCompare, &QAction::triggered, this, [this] {
        parts_.viewport->overlay().keep(parts_.session->scene());
        parts_.viewport->overlay().setKind(OverlayKind::compare);
    });
    connect(actions.overlayCompare, &QAction::toggled, actions.copyDifference, &QAction::setEnabled);
    connect(actions.copyDifference, &QAction::triggered, this, &StudyController::copyDifference);
}

}  // namespace isoscope
