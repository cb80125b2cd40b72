// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <string>
#include <vector>

namespace isoscope {

/// One direction of a NURBS surface: its degree plus one, and the knots, as many as points plus order.
struct KnotVector {
    int points = 0;
    int order = 0;
    std::vector<double> knots;

    /// What is wrong with it, a sentence; empty when nothing is.
    std::string problem() const;
    /// Where the basis functions add up to 1.
    double low() const { return knots[static_cast<std::size_t>(order) - 1]; }
    double high() const { return knots[static_cast<std::size_t>(points)]; }
    /// The values (or slopes) at `t`, from low() to high(), of the `order` basis functions that are not 0
    /// there, by the recursion of Cox and de Boor; `first` becomes the number of the first one.
    std::vector<double> basis(double t, int& first) const;
    std::vector<double> slopes(double t, int& first) const;

    static constexpr int orderLimit = 32;

  private:
    int spanAt(double t) const;
    std::vector<double> basisOfOrder(double t, int span, int wanted) const;
};

/// A rational B-spline surface: sum of w N_i(u) N_j(v) P over sum of w N_i(u) N_j(v). The first three numbers
/// of a point are its place, not multiplied by the weight, which is the fourth.
struct NurbsSurface {
    KnotVector u, v;
    std::vector<glm::dvec4> points;  ///< point (i, j) is number i * v.points + j

    /// A point of the surface with its tangents, which may be 0 where the surface is folded up in a point.
    struct Place {
        glm::dvec3 point{0};
        glm::dvec3 along{0}, across{0};  ///< derivatives by u and v
    };
    /// (u, v) within the ranges of the knot vectors; both must have no problem().
    Place at(double u, double v) const;
};

}  // namespace isoscope
