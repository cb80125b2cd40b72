// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <vector>

#include "core/evaluate/point_program.h"

namespace isoscope {

/// Writes the steps and stretches of a PointProgram. Values with one reader stay in the accumulator when the
/// reader comes next; squares and products of values in memory are computed where they are added.
class PointProgramCompiler {
  public:
    PointProgramCompiler(const Tape& tape, std::vector<PointStep>& steps,
                         std::vector<PointProgram::Stretch>& stretches);

    void compile();

  private:
    /// Number of an instruction of the tape.
    using Place = std::uint32_t;
    static constexpr Place nowhere = 0xffffffff;

    void findReaders();
    void findDeferred();
    bool mayBeDeferred(Place place) const;
    bool staysComputable(Place place) const;
    /// Who computes the operand of an instruction (nowhere: an argument or a uniform slot).
    Place definition(Place place, int operand) const { return definitions_[place][operand]; }
    Place next(Place place) const;
    bool goesOnInAccumulator(Place place) const;
    void emit(Place place);
    void emitBinary(Place place);
    bool isInAccumulator(Place place, int operand) const;
    void emitTerm(PointCode plain, Place place, int operand);
    bool emitProduct(PointCode plain, const Instruction& product);
    void emitStep(PointCode code, Slot a = PointStep::unused, Slot b = PointStep::unused) {
        steps_.push_back({code, a, b});
    }
    /// Ends it with an instruction, or, where it has no steps, gives this to the one before.
    void endStretch(std::span<const Instruction> instruction);

    const Tape& tape_;
    std::span<const Instruction> instructions_;
    std::vector<PointStep>& steps_;
    std::vector<PointProgram::Stretch>& stretches_;
    std::vector<std::array<Place, 4>> definitions_;
    std::vector<std::uint32_t> readerCount_;
    std::vector<Place> lastReader_;  ///< the only one where there is one; nowhere: a result of the tape
    std::vector<bool> readBySums_;   ///< and by differences, and by nothing else
    std::vector<bool> deferred_;
    Place inAccumulator_ = nowhere;
    std::uint32_t firstStep_ = 0;
};

}  // namespace isoscope
