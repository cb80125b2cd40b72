// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <span>
#include <vector>

#include "core/roots/polynomial/real_roots.h"

namespace isoscope {

/// How a curve runs through its points, as in the scene language (docs/povray/primitives.md, section 6).
enum class SplineKind { linear, quadratic, cubic, bezier };

/// How many points the shortest curve of a kind has.
int leastPoints(SplineKind kind);

/// c[0] + c[1] u + c[2] u^2 + c[3] u^3 for u in 0..1.
struct CurvePiece {
    std::array<glm::dvec2, 4> c{};
    int degree = 1;

    /// The point and the derivative by u, for any u.
    glm::dvec2 at(double u) const { return c[0] + u * (c[1] + u * (c[2] + u * c[3])); }
    glm::dvec2 slope(double u) const { return c[1] + u * (2.0 * c[2] + u * 3.0 * c[3]); }
    /// Where a.x X(u) + a.y Y(u) = value, u in 0..1.
    void meet(const glm::dvec2& a, double value, RootSequence& roots) const;
    /// Corners of a box around the piece.
    void range(glm::dvec2& low, glm::dvec2& high) const;
};

/// The pieces of a spline (docs/povray/primitives.md, section 6). Too few points make none; of a bezier
/// spline an incomplete last group of four is left out.
std::vector<CurvePiece> curveThrough(SplineKind kind, std::span<const glm::dvec2> points);

/// The region that pieces enclose: points with an odd number of them on their right.
class Outline {
  public:
    /// Takes the pieces in any order; curves need not be closed (see covers()).
    explicit Outline(std::vector<CurvePiece> pieces);

    /// The pieces as given, and the corners of the smallest box around all of them; (0, 0) without any.
    const std::vector<CurvePiece>& pieces() const { return pieces_; }
    const glm::dvec2& low() const { return low_; }
    const glm::dvec2& high() const { return high_; }

    /// False only where CurvePiece::meet finds nothing: the piece's box lies on one side of the line.
    bool mayMeet(std::size_t piece, const glm::dvec2& a, double value) const {
        const Box& box = boxes_[piece];
        const glm::dvec2 size = glm::abs(a);
        // Rounding of both sides, generously.
        const double room = 1e-12 * (glm::dot(size, glm::abs(box.middle) + box.half) + std::abs(value));
        return !(std::abs(glm::dot(a, box.middle) - value) > glm::dot(size, box.half) + room);
    }

    /// Whether curves that are not closed are crossed an odd number of times on the way to x = infinity.
    bool covers(const glm::dvec2& point) const;

  private:
    /// Part of a piece on which y only rises or only falls.
    struct Arc {
        std::size_t piece;
        double from, to;
        double yFrom, yTo;
        double left, right;
    };

    struct Box {
        glm::dvec2 middle, half;
    };

    void addArcs(std::size_t piece);
    void joinLevels();

    std::vector<CurvePiece> pieces_;
    std::vector<Box> boxes_;  ///< of the pieces
    std::vector<Arc> arcs_;
    glm::dvec2 low_{0};
    glm::dvec2 high_{0};
};

}  // namespace isoscope
