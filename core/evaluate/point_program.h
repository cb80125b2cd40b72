// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/evaluate/tape_workspace.h"

namespace isoscope {

/// What a step does to the accumulator. Of the five codes of a sum or difference, the first takes a slot,
/// then come its square, the product of two slots, the product of a slot and a uniform slot, and a uniform
/// slot. Other codes take a slot and, under the second name, a uniform slot. "From" and "into" have the
/// accumulator as the second operand.
enum class PointCode : std::uint8_t {
    load,
    loadSquare,
    loadProduct,
    loadScaled,
    loadUniform,
    add,
    addSquare,
    addProduct,
    addScaled,
    addUniform,
    subtract,
    subtractSquare,
    subtractProduct,
    subtractScaled,
    subtractUniform,
    subtractFrom,
    subtractFromSquare,
    subtractFromProduct,
    subtractFromScaled,
    subtractFromUniform,
    multiply,
    multiplyUniform,
    divide,
    divideUniform,
    divideInto,
    divideIntoUniform,
    minimum,
    minimumUniform,
    minimumFrom,
    minimumFromUniform,
    maximum,
    maximumUniform,
    maximumFrom,
    maximumFromUniform,
    square,
    negate,
    absolute,
    squareRoot,
    store,
};

/// One step: `code` with the values of the slots `a` and, for products, `b`. `store` writes slot `a`.
struct PointStep {
    static constexpr Slot unused = 0xffffffff;

    PointCode code;
    Slot a = unused;
    Slot b = unused;
    const double* lanesA = nullptr;  ///< memory of the slots; one number for a uniform slot
    const double* lanesB = nullptr;
    double* target = nullptr;  ///< of `store`
};

/// A tape for plain numbers, bound to a workspace: its sums, products and the like as steps of a machine with
/// one accumulator of all lanes, so that most values never travel through memory, which costs as much as
/// computing them. The results are, bit by bit, those of the tape's instructions one after the other.
class PointProgram {
  public:
    /// Steps, and the instructions of the tape to run after them (none after the last).
    struct Stretch {
        std::uint32_t firstStep;
        std::uint32_t stepCount;
        std::span<const Instruction> instructions;
    };

    /// Takes time and memory linear in the instructions. Reads and writes the memory of this workspace, which
    /// must outlive the program (it may be moved).
    explicit PointProgram(TapeWorkspace& workspace);

    /// Reads the arguments from where the workspace has them now, and writes into the workspace.
    void bind(TapeWorkspace& workspace);

    /// Writes the value of a slot to the memory of the caller, not to the workspace, until bind(). False,
    /// without effect, when it is not the last thing the program writes.
    bool writeTo(Slot slot, double* lanes);

    std::span<const Stretch> stretches() const { return stretches_; }
    std::span<const PointStep> steps(const Stretch& stretch) const {
        return std::span(steps_).subspan(stretch.firstStep, stretch.stepCount);
    }

  private:
    static void bind(PointStep& step, TapeWorkspace& workspace);

    std::vector<PointStep> steps_;
    std::vector<Stretch> stretches_;
    std::vector<std::uint32_t> movable_;  ///< steps that read an argument, and the last one
};

}  // namespace isoscope
