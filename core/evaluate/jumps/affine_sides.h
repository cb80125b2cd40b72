// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "core/evaluate/tape/tape_workspace.h"

namespace isoscope {

/// Enclosures of functions with jumps (hasSides()) on the sides that hold at one place of a piece of a ray.
/// Every jump takes the side that its operand is on there, all over the piece, and tells where that may end:
/// one evaluation encloses the function up to its first jump. A side is the number of a step, or 1 above what
/// the operand jumps at and 0 below. Numbers s run from -1 at the start of the piece
/// to 1 at its end. Lane by lane.
struct SideLanes {
    using Lanes = std::array<double, batchLanes>;

    /// `low` and `high` where no side ends on the piece.
    static constexpr double beyond = 2;
    static constexpr double noJump = -1;

    // By the numbers of the instructions; made by the first evaluation.
    std::vector<std::uint32_t> jumpOf;  ///< numberJumps()
    std::vector<bool> isWhole;          ///< those of findWholeNumbers()

    // To be set before the evaluation.
    Lanes readAt;  ///< where the sides are read; what lies before counts as being on these sides as well
    Lanes grain;   ///< what cannot be told apart, in s
    Lanes toldJump, toldSide;  ///< the side of this jump is not read; noJump for lanes without one

    // The answer. Between readAt and `low` all sides hold.
    Lanes low, high;           ///< the first side that ends on the piece does so here
    Lanes nextJump, nextSide;  ///< that jump, and the side behind it
    Lanes open;     ///< not 0 where a side cannot be read: the form holds what the function has on all of its
                    ///< sides
    Lanes blind;    ///< not 0 where nothing can be said of the piece
    Lanes crowded;  ///< not 0 where sides of several jumps end between low and high, beyond the grain

    std::vector<bool> seen;  ///< the evaluator's: jumps of the instructions so far
};

}  // namespace isoscope
