// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/gradient/margin.h"

#include <cmath>

namespace isoscope {

double growthWithin(std::span<const Margin> margins, const std::array<SlopeRange, 3>& slope,
                    const GradientDomain& domain, const GradientBox& box, const glm::dvec3& from) {
    std::array<SlopeRange, 3> change = slope;
    double grown = domain.advance(change, box, from), added = 0;
    // What is not below 0 may be added, times any factor: with Lagrange's the growth towards the edge of the
    // piece is gone.
    for (const Margin& margin : margins) {
        double along = 0, squares = 0;
        for (std::size_t i = 0; i < 3; ++i) {
            const double slopeInMiddle = 0.5 * margin.slope[i].low + 0.5 * margin.slope[i].high;
            along += (0.5 * change[i].low + 0.5 * change[i].high) * slopeInMiddle;
            squares += slopeInMiddle * slopeInMiddle;
        }
        const double factor = -along / squares;
        if (!(factor > 0) || !std::isfinite(factor)) continue;
        std::array<SlopeRange, 3> next;
        for (std::size_t i = 0; i < 3; ++i) next[i] = change[i] + factor * margin.slope[i];
        const double start = raised(added + raised(factor * margin.at));
        const double less = raised(start + domain.advance(next, box, from));
        if (!(less < grown)) continue;
        grown = less;
        added = start;
        change = next;
    }
    return grown;
}

}  // namespace isoscope
