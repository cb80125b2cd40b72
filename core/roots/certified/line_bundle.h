// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <glm/vec3.hpp>
#include <optional>
#include <span>

#include "core/evaluate/affine_evaluator.h"
#include "core/roots/line_columns.h"
#include "core/roots/line_query.h"

namespace isoscope {

/// A piece of the depth along a bundle of lines.
struct DepthRange {
    double near = 0, far = -1;

    /// Number `k` of `count` equal parts; adjacent ones meet exactly.
    DepthRange part(std::size_t k, std::size_t count) const {
        return {border(k, count), border(k + 1, count)};
    }
    /// Where part `k` of `count` begins; border(count, count) is `far` to the last bit.
    double border(std::size_t k, std::size_t count) const {
        if (k == count) return far;
        return near + (far - near) * static_cast<double>(k) / static_cast<double>(count);
    }
};

/// Several lines seen as one with a spread: origin +- originSpread + t (direction +- directionSpread) holds
/// every line, rounded outwards, and [near, far] the interval of each.
struct LineBundle {
    glm::dvec3 origin{0}, originSpread{0};
    glm::dvec3 direction{0}, directionSpread{0};
    double near = 0, far = -1;

    /// The bundle around those lines that are wanted. Nothing when there is none, or when they are not
    /// finite.
    static std::optional<LineBundle> around(std::span<const LineQuery> queries,
                                            std::span<const std::uint8_t> wanted);
    /// The bundle around those of `count` lines from `first` on whose interval is not empty.
    static std::optional<LineBundle> around(const LineColumns& lines, std::size_t first, std::size_t count);

    double width = 0;  ///< where it ends, in units of t

    /// Writes rays and spread to a lane; the piece is left to the caller.
    void place(std::size_t lane, RayPieces& pieces, RaySpread& spread) const;
};

}  // namespace isoscope
