// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>

#include "core/numeric/crackle_candidates.h"

namespace isoscope {

/// A piece of a ray: center + slope s for s from -1 to 1, each coordinate give or take its error.
struct LinePiece {
    std::array<double, 3> center, slope, error;
    double reach = 0;   ///< no coordinate is further from the center
    double length = 0;  ///< Euclidean, of slope
    double spread = 0;  ///< and of the errors
};

/// A distance along a piece: slope s + [low, high].
struct DistanceLine {
    double slope, low, high;
};

/// The distances along a piece to points that crackle looks at.
struct DistanceLines {
    /// More than what the roundings of a few operations amount to, as a part of the largest number among
    /// them.
    static constexpr double roundings = 1e-14;

    std::size_t count = 0;
    /// Infinite bounds where a distance does not count: no lower one for a point that is too far, no upper
    /// one for one that not all of the piece look at.
    alignas(64) std::array<double, CrackleCandidates::most> slope, low, high;
    std::array<std::size_t, 3> nearest{};  ///< points that are the nearest in the middle, up to the order
};

/// Fills `lines` with Euclidean distances, a fourth coordinate `offset` apart. Points that are further from
/// all of the piece than the `order` (1 to 3) nearest do not count.
void writeEuclideanLines(const LinePiece& piece, const CrackleCandidates& found, double offset,
                         std::size_t order, DistanceLines& lines);

/// The distance of an order (0: the least), along the slope of the one that is in the middle: those of that
/// order of all bounds.
DistanceLine orderedDistance(const DistanceLines& lines, std::size_t order);

}  // namespace isoscope
