// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <glm/vec3.hpp>
#include <string_view>
#include <vector>

#include "core/numeric/interval.h"
#include "core/study/gradient/gradient_domain.h"

namespace isoscope {

/// What a critical point is: how many directions the function falls in.
enum class CriticalKind : std::uint8_t {
    minimum,  ///< 0
    saddle1,  ///< 1
    saddle2,  ///< 2
    maximum,  ///< 3
    saddle,   ///< some, not known how many
    unknown,
};

/// Why a place is only suspected; `none` for what is proven.
enum class SuspicionReason : std::uint8_t {
    none,
    unfinished,  ///< the work ended before the place was small
    wall,        ///< there is such a point, at the container's wall: it may lie outside
    flat,        ///< the function is constant there
    degenerate,  ///< the second derivatives do not tell: a line of such points, or several at one place
    kink,        ///< not known to be twice differentiable there (abs, min, max, roots, noise)
    steep,       ///< the gradient has no bound there: a pole, an edge or a jump
};

/// A point where the gradient is 0, or a place where it may be. In the coordinates of the function.
struct CriticalPoint {
    glm::dvec3 place{0};  ///< of a suspected place, a point of it
    GradientBox box;      ///< proven: holds exactly one such point; suspected: around the whole place
    double value = 0;     ///< at `place`; NaN where there was no time to ask for it
    Interval values;      ///< proven: encloses the value at the point; suspected: all values of the place
    /// Of what is suspected, a guess by samples.
    CriticalKind kind = CriticalKind::unknown;
    SuspicionReason reason = SuspicionReason::none;

    /// Whether there is exactly one critical point in `box`, of that kind, inside the container.
    bool proven() const { return reason == SuspicionReason::none; }
};

/// All that is known of the critical points inside a container, by ascending values.
struct CriticalPoints {
    /// All proven ones, and places for all others that there may be; what is not listed has none. This holds
    /// at any time.
    std::vector<CriticalPoint> points;
    std::uint64_t boxes = 0;  ///< that were looked at
    double share = 1;         ///< of the container's box, by volume, that is still to be looked at
    bool jumps = false;       ///< the function may jump: surfaces change there without a critical point
    bool finished = false;    ///< there is nothing left to look at: longer work tells no more
};

/// For output: "minimum", "saddle-1", "saddle-2", "maximum", "saddle", "unknown".
std::string_view name(CriticalKind kind);
/// For output: "" for none, else the enumerator's name.
std::string_view name(SuspicionReason reason);

/// What happens to the solid when the threshold rises past the value of such a point, in a phrase; with
/// `positivePolarity` the solid is where the function is larger, and it happens when the threshold falls.
std::string_view meaning(CriticalKind kind, bool positivePolarity);

}  // namespace isoscope
