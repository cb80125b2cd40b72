// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <span>
#include <vector>

#include "core/function/function_graph.h"

namespace isoscope {

/// `linear_spline`, `quadratic_spline`, `cubic_spline` and `natural_spline`.
enum class SplineType { linear, quadratic, cubic, natural };

/// A curve of 2 to 5 components through points at given places, as `spline { ... }` of the scene language
/// makes it; the formulas are those of docs/povray/operators.md, section 6. Immutable.
class Spline {
  public:
    using Vector = std::array<double, 5>;
    /// One control point; of `value` the first components() count.
    struct Point {
        double place = 0;
        Vector value{};
    };

    /// Points in any order; of several at one place the last counts. Numbers that are not finite make values
    /// that are not. At least one point, and `components` from 1 to 5.
    Spline(SplineType type, std::vector<Point> points, int components);

    /// As given to the constructor; the points are sorted by place, one for each place.
    SplineType type() const { return type_; }
    const std::vector<Point>& points() const { return points_; }
    int components() const { return components_; }

    /// The value there; those beyond components() mean nothing. Outside of the points it is that of the
    /// nearer end; a cubic spline ends at its second and its last but one point.
    Vector at(double place) const;
    /// The components as nodes of a graph, for the place `place` in it.
    std::vector<NodeId> build(FunctionGraph& graph, NodeId place) const;

  private:
    /// Up to and including `end`: a + b d + c d^2 + e d^3 with d = place - origin.
    struct Piece {
        double end = 0;
        double origin = 0;
        std::array<Vector, 4> coefficients{};
    };

    double gap(std::size_t i) const { return points_[i + 1].place - points_[i].place; }
    /// Of the straight line from point i to the next.
    double slope(std::size_t i, std::size_t component) const;
    void addConstant(double end, const Vector& value);
    void makeLinear();
    void makeQuadratic();
    void makeCubic();
    void makeNatural();
    /// The second derivatives of a natural spline at the points.
    std::vector<double> bends(std::size_t component) const;
    NodeId build(FunctionGraph& graph, NodeId place, std::size_t component, std::size_t first,
                 std::size_t last) const;

    SplineType type_;
    std::vector<Point> points_;
    int components_;
    std::vector<Piece> pieces_;
};

}  // namespace isoscope
