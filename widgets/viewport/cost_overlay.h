// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QImage>
#include <QString>

#include "core/study/view/cost_map.h"
#include "widgets/viewport/legend.h"

namespace isoscope {

/// The request as its cost is mapped: with fewer pixels where it has many, for each is traced by itself.
RenderRequest costRequest(RenderRequest request);
/// The same with a sixteenth of the pixels, to be shown first.
RenderRequest coarseCostRequest(RenderRequest request);

/// "Evaluations of f: 24.1 for a pixel, 812 at most", or that there are none.
QString costSummary(const CostMap& map);

/// What the colours of picture() mean, each with its share of all evaluations.
QList<LegendEntry> costLegend(const CostMap& map);

}  // namespace isoscope
