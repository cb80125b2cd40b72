// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/roots/polynomial/wide_number.h"

#include <cmath>

namespace isoscope {

Wide squareRoot(Wide a) {
    const auto start = static_cast<double>(a);
    if (!(a > 0)) return a == 0 ? Wide(0) : Wide(std::nan(""));
    Wide root = std::sqrt(start);
    // Heron's rule doubles the 53 good bits twice; a start that under- or overflowed has none to double.
    if (start > 0 && std::isfinite(start))
        for (int step = 0; step < 2; ++step) root = (root + a / root) / 2;
    return root;
}

}  // namespace isoscope
