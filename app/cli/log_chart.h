// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <string>
#include <vector>

#include "core/render/image.h"

namespace isoscope::cli {

/// A line of a chart; color is RGB from 0 to 1.
struct ChartLine {
    std::array<float, 3> color{};
    std::vector<std::array<double, 2>> points;  ///< in order of x; what is not positive is left out
};

/// Lines over logarithmic axes with a grid at the powers of ten, their exponents beside it. Empty lines give
/// an empty frame.
Image drawLogChart(const std::vector<ChartLine>& lines, int width, int height);

}  // namespace isoscope::cli
