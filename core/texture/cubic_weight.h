// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>

namespace isoscope {

/// The weight of a sample so far away, in steps between samples, on Catmull and Rom's spline.
inline double cubicWeight(double away) {
    const double t = std::abs(away);
    if (t >= 2) return 0;
    return t < 1 ? (1.5 * t - 2.5) * t * t + 1 : ((-0.5 * t + 2.5) * t - 4) * t + 2;
}

}  // namespace isoscope
