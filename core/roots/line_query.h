// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <vector>

namespace isoscope {

/// The part origin + t direction, near <= t <= far, of a line; `near` is not negative. Empty when near > far.
struct LineQuery {
    glm::dvec3 origin{0};
    glm::dvec3 direction{0, 0, 1};
    double near = 0;
    double far = -1;
    /// A line that begins on the surface may meet it there again: what it meets before this t is no root of
    /// those that max_trace allows.
    double countsFrom = 0;
};

/// What a root finder has found at a parameter of a line.
enum class RootKind : std::uint8_t {
    crossing,
    entryWall,  ///< the container where the line enters it
    exitWall,   ///< the container where the line leaves it
    jump,
    pole,
};

/// Where a line meets a surface: at origin + t direction of its LineQuery.
struct Root {
    double t = 0;
    RootKind kind = RootKind::crossing;

    friend bool operator==(const Root&, const Root&) = default;
};

/// Roots of one line in order of t.
using RootList = std::vector<Root>;

}  // namespace isoscope
