// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>

#include "core/roots/certified/march_kernel.h"

namespace isoscope {

/// What the kernels of MarchKernel need to know of an isosurface.
struct PlainMarchRules {
    SignRule sign;
    double accuracy;
    bool open;
    double sufficient;
    bool brackets;
};

/// Some lines that MarchKernel marches along; the rays are only read.
struct MarchRows {
    std::array<double*, MarchKernel::originX> state;  ///< MarchKernel::Column
    std::array<const double*, 6> ray;                 ///< origin and direction
};

}  // namespace isoscope
