// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

#include "core/study/view/povray_comparison.h"
#include "widgets/viewport/legend.h"

namespace isoscope {

/// "POV-Ray's picture differs in 312 of 60000 pixels: 300 holes, 12 outlines", or that it does not.
QString povraySummary(const PovrayComparison& comparison);

/// What the colours of picture() mean, with counts; causes without pixels are left out.
QList<LegendEntry> povrayLegend(const PovrayComparison& comparison);

}  // namespace isoscope
