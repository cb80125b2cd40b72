// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/desktop/studies/study_panels.h"

#include <QCoreApplication>

#include "widgets/section/section_panel.h"
#include "widgets/studies/accuracy_panel.h"
#include "widgets/studies/effects_panel.h"
#include "widgets/studies/gradient_panel.h"
#include "widgets/studies/histogram_panel.h"
#include "widgets/studies/ray_panel.h"

namespace isoscope {

namespace {

QString tr(const char* text) { return QCoreApplication::translate("StudyPanels", text); }

}  // namespace

StudyPanels::StudyPanels()
    : entries_{
          {"section", tr("Cross-section"),
           tr("<p>The function on a plane: blue is inside the solid, orange outside, the bold line is the "
              "surface.</p>"),
           new SectionPanel},
          {"gradient", tr("Gradient"),
           tr("<p>How steep the function is, and what max_gradient has to be for a picture without holes: "
              "with "
              "proof.</p>"),
           new GradientPanel},
          {"histogram", tr("Histogram"),
           tr("<p>How much of the container and of the surface is how steep: where a smaller max_gradient "
              "would "
              "begin to lose pixels.</p>"),
           new HistogramPanel},
          {"accuracy", tr("Accuracy"),
           tr("<p>What accuracy and max_gradient cost in time, and lose in pixels, over a range of "
              "values.</p>"),
           new AccuracyPanel},
          {"ray", tr("Ray"),
           tr("<p>The function along the line of sight through one pixel: where the surface is met, and what "
              "POV-Ray stepped over.</p>"),
           new RayPanel},
          {"effects", tr("Effects"),
           tr("<p>What the picture is made of, what each part costs, and switches for them.</p>"),
           new EffectsPanel},
      } {}

}  // namespace isoscope
