// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <vector>

#include "core/evaluate/steps/step_code.h"

namespace isoscope {

/// Writes the steps and stretches of a StepCode. Values with one reader stay in the accumulator when the
/// reader comes next, those that are read again soon in its copies; squares and products of values in memory
/// are computed where they are read.
class StepProgramCompiler {
  public:
    /// Arithmetic on composed numbers costs more than memory, and no value is computed twice.
    StepProgramCompiler(const Tape& tape, std::span<const Instruction> instructions, StepNumberKind numbers,
                        std::vector<ProgramStep>& steps, std::vector<StepCode::Stretch>& stretches);

    /// Appends to `steps` and `stretches`; the slots of `results` hold their values in the workspace's memory
    /// at the end. Operands are slots: memory is bound later (StepProgram::bind). One call for each compiler.
    void compile(std::span<const Slot> results);

  private:
    /// Number of an instruction of the tape.
    using InstructionIndex = std::uint32_t;
    static constexpr InstructionIndex nowhere = 0xffffffff;

    /// The operand of a step.
    struct Term {
        StepOperand operand = StepOperand::lanes;
        Slot a = ProgramStep::unused;
        Slot b = ProgramStep::unused;

        explicit operator bool() const { return a != ProgramStep::unused; }
    };

    /// What becomes of the value of an instruction.
    struct Value {
        std::array<InstructionIndex, 4> definitions{nowhere, nowhere, nowhere, nowhere};  ///< of its operands
        std::uint32_t readerCount = 0;
        InstructionIndex lastReader = nowhere;  ///< the only one where there is one
        std::uint32_t stretch = 0;
        bool readBySteps = true;                ///< and neither by other instructions nor by the caller
        bool readByChoices = false;             ///< by a minimum or maximum, among others
        bool inMemory = false;                  ///< has to be
        Term deferred;                          ///< where it is computed by its readers
        StepOperand copy = StepOperand::lanes;  ///< one of the accumulator, once it is there
    };

    bool isStep(InstructionIndex place) const;
    void findReaders(std::span<const Slot> results);
    void read(InstructionIndex place, InstructionIndex reader);
    void findDeferred();
    Term termOf(InstructionIndex place) const;
    bool mayBeDeferred(InstructionIndex place, const Term& term) const;
    bool staysComputable(InstructionIndex place) const;
    /// Who computes the operand of an instruction (nowhere: an argument or a uniform slot).
    InstructionIndex definition(InstructionIndex place, int operand) const {
        return values_[place].definitions[static_cast<std::size_t>(operand)];
    }
    InstructionIndex next(InstructionIndex place) const;
    bool goesOnInAccumulator(InstructionIndex place) const;
    void emit(InstructionIndex place);
    void emitBinary(InstructionIndex place);
    bool emitTermOf(InstructionIndex place);
    void keep(InstructionIndex place);
    bool isInAccumulator(InstructionIndex place, int operand) const;
    bool isInCopy(InstructionIndex place, int operand) const;
    void emitTerm(StepOperation operation, InstructionIndex place, int operand);
    void emitStep(StepOperation operation, const Term& term) {
        steps_.push_back({ProgramStep::codeOf(operation, term.operand), term.a, term.b});
    }
    void emitStep(StepOperation operation) { emitStep(operation, Term()); }
    /// Ends it with an instruction, or, where it has no steps, gives this to the one before.
    void endStretch(std::span<const Instruction> instruction);

    const Tape& tape_;
    std::span<const Instruction> instructions_;
    StepNumberKind numbers_;
    std::vector<ProgramStep>& steps_;
    std::vector<StepCode::Stretch>& stretches_;
    std::vector<bool> wholeNumbers_;  ///< for forms by cases: what is not for steps
    std::vector<Value> values_;
    InstructionIndex inAccumulator_ = nowhere;
    std::array<InstructionIndex, 2> savedUntil_{};  ///< last readers of the copies of the accumulator
    std::uint32_t firstStep_ = 0;
};

}  // namespace isoscope
