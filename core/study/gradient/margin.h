// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <glm/vec3.hpp>
#include <span>

#include "core/numeric/slope_range.h"
#include "core/study/gradient/gradient_domain.h"

namespace isoscope {

/// By how much a piece of a function is taken rather than another one: where it is below 0, the piece is not
/// the function.
struct Margin {
    double at;  ///< at most this at the point from which a box is looked at
    std::array<SlopeRange, 3> slope;
};

/// An upper bound of how much a value grows from the point `from` on, in the part of `box` and of the domain
/// where no margin is below 0. `slope`: the slopes of the value.
double growthWithin(std::span<const Margin> margins, const std::array<SlopeRange, 3>& slope,
                    const GradientDomain& domain, const GradientBox& box, const glm::dvec3& from);

}  // namespace isoscope
