// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <optional>
#include <string>

#include "core/evaluate/algebra/interval_gradient.h"

namespace isoscope {

/// A place where no max_gradient is large enough, or none is known to be.
struct GradientSingularity {
    GradientHazard kind = GradientHazard::none;
    glm::dvec3 place{0};
};

/// How far a gradient study has come.
enum class GradientState : std::uint8_t {
    running,
    tight,      ///< the bracket is as narrow as was asked for
    unbounded,  ///< there is a singularity; both ends are infinite
    unproven,   ///< the budget is spent, or a jump can neither be found nor excluded
    stopped,    ///< on request
};

/// No slope that counts: more than what rounding outwards leaves of 0.
constexpr double negligibleSlope = 1e-30;

/// What is known of the largest |grad f| beside the places where it is infinite: beside jumps, up to them; of
/// the others small boxes are left out.
struct GradientBeside {
    double lower = 0;  ///< attained at `place`, rounding included
    /// Nothing that is not left out is steeper; infinite while nothing is proven.
    double upper = std::numeric_limits<double>::infinity();
    glm::dvec3 place{0};
    GradientState state = GradientState::running;
    double reach = 0;  ///< the longest edge of a box that is left out; 0 when none is
    double share = 0;  ///< the part of the container's box that is left out

    /// The smallest round value at or above `upper`; 0 for what rounding outwards leaves of no slope at all.
    double suggested() const;
};

/// What is known of the largest |grad f| over a container.
struct GradientBracket {
    double lower = 0;  ///< attained at `place`, rounding included
    /// No point of the container has a longer gradient; infinite while nothing is proven. With `seams` this
    /// holds beside places where the function may jump.
    double upper = std::numeric_limits<double>::infinity();
    glm::dvec3 place{0};
    GradientState state = GradientState::running;
    bool seams = false;  ///< a jump is not excluded (yet, while running)
    /// Proven when the state is `unbounded`; else, when `upper` is infinite, a place where no bound was
    /// found.
    std::optional<GradientSingularity> singularity;
    std::optional<GradientBeside> beside;  ///< once a singularity is proven, or the study ended at one
    std::uint64_t boxes = 0;               ///< boxes evaluated

    /// Whether no more is going to be known.
    bool settled() const {
        return state != GradientState::running && !(beside && beside->state == GradientState::running);
    }
    /// (upper - lower) / lower; 0 for functions without slope.
    double relativeWidth() const;
};

/// The smallest number of two significant digits at or above `bound`, up to rounding (a relative 1e-12); 0
/// for numbers that are not positive and finite.
double roundValueAbove(double bound);

/// "pole", "jump", ...
std::string_view name(GradientHazard hazard);
std::string_view name(GradientState state);

/// What to do about an infinite gradient of this kind, one sentence.
std::string_view advice(GradientHazard hazard);

}  // namespace isoscope
