// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/evaluate/steps/tape_programs.h"

#include "core/evaluate/prepared_function.h"

namespace isoscope {

TapePrograms::TapePrograms(std::shared_ptr<const PreparedFunction> function)
    : function_(std::move(function)) {}

StepProgram* TapePrograms::find(TapeWorkspace& workspace, const SimplifiedTape* simplifiedTape,
                                std::size_t lanes) {
    if (simplifiedTape != nullptr) {
        const GlobalSimplification* global = function_->keptGlobal();
        if (global == nullptr || simplifiedTape != global->decided()) return nullptr;
        return find(workspace, *global, 0, lanes);
    }
    if (!pays(workspace, lanes)) return nullptr;
    if (!whole_) whole_.emplace(workspace, function_->code(StepProgram::numbersOf(workspace)));
    return &*whole_;
}

StepProgram* TapePrograms::find(TapeWorkspace& workspace, const GlobalSimplification& global,
                                std::size_t approximation, std::size_t lanes) {
    if (!pays(workspace, lanes)) return nullptr;
    if (approximations_.empty()) approximations_.resize(global.approximations().size());
    std::optional<StepProgram>& program = approximations_[approximation];
    if (!program) program.emplace(workspace, global.code(approximation, StepProgram::numbersOf(workspace)));
    return &*program;
}

}  // namespace isoscope
