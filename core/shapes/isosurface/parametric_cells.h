// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <memory>
#include <span>

#include "core/evaluate/gradient_evaluator.h"
#include "core/evaluate/interval_gradient_evaluator.h"
#include "core/shapes/bounds.h"

namespace isoscope {

/// A rectangle of (u, v) with what is proven about the part P of the surface above it.
struct ParametricCell {
    glm::dvec2 low{0}, high{0};
    Bounds box;              ///< around all of P
    glm::dvec3 center{0};    ///< about P in the middle of the rectangle
    double centerError = 0;  ///< how far each coordinate of `center` may be off
    glm::dvec3 slopeU{0};    ///< the derivatives by u are slopeU +- spreadU, those by v slopeV +- spreadV
    glm::dvec3 slopeV{0};
    glm::dvec3 spreadU{0};
    glm::dvec3 spreadV{0};
    bool sloped = false;  ///< whether the derivatives have bounds; without them P may jump
    std::unique_ptr<std::array<ParametricCell, 2>> halves;  ///< kept from an earlier split()

    /// Middle and half widths of the rectangle in u and v.
    glm::dvec2 middle() const { return low + (high - low) / 2.0; }
    glm::dvec2 reach() const { return (high - low) / 2.0; }
};

/// A point of a parametric surface and its derivatives.
struct ParametricPoint {
    glm::dvec3 at{0};
    glm::dvec3 byU{0};
    glm::dvec3 byV{0};
};

/// Encloses parts of the surface (X(u, v), Y(u, v), Z(u, v)) by interval arithmetic. Halves of cells are
/// kept, so that most rays find the cells they need. One object per thread.
class ParametricCells {
  public:
    using Tapes = std::array<std::shared_ptr<const Tape>, 3>;

    ParametricCells(const Tapes& tapes, std::span<const double> parameters, const glm::dvec2& low,
                    const glm::dvec2& high);

    /// The cell of the whole rectangle, from which split() leads to all others; lives as long as this object.
    ParametricCell& root() { return root_; }
    /// The cell cut across its longer side, as long as it appears in space. The answer lies in the cell, or
    /// in `room` once a lot of cells are kept.
    std::array<ParametricCell, 2>& split(ParametricCell& cell, std::array<ParametricCell, 2>& room);
    /// One point of the surface, inside the rectangle or not, computed in doubles without enclosure.
    ParametricPoint point(const glm::dvec2& uv);

    /// Evaluations of cells and points so far.
    std::uint64_t evaluations() const { return evaluations_; }

  private:
    /// Some 20 MB.
    static constexpr std::size_t keptLimit = 50'000;

    ParametricCell enclose(const glm::dvec2& low, const glm::dvec2& high);

    std::vector<IntervalGradientEvaluator> enclosures_;
    std::vector<GradientEvaluator> points_;
    ParametricCell root_;
    std::size_t kept_ = 0;
    std::uint64_t evaluations_ = 0;
};

}  // namespace isoscope
