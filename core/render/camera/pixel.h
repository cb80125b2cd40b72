// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>

namespace isoscope {

/// A pixel, counted from the top left.
struct PixelIndex {
    int x = 0, y = 0;
};

/// Red, green and blue of linear light.
using LinearColor = std::array<float, 3>;

}  // namespace isoscope
