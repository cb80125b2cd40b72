// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "core/evaluate/tape/tape_workspace.h"
#include "core/function/operation.h"

namespace isoscope {

/// Enclosures of functions with jumps by cases. Where an operation jumps (floor, int, mod, a comparison,
/// select, the cut of atan2) the enclosure over a piece of a ray that holds the jump is the hull of both
/// sides and everything between; taken one side at a time, each has a narrow enclosure. Lane by lane.
///
/// A lane meets its jumps in the order of the tape. Its side at the k-th of them is bit k of `sides`: 0 for
/// the lower value of the operand, 1 for the higher. All values of the function on the piece are in one of
/// the enclosures for sides 0 to 2^jumps - 1, if none of them meets more than `jumps`.
struct CaseLanes {
    using Lanes = std::array<double, batchLanes>;

    /// Jumps of a lane beyond these count as too many: what operands leave open by more than one jump.
    static constexpr double tooMany = 1024;

    /// What a select of the tape has in common with others: those on the same condition are one jump, whose
    /// side the first of them takes.
    struct Shared {
        std::uint32_t number = 0;  ///< of the condition from 1 on; 0 for those that share none
        bool first = false;
    };

    // Before the evaluation.
    std::vector<Shared> shared;  ///< of each instruction of the tape, by its number; see setShared()
    std::vector<Lanes> taken;    ///< the sides of the shared conditions; used by the evaluation
    bool bySides = false;        ///< else every lane gets the hull of all sides
    Lanes sides;                 ///< used up by the evaluation

    // After it.
    Lanes jumps;  ///< how many the piece may hold
    /// Where the first of them is, as far as can be told: s from -1 at the start of the piece to 1 at its
    /// end. Both are 1 where nothing is known.
    Lanes first, last;
};

/// Fills `shared` and makes room in `taken` for a tape's instructions, which are all to be run.
void setShared(std::span<const Instruction> instructions, CaseLanes& cases);

/// Whether an operation is enclosed by sides where its operands leave open which one it takes.
constexpr bool hasSides(Operation operation) {
    switch (operation) {
        case Operation::floor:
        case Operation::ceiling:
        case Operation::truncate:
        case Operation::arcTangent2:
        case Operation::remainder:
        case Operation::integerDivide:
        case Operation::equal:
        case Operation::notEqual:
        case Operation::less:
        case Operation::lessEqual:
        case Operation::greater:
        case Operation::greaterEqual:
        case Operation::logicalAnd:
        case Operation::logicalOr:
        case Operation::select3:
        case Operation::select4: return true;
        default: return false;
    }
}

}  // namespace isoscope
