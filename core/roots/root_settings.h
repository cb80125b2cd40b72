// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <glm/vec3.hpp>
#include <optional>

namespace isoscope {

/// A box of space.
struct LineRegion {
    glm::dvec3 low{0}, high{0};
};

/// What a root finder needs to know of an isosurface (docs/povray/isosurface.md, section 2).
struct RootSettings {
    double threshold = 0;
    double accuracy = 0.001;
    double maxGradient = 1.1;
    bool open = false;
    int maxTrace = 1;               ///< 1 to 10; all_intersections is 10
    bool positivePolarity = false;  ///< 3.8: inside is where f > threshold
    /// P0, P1, P2 of `evaluate`: the bound on the gradient moves between the rays. It begins with
    /// maxGradient, not with P0, as measured on POV-Ray.
    std::optional<std::array<double, 3>> evaluate;
    /// What the intervals of most lines lie in, if that is known: finders keep what they find out of its
    /// parts from one list of lines to the next.
    std::optional<LineRegion> region;

    /// The settings as POV-Ray would use them: an accuracy or max_gradient that is not positive (or not a
    /// number) gets its default, max_trace lies between 1 and 10. A P1 below 1 and a P2 outside (0, 1] become
    /// 1: they would let the bound run away.
    RootSettings usable() const;

    /// g of docs/povray/solver.md: negative inside.
    double signedValue(double value) const {
        return positivePolarity ? threshold - value : value - threshold;
    }
};

}  // namespace isoscope
