// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>

namespace isoscope {

/// The cell points of crackle that can be among the nearest, up to three, of some point of a box.
///
/// Each point of space looks at the 81 cells around its own, so near a cell's wall it may depend on the side
/// whether a point is looked at: the first `always` candidates are from everywhere in the box.
struct CrackleCandidates {
    static constexpr std::size_t most = 48;

    std::size_t count = 0;
    std::size_t always = 0;  ///< at least as many as may be asked for
    std::array<double, most> x, y, z;

    /// Whether all of them are looked at from everywhere in the box.
    bool continuous() const { return always == count; }
};

/// A cube, around which crackleCandidates() looks.
struct CrackleCube {
    std::array<double, 3> center;
    double reach = 0;  ///< half of an edge
};

/// The candidates of a cube are those of the twice as wide cubes around the cells of a lattice: of the finest
/// of these lattices whose cells are as wide as the cube at least.
constexpr std::array<double, 4> crackleEdges{0.5, 0.25, 0.125, 0.0625};

/// No cube with a greater reach has candidates, nor one with a coordinate beyond `crackleExtent`.
constexpr double longestCrackleReach = 0.25;
constexpr double crackleExtent = 1e6;
/// Nor has a metric with a greater exponent, or one less than 1 by this: powers would lose themselves.
constexpr double greatestCrackleMetric = 64;

/// Cubes with a smaller reach hold fewer points, but cost more to find than these points do where places are
/// asked for once or twice.
constexpr double thriftyCrackleReach = 0.1;

/// The cells of the points of a box, along each axis.
struct CrackleCells {
    std::array<std::int64_t, 3> first, last;
};
/// Whether a cell is one of the 81 that the points of a box look at: some of these points, or all.
struct CrackleSight {
    bool ever = false, always = false;
};
/// The cells from which the points between two corners look. Coordinates must have cells of 64 bits.
CrackleCells crackleCells(const std::array<double, 3>& low, const std::array<double, 3>& high);
/// Which of them see a cell point.
CrackleSight crackleSight(const std::array<double, 3>& point, const CrackleCells& cells);

/// What can be one of the `order` (1 to 3) nearest anywhere in a cube that holds the given one. The lists are
/// kept for each thread: costs little where neighbours were asked for before. Valid until the thread asks
/// again. Null for cubes and metrics without candidates, NaN included, and where there are too many.
const CrackleCandidates* crackleCandidates(const CrackleCube& cube, double metric, int order);

/// (x^m + y^m + z^m)^(1/m) of numbers that are not negative.
double crackleNorm(double x, double y, double z, double metric);

}  // namespace isoscope
