// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "core/evaluate/affine_evaluator.h"
#include "core/roots/certified/line_bundle.h"
#include "core/roots/line_columns.h"
#include "core/roots/line_query.h"

namespace isoscope {

/// Lines that follow each other.
struct LineRange {
    std::size_t first = 0, count = 0;
};

/// Up to batchLanes bundles of lines side by side (LineBundle): entry k of every array belongs to bundle k.
/// Where near >= far there is no bundle: no line is wanted, or they are not finite.
struct BundleLanes {
    using Lanes = std::array<double, batchLanes>;

    std::array<Lanes, 3> origin, originSpread;
    std::array<Lanes, 3> direction, directionSpread;
    Lanes near, far;
    Lanes width;

    /// Bundle k becomes the one around the wanted lines of ranges[k].
    void enclose(std::span<const LineQuery> queries, std::span<const std::uint8_t> wanted,
                 std::span<const LineRange> ranges);
    /// Bundle k becomes the one around those lines of ranges[k] whose interval is not empty.
    void enclose(const LineColumns& lines, std::span<const LineRange> ranges);

    LineBundle operator[](std::size_t k) const;
    /// Writes rays and spread of bundle k to a lane; the piece is left to the caller.
    void place(std::size_t k, std::size_t lane, RayPieces& pieces, RaySpread& spread) const;
};

}  // namespace isoscope
