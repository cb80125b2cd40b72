// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <vector>

#include "core/evaluate/point_program.h"

namespace isoscope {

/// Writes the steps and stretches of a PointProgram. Values with one reader stay in the accumulator when the
/// reader comes next, those that are read again soon in its copies; squares and products of values in memory
/// are computed where they are read.
class PointProgramCompiler {
  public:
    PointProgramCompiler(const Tape& tape, std::vector<PointStep>& steps,
                         std::vector<PointProgram::Stretch>& stretches);

    void compile();

  private:
    /// Number of an instruction of the tape.
    using Place = std::uint32_t;
    static constexpr Place nowhere = 0xffffffff;

    /// The operand of a step.
    struct Term {
        PointOperand operand = PointOperand::lanes;
        Slot a = PointStep::unused;
        Slot b = PointStep::unused;

        explicit operator bool() const { return a != PointStep::unused; }
    };

    /// What becomes of the value of an instruction.
    struct Value {
        std::array<Place, 4> definitions{nowhere, nowhere, nowhere, nowhere};  ///< of its operands
        std::uint32_t readerCount = 0;
        Place lastReader = nowhere;  ///< the only one where there is one
        std::uint32_t stretch = 0;
        bool readBySteps = true;                  ///< and neither by other instructions nor by the caller
        bool inMemory = false;                    ///< has to be
        Term deferred;                            ///< where it is computed by its readers
        PointOperand copy = PointOperand::lanes;  ///< one of the accumulator, once it is there
    };

    void findReaders();
    void read(Place place, Place reader);
    void findDeferred();
    Term termOf(Place place) const;
    bool mayBeDeferred(Place place, const Term& term) const;
    bool staysComputable(Place place) const;
    /// Who computes the operand of an instruction (nowhere: an argument or a uniform slot).
    Place definition(Place place, int operand) const { return values_[place].definitions[operand]; }
    Place next(Place place) const;
    bool goesOnInAccumulator(Place place) const;
    void emit(Place place);
    void emitBinary(Place place);
    bool emitTermOf(Place place);
    void keep(Place place);
    bool isInAccumulator(Place place, int operand) const;
    bool isInCopy(Place place, int operand) const;
    void emitTerm(PointOperation operation, Place place, int operand);
    void emitStep(PointOperation operation, const Term& term) {
        steps_.push_back({PointStep::codeOf(operation, term.operand), term.a, term.b});
    }
    void emitStep(PointOperation operation) { emitStep(operation, Term()); }
    /// Ends it with an instruction, or, where it has no steps, gives this to the one before.
    void endStretch(std::span<const Instruction> instruction);

    const Tape& tape_;
    std::span<const Instruction> instructions_;
    std::vector<PointStep>& steps_;
    std::vector<PointProgram::Stretch>& stretches_;
    std::vector<Value> values_;
    Place inAccumulator_ = nowhere;
    std::array<Place, 2> savedUntil_{};  ///< last readers of the copies of the accumulator
    std::uint32_t firstStep_ = 0;
};

}  // namespace isoscope
