// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace isoscope {

/// The intervals that up to 64 searches are halving, side by side: entry k of every array belongs to lane k.
/// Values are h = sign (f - threshold), as on the page docs/povray/solver.md.
struct HalvingState {
    static constexpr std::size_t laneLimit = 64;
    using Lanes = std::array<double, laneLimit>;

    alignas(64) Lanes start{};
    alignas(64) Lanes startValue{};
    alignas(64) Lanes end{};
    alignas(64) Lanes endValue{};
    alignas(64) Lanes reach{};   ///< L: how far f could move over the interval
    alignas(64) Lanes wanted{};  ///< where the next value is needed: the middle
    alignas(64) Lanes lowest{};  ///< smallest value at the right end of an interval since the search began
    alignas(64) Lanes sign{};    ///< +1 or -1; polarity included
    alignas(64) Lanes speed{};   ///< |d|

    /// Written by a step: the right end of the interval before, for the lanes that put its right half aside.
    alignas(64) Lanes asideEnd{};
    alignas(64) Lanes asideEndValue{};

    // The lines, and the points of `wanted` on them.
    std::array<Lanes, 3> origin{};
    std::array<Lanes, 3> direction{};
    alignas(64) std::array<Lanes, 3> point{};
};

/// What is the same for all lanes during a step.
struct HalvingLimits {
    double threshold = 0;
    double accuracy = 0;
    double noteworthy = 0;  ///< slopes up to here change nothing
};

/// What has become of the lanes in a step; bit k is lane k. A lane in none of the masks goes on with one half
/// while the other one holds no root.
struct HalvingStep {
    std::uint64_t bothHalves = 0;  ///< goes on with the left half; the right one must be looked at later
    std::uint64_t neitherHalf = 0;
    /// A slope to be noted or a root: left as it was (but for `lowest`), for the exact rules to deal with.
    std::uint64_t special = 0;
};

/// Carries lanes [0, count) one step on, given f at `wanted`: what LipschitzLanes::examine would decide about
/// the left and then the right half, with vector instructions. NaN ends an interval.
HalvingStep halve(HalvingState& state, const double* values, std::size_t count, const HalvingLimits& limits);

/// Computes the points of lanes [0, count).
void placePoints(HalvingState& state, std::size_t count);

}  // namespace isoscope
