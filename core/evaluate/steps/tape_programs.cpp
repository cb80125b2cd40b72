// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/evaluate/steps/tape_programs.h"

#include <span>

namespace isoscope {

const StepProgram* TapePrograms::find(TapeWorkspace& workspace, const ShortTape* shortTape,
                                      std::size_t lanes) {
    if (lanes < fewestLanes) return nullptr;
    if (shortTape == nullptr) {
        if (!program_) program_.emplace(workspace);
        return &*program_;
    }
    if (shortTape != lasting_) return nullptr;
    if (!lastingProgram_)
        lastingProgram_.emplace(workspace, shortTape->instructions, std::span(&shortTape->result, 1));
    return &*lastingProgram_;
}

}  // namespace isoscope
