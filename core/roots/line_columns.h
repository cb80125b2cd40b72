// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>

#include "core/roots/line_query.h"

namespace isoscope {

/// Many lines coordinate by coordinate (LineQuery), in memory of the caller: entry k of every column belongs
/// to the same line. The columns go on for `padding` entries, with unspecified numbers, so that whole
/// vectors can be read.
struct LineColumns {
    static constexpr std::size_t padding = 64;

    std::size_t count = 0;
    std::array<const double*, 3> origin{};
    std::array<const double*, 3> direction{};
    const double* near = nullptr;
    const double* far = nullptr;

    LineQuery operator[](std::size_t k) const {
        return {{origin[0][k], origin[1][k], origin[2][k]},
                {direction[0][k], direction[1][k], direction[2][k]},
                near[k],
                far[k]};
    }
};

}  // namespace isoscope
