// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/gradient/spread_points.h"

#include <cmath>

namespace isoscope {

SpreadPoints spreadPoints(const GradientDomain& domain, std::size_t count) {
    SpreadPoints points;
    const glm::dvec3 low = domain.box().low, extent = domain.box().high - low;
    for (std::size_t i = 0; i < count; ++i) {
        // Multiples of powers of the plastic number's kin: evenly spread in three dimensions.
        const auto share = [i](double step) {
            return std::fmod(0.5 + static_cast<double>(i + 1) * step, 1.0);
        };
        const glm::dvec3 p = low + extent * glm::dvec3(share(0.8191725133961645), share(0.6710436067037893),
                                                       share(0.5497004779019703));
        if (domain.contains(p)) points.add(p);
    }
    return points;
}

}  // namespace isoscope
