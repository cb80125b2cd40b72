// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QColor>
#include <QImage>
#include <QString>

#include "core/study/gradient/gradient_heat_map.h"

class QPainter;
class QRect;

namespace isoscope {

/// The colour of |grad f| / max_gradient: from dark blue at 0 over green to pale yellow at 1. What is above 1
/// stands out in red, the brighter the steeper. Invalid for NaN.
QColor heatColor(double share);

/// Opaque where a surface is seen, a dimming veil elsewhere.
QImage heatImage(const GradientHeatMap& map);

/// "Gradient here: up to 2.18 times max_gradient, over it in 5120 of 60000 pixels".
QString heatSummary(const GradientHeatMap& map);

/// Draws the scale of heatColor() into the lower left corner of `area`; returns the part of the area above
/// it.
QRect paintHeatScale(QPainter& painter, const QRect& area, const GradientHeatMap& map);

}  // namespace isoscope
