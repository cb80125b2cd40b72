// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QColor>
#include <QImage>
#include <QString>

#include "core/study/gradient/hole_map.h"
#include "widgets/viewport/legend.h"

namespace isoscope {

/// What hole maps look like in the viewport.
enum class HoleStyle {
    marks,       ///< over a picture, which is dimmed where nothing is wrong
    difference,  ///< by itself: nothing black, what is right grey
};
QImage holeImage(const HoleMap& map, HoleStyle style);

/// The colour of a kind of mistake in holeImage() and the legend; invalid for pixels that are right.
QColor holeColor(HolePixel pixel);

/// "POV-Ray's method: 312 lost, 0 gained, ...", or that it loses none.
QString holeSummary(const HoleMap& map);

/// What the colours mean, with counts.
QList<LegendEntry> holeLegend(const HoleMap& map);

}  // namespace isoscope
