// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "core/evaluate/steps/step_program.h"
#include "core/evaluate/tape/simplified_tape.h"

namespace isoscope {

class GlobalSimplification;
class PreparedFunction;

/// The programs of one evaluator, for any kind of number: of its tape and of the tape's approximations, bound
/// to its workspace when they are first run; PreparedFunction has their code. No others: compiling a tape
/// that is run a few times costs more than it saves. At most mostApproximations + 1.
class TapePrograms {
  public:
    /// Programs work on several vectors at a time, those for plain numbers on all lanes: fewer lanes than
    /// these are left to the instructions.
    static constexpr std::size_t fewestLanes = 9;
    static constexpr std::size_t fewestPlainLanes = batchLanes;

    explicit TapePrograms(std::shared_ptr<const PreparedFunction> function);

    /// The program that runs `lanes` lanes of the tape, or of the tape of its decided choices
    /// (GlobalSimplification::decided) where `simplifiedTape` is that; null where the instructions are to be
    /// run instead. Every call must come with the same workspace.
    StepProgram* find(TapeWorkspace& workspace, const SimplifiedTape* simplifiedTape, std::size_t lanes);
    /// The same for an approximation, by its number. `global` must be the same in every call, and outlive the
    /// programs.
    StepProgram* find(TapeWorkspace& workspace, const GlobalSimplification& global, std::size_t approximation,
                      std::size_t lanes);

  private:
    static bool pays(const TapeWorkspace& workspace, std::size_t lanes) {
        return lanes >= (workspace.components() == 1 ? fewestPlainLanes : fewestLanes);
    }

    std::shared_ptr<const PreparedFunction> function_;
    std::optional<StepProgram> whole_;
    std::vector<std::optional<StepProgram>> approximations_;
};

}  // namespace isoscope
