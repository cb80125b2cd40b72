// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <string>

#include "core/shapes/isosurface/isosurface.h"

namespace isoscope {

/// Two isosurfaces as one, in POV-Ray's language.
struct DifferenceText {
    std::string text;     ///< an isosurface statement; empty where there is none
    std::string problem;  ///< why not, a sentence
};

/// The isosurface of (f_A - threshold_A) - (f_B - threshold_B), each in its own coordinates: 0 where both
/// functions agree. Its container is the box around both; its max_gradient the sum of both, which is enough
/// where they are.
DifferenceText differenceText(const Isosurface& a, std::span<const double> parametersOfA, const Isosurface& b,
                              std::span<const double> parametersOfB);

}  // namespace isoscope
