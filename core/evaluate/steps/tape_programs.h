// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "core/evaluate/steps/step_program.h"
#include "core/evaluate/tape/tape_simplifier.h"

namespace isoscope {

/// The programs of a workspace's tape and of one SimplifiedTape of it, each made when it is first asked for.
class TapePrograms {
  public:
    /// Programs work on several vectors at a time: fewer lanes are left to the instructions.
    static constexpr std::size_t fewestLanes = 9;

    /// A tape that will be run many times, and is left alone until the next call; null for none. Compiling
    /// others would cost more than it saves.
    void setReusedTape(const SimplifiedTape* tape) {
        reused_ = tape;
        lastingProgram_.reset();
    }

    /// The program that runs `lanes` lanes of the workspace's tape, or of `simplifiedTape`; null where the
    /// instructions are to be run instead. Every call must come with the same workspace.
    const StepProgram* find(TapeWorkspace& workspace, const SimplifiedTape* simplifiedTape,
                            std::size_t lanes);

  private:
    std::optional<StepProgram> program_, lastingProgram_;
    const SimplifiedTape* reused_ = nullptr;
};

}  // namespace isoscope
