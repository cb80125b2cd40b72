// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <limits>

#include "core/roots/certified/march_lanes.h"

namespace isoscope {

/// The sign of the function all along a piece whose values lie in center + slope s + [-error, error]: 1
/// outside, -1 inside. 0 where it is not certain; also for forms of nothing known and of no value
/// (AffineForm).
inline int formSign(double center, double slope, double error, const SignRule& rule) {
    constexpr double unit = std::numeric_limits<double>::epsilon();
    const double value = rule.positivePolarity ? rule.threshold - center : center - rule.threshold;
    const double reach =
        std::abs(slope) + error + 4 * unit * (std::abs(center) + std::abs(value) + std::abs(slope));
    if (!(std::abs(error) < std::numeric_limits<double>::infinity()) || !(std::abs(value) > reach)) return 0;
    return value > 0 ? 1 : -1;
}

}  // namespace isoscope
