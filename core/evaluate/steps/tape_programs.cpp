// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/evaluate/steps/tape_programs.h"

#include <span>

namespace isoscope {

const StepProgram* TapePrograms::find(TapeWorkspace& workspace, const SimplifiedTape* simplifiedTape,
                                      std::size_t lanes) {
    if (lanes < fewestLanes) return nullptr;
    if (simplifiedTape == nullptr) {
        if (!program_) program_.emplace(workspace);
        return &*program_;
    }
    if (simplifiedTape != reused_) return nullptr;
    if (!lastingProgram_)
        lastingProgram_.emplace(workspace, simplifiedTape->instructions,
                                std::span(&simplifiedTape->result, 1));
    return &*lastingProgram_;
}

}  // namespace isoscope
