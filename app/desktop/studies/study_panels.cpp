// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/desktop/studies/study_panels.h"

#include <algorithm>
#include <QAction>
#include <QCoreApplication>
#include <QDockWidget>
#include <QMap>

#include "app/desktop/editing/quick_fixer.h"
#include "app/desktop/editing/scene_repairer.h"
#include "app/desktop/editing/setting_writer.h"
#include "app/desktop/studies/verdict_controller.h"
#include "app/desktop/window/actions.h"
#include "app/desktop/window/docks.h"
#include "core/exchange/varied_number.h"
#include "widgets/document/scene_session.h"
#include "widgets/editor/scene_editor.h"
#include "widgets/parameters/parameter_panel.h"
#include "widgets/parameters/parameter_slider.h"
#include "widgets/section/section_panel.h"
#include "widgets/studies/accuracy_panel.h"
#include "widgets/studies/effects_panel.h"
#include "widgets/studies/evaluate_panel.h"
#include "widgets/studies/formula_panel.h"
#include "widgets/studies/gradient_panel.h"
#include "widgets/studies/histogram_panel.h"
#include "widgets/studies/ray_panel.h"
#include "widgets/studies/repair_panel.h"
#include "widgets/studies/report_panel.h"
#include "widgets/studies/sheet_panel.h"
#include "widgets/studies/sweep_panel.h"
#include "widgets/studies/threshold_panel.h"
#include "widgets/verdicts/problems_panel.h"
#include "widgets/viewport/viewport.h"

namespace isoscope {

namespace {

struct Words {
    Q_DECLARE_TR_FUNCTIONS(StudyPanels)
};

/// One that View, Panels opens.
StudyPanels::Entry closedAtFirst(StudyPanels::Entry entry) {
    entry.closed = true;
    return entry;
}

/// A panel that only shows the scene.
template <class Panel>
StudyPanels::Entry row(const char* id, const QString& title, const QString& help) {
    return {id, title, help, new Panel, {}};
}

/// A panel that has signals for others, or takes some.
template <class Panel>
StudyPanels::Entry row(const char* id, const QString& title, const QString& help,
                       void (*connect)(Panel*, const StudyLinks&)) {
    auto* panel = new Panel;
    return {id, title, help, panel, [panel, connect](const StudyLinks& links) { connect(panel, links); }};
}

void connectSection(SectionPanel* section, const StudyLinks& links) {
    PlaneHandle& handle = links.viewport->planeHandle();
    QAction* tool = links.actions->sectionPlane;
    const auto showPlane = [section, &handle] {
        const SceneIsosurface* subject = section->subject();
        if (!subject) return handle.clear();
        handle.setPlane(section->plane(), subject->shape->settings().container, subject->transform);
    };
    QObject::connect(tool, &QAction::toggled, section, [&handle, docks = links.docks](bool on) {
        handle.setShown(on);
        if (on) docks->bringUp(docks->find("section"));
    });
    QObject::connect(section, &SectionPanel::planeChanged, section, showPlane);
    QObject::connect(section, &SectionPanel::freed, tool, [tool] { tool->setChecked(true); });
    QObject::connect(&handle, &PlaneHandle::moved, section, &SectionPanel::setPosition);
    QObject::connect(&handle, &PlaneHandle::turned, section, [section](double x, double y, double z) {
        section->turnTowards({x, y, z});
    });
    showPlane();
}

void connectGradient(GradientPanel* gradient, const StudyLinks& links) {
    // The histogram shows what the Gradient panel measures, so either of them makes it work.
    const auto seen = std::make_shared<QMap<QString, bool>>();
    for (const char* id : {"gradient", "histogram"})
        QObject::connect(links.docks->find(id), &QDockWidget::visibilityChanged, gradient,
                         [gradient, seen, name = QString::fromLatin1(id)](bool visible) {
                             seen->insert(name, visible);
                             gradient->setWanted(seen->values().contains(true));
                         });
    QObject::connect(gradient, &GradientPanel::settingRequested, links.settings,
                     &SettingWriter::setMaxGradient);
}

void connectHistogram(HistogramPanel* histogram, const StudyLinks& links) {
    auto* gradient = links.panels->get<GradientPanel>();
    QObject::connect(
        gradient, &GradientPanel::reported, histogram,
        [gradient, histogram](const GradientSurvey& survey) { histogram->show(survey, gradient->chosen()); });
}

void connectThresholds(ThresholdPanel* thresholds, const StudyLinks& links) {
    const auto rowOf = [parameters = links.parameters](const SceneIsosurface* subject) {
        return subject ? parameters->settingOf(subject->range, ParameterRole::threshold) : nullptr;
    };
    QObject::connect(
        thresholds, &ThresholdPanel::thresholdMoved, links.parameters, [thresholds, rowOf](double value) {
            if (ParameterSlider* row = rowOf(thresholds->subject()))
                row->moveTo(value);
            else
                emit thresholds->said(
                    Words::tr("The threshold does not stand in the text itself; it is not changed."));
        });
    QObject::connect(thresholds, &ThresholdPanel::thresholdSettled, links.parameters, [thresholds, rowOf] {
        if (ParameterSlider* row = rowOf(thresholds->subject())) row->settle();
    });
    QObject::connect(thresholds, &ThresholdPanel::placeRequested, links.viewport,
                     [thresholds, viewport = links.viewport](const glm::dvec3& place) {
                         if (thresholds->subject()) showPlace(viewport, *thresholds->subject(), place);
                     });
}

/// The scenes of the text as it was read last.
SweepPanel::Source sweepSource(const SceneSession* session, const SourceRange& number) {
    const std::shared_ptr<const ParseResult> result = session->result();
    if (!result || !result->ok()) return {};
    const std::vector<SceneParameter>& known = result->scene->parameters;
    const auto found = std::ranges::find_if(known, [&](const SceneParameter& one) {
        return one.range.file == number.file && one.range.begin == number.begin &&
               one.range.end == number.end;
    });
    if (found == known.end()) return {};
    const auto index = static_cast<std::size_t>(found - known.begin());
    std::string others((*result->sources)[0].text());
    others.erase(number.begin, number.end - number.begin);
    return {[result, index](double value) {
                const NumberSetting setting{index, value};
                return sceneWithNumbers(*result, {&setting, 1});
            },
            std::move(others)};
}

void connectSweep(SweepPanel* sweep, const StudyLinks& links) {
    sweep->setReader(
        [session = links.session](const SourceRange& number) { return sweepSource(session, number); });
    QObject::connect(sweep, &SweepPanel::valueRequested, links.parameters,
                     [parameters = links.parameters](const SceneParameter& number, double value) {
                         ParameterSlider* row = parameters->sliderAt(number.range);
                         if (!row) return;
                         row->moveTo(value);
                         row->settle();
                     });
}

void connectRepair(RepairPanel* repair, const StudyLinks& links) {
    repair->setSceneFile([session = links.session] { return session->file(); });
    QObject::connect(repair, &RepairPanel::repairRequested, links.repairer, &SceneRepairer::repair);
    // Places in include files open as those of Problems do.
    QObject::connect(repair, &RepairPanel::placeRequested, links.problems, &ProblemsPanel::activated);
}

/// The text as it was read last; null while the editor's is newer.
std::function<std::shared_ptr<const ParseResult>()> textReader(const StudyLinks& links) {
    return [session = links.session, editor = links.editor]() -> std::shared_ptr<const ParseResult> {
        if (session->resultRevision() != editor->revision()) return nullptr;
        return session->result();
    };
}

void connectReport(ReportPanel* report, const StudyLinks& links) {
    report->setReader(textReader(links));
    QObject::connect(report, &ReportPanel::fixRequested, links.fixer,
                     [fixer = links.fixer](const QuickFix& fix) { fixer->apply({fix}); });
    QObject::connect(report, &ReportPanel::placeRequested, links.viewport,
                     [report, viewport = links.viewport](const glm::dvec3& place) {
                         if (report->subject()) showPlace(viewport, *report->subject(), place);
                     });
}

void connectFormula(FormulaPanel* formula, const StudyLinks& links) {
    formula->setReader(textReader(links));
    QObject::connect(formula, &FormulaPanel::fixRequested, links.fixer,
                     [fixer = links.fixer](const QuickFix& fix) { fixer->apply({fix}); });
}

void connectEvaluate(EvaluatePanel* evaluate, const StudyLinks& links) {
    QObject::connect(evaluate, &EvaluatePanel::evaluateRequested, links.settings,
                     &SettingWriter::setEvaluate);
    QObject::connect(evaluate, &EvaluatePanel::gradientRequested, links.settings,
                     &SettingWriter::setMaxGradient);
}

void connectSheet(SheetPanel* sheet, const StudyLinks& links) {
    sheet->setReader(textReader(links));
    QObject::connect(
        sheet, &SheetPanel::valuesRequested, links.parameters,
        [parameters = links.parameters, editor = links.editor](const QList<SheetPanel::Setting>& values) {
            // One step for undo, however many numbers.
            editor->beginDrag();
            for (const auto& [number, value] : values)
                if (ParameterSlider* row = parameters->sliderAt(number.range)) {
                    row->moveTo(value);
                    row->settle();
                }
            editor->endDrag();
        });
}

void connectAccuracy(AccuracyPanel* accuracy, const StudyLinks& links) {
    QObject::connect(accuracy, &AccuracyPanel::settingRequested, links.settings,
                     [settings = links.settings](StudiedSetting setting, double value) {
                         settings->setForAll(setting == StudiedSetting::accuracy ? ParameterRole::accuracy
                                                                                 : ParameterRole::maxGradient,
                                             value);
                     });
}

/// What the hole map says about the pixel whose ray is shown.
void tellPictured(RayPanel* ray, const HoleMap& map) {
    const auto& place = ray->pixel();
    if (!place || !map.complete || map.pixels.empty()) return ray->setPictured({});
    const int x = std::clamp(static_cast<int>(place->x() * map.width), 0, map.width - 1);
    const int y = std::clamp(static_cast<int>(place->y() * map.height), 0, map.height - 1);
    ray->setPictured(map.pixels[static_cast<std::size_t>(y) * static_cast<std::size_t>(map.width) +
                                static_cast<std::size_t>(x)]);
}

void connectRay(RayPanel* ray, const StudyLinks& links) {
    Viewport* viewport = links.viewport;
    Docks* docks = links.docks;
    QObject::connect(links.actions->inspectRay, &QAction::toggled, ray, [viewport, docks](bool on) {
        viewport->setPicking(on);
        if (!on) return viewport->setPicked({});
        docks->bringUp(docks->find("ray"));
    });
    QObject::connect(viewport, &Viewport::picked, ray, [ray, viewport, docks](QPointF place) {
        viewport->setPicked(place);
        ray->setPixel(place);
        tellPictured(ray, viewport->overlay().holes());
        docks->bringUp(docks->find("ray"));
    });
    QObject::connect(&viewport->overlay(), &ViewOverlay::changed, ray,
                     [ray, viewport] { tellPictured(ray, viewport->overlay().holes()); });
}

void connectEffects(EffectsPanel* effects, const StudyLinks& links) {
    Viewport* viewport = links.viewport;
    QObject::connect(viewport, &Viewport::progressed, effects, &EffectsPanel::show);
    QObject::connect(viewport, &Viewport::movingSecondsChanged, effects, &EffectsPanel::setMovingSeconds);
    QObject::connect(effects, &EffectsPanel::leftOutChanged, viewport, &Viewport::setLeftOut);
    QObject::connect(effects, &EffectsPanel::movingSecondsChanged, viewport, &Viewport::setMovingSeconds);
}

}  // namespace

StudyPanels::StudyPanels()
    : entries_{
          row("section", Words::tr("Cross-section"),
              Words::tr("<p>The function on a plane: blue is inside the solid, orange outside, the bold line "
                        "is the "
                        "surface.</p>"),
              connectSection),
          row("gradient", Words::tr("Gradient"),
              Words::tr("<p>How steep the function is, and what max_gradient has to be for a picture without "
                        "holes: with proof.</p>"),
              connectGradient),
          row("histogram", Words::tr("Histogram"),
              Words::tr("<p>How much of the container and of the surface is how steep: where a smaller "
                        "max_gradient would begin to lose pixels.</p>"),
              connectHistogram),
          row("levels", Words::tr("Levels"),
              Words::tr(
                  "<p>How often the function takes which value, and the thresholds at which pieces of the "
                  "surface appear, join or get tunnels: with proof.</p>"),
              connectThresholds),
          row("accuracy", Words::tr("Accuracy"),
              Words::tr("<p>What accuracy and max_gradient cost in time, and lose in pixels, over a range of "
                        "values.</p>"),
              connectAccuracy),
          closedAtFirst(row(
              "sweep", Words::tr("Sweep"),
              Words::tr(
                  "<p>What the values of a number cost in evaluations, how steep they make the function, and "
                  "into how many pieces, tunnels and hollows: over a range of values.</p>"),
              connectSweep)),
          closedAtFirst(row(
              "repair", Words::tr("Repair"),
              Words::tr("<p>Every isosurface of the scene and its include files: what its max_gradient is "
                        "worth, and what it should be, with proof; one click writes what is ticked.</p>"),
              connectRepair)),
          closedAtFirst(row(
              "report", Words::tr("Report"),
              Words::tr(
                  "<p>What the solid is like: pieces, tunnels, extent, volume, area, walls and symmetry, in "
                  "sentences; and the health of the function: where it has no value, bound, slope or "
                  "digits.</p>"),
              connectReport)),
          closedAtFirst(
              row("sheet", Words::tr("Sheet"),
                  Words::tr(
                      "<p>The scene in small for values of one number, or of two, as one picture; a click on "
                      "one of them sets its values.</p>"),
                  connectSheet)),
          closedAtFirst(row(
              "formula", Words::tr("Formula"),
              Words::tr("<p>Quicker or more exact ways to write the function, each with its proof; and its "
                        "derivatives, with a function whose gradient is 1 on the surface, as text.</p>"),
              connectFormula)),
          closedAtFirst(row(
              "evaluate", Words::tr("Evaluate"),
              Words::tr("<p>Whether evaluate pays for an isosurface in this view, and with which numbers: "
                        "measured cost and lost pixels of each.</p>"),
              connectEvaluate)),
          row("ray", Words::tr("Ray"),
              Words::tr(
                  "<p>The function along the line of sight through one pixel: where the surface is met, and "
                  "what POV-Ray stepped over.</p>"),
              connectRay),
          row("effects", Words::tr("Effects"),
              Words::tr("<p>What the picture is made of, what each part costs, and switches for them.</p>"),
              connectEffects),
      } {}

}  // namespace isoscope
