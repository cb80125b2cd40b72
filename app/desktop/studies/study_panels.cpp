// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/desktop/studies/study_panels.h"

#include <algorithm>
#include <QAction>
#include <QCoreApplication>
#include <QDockWidget>
#include <QMap>

#include "app/desktop/editing/setting_writer.h"
#include "app/desktop/window/actions.h"
#include "app/desktop/window/docks.h"
#include "widgets/section/section_panel.h"
#include "widgets/studies/accuracy_panel.h"
#include "widgets/studies/effects_panel.h"
#include "widgets/studies/gradient_panel.h"
#include "widgets/studies/histogram_panel.h"
#include "widgets/studies/ray_panel.h"
#include "widgets/viewport/viewport.h"

namespace isoscope {

namespace {

struct Words {
    Q_DECLARE_TR_FUNCTIONS(StudyPanels)
};

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
    QObject::connect(links.panels->get<GradientPanel>(), &GradientPanel::reported, histogram,
                     &HistogramPanel::show);
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
          row("accuracy", Words::tr("Accuracy"),
              Words::tr("<p>What accuracy and max_gradient cost in time, and lose in pixels, over a range of "
                        "values.</p>"),
              connectAccuracy),
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
