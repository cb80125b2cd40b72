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
/// sides and everything between; told which side it is on, it is narrow. Lane by lane.
///
/// The jumps of a tape are numbered: one for each instruction that hasSides(), but selects on one condition
/// are one jump, as are the floor and the fraction of a value. A side is the number of the step for floor,
/// fraction, ceil, int, div and the quotient of mod; else 0 where the operand is below what it jumps at, or
/// the condition is false, and 1 above. Told sides hold all over the piece, whatever its enclosures say.
struct CaseLanes {
    using Lanes = std::array<double, batchLanes>;

    static constexpr double noJump = -1;
    static constexpr std::uint32_t notNumbered = 0xffffffff;

    // Before the evaluation; see prepareCases().
    std::vector<std::uint32_t> jumpOf;  ///< the jump of each instruction of the tape, by its number
    std::vector<bool> isWhole;          ///< those of findWholeNumbers(), by their number
    std::vector<Lanes> sides;           ///< of each jump; NaN for the hull of all sides

    // After it. The first jump in the order of the tape that the piece may hold, of those without a told
    // side.
    Lanes jump;           ///< its number, or noJump
    Lanes lower, higher;  ///< its sides; NaN where there may be more than two
    Lanes low, high;      ///< where it is: s from -1 at the start of the piece to 1 at its end
    Lanes rises;          ///< 1 where the lower side is the one before it, -1 the higher; 0: not known
    /// The same of the one that the ray meets first, as far as can be told. Both are 1 where nothing is
    /// known.
    Lanes firstLow, firstHigh;
};

/// The jump of each instruction of a tape, by its number, as in CaseLanes: those of `instructions`, all of
/// which are to be run.
std::vector<std::uint32_t> numberJumps(std::span<const Instruction> instructions);

/// Numbers the jumps of a tape's instructions, and makes every side unknown.
void prepareCases(const Tape& tape, std::span<const Instruction> instructions, CaseLanes& cases);

/// Which of the instructions, by their place, are sums, products or quotients of values that may be whole
/// numbers: uniform values, steps, and what is made of them. Coordinates that stay the same along a ray may
/// be whole, too; these are left out.
std::vector<bool> findWholeNumbers(const Tape& tape, std::span<const Instruction> instructions);

/// The same by the numbers of the instructions.
std::vector<bool> wholeNumbersByNumber(const Tape& tape, std::span<const Instruction> instructions);

/// Whether an operation is enclosed by sides where its operands leave open which one it takes.
constexpr bool hasSides(Operation operation) {
    switch (operation) {
        case Operation::floor:
        case Operation::ceiling:
        case Operation::truncate:
        case Operation::fraction:
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
