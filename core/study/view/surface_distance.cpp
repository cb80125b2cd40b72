// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/view/surface_distance.h"

#include <cmath>
#include <limits>

namespace isoscope {

double slopeOf(const ValueAndGradient& at) {
    if (std::isnan(at.value)) return std::numeric_limits<double>::quiet_NaN();
    const double length = std::hypot(at.gradient[0], at.gradient[1], at.gradient[2]);
    return length >= GradientEvaluator::steepest ? std::numeric_limits<double>::infinity() : length;
}

double surfaceDistance(double height, double slope) { return height == 0 && slope == 0 ? 0 : height / slope; }

}  // namespace isoscope
