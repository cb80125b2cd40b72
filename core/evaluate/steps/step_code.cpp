// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/evaluate/steps/step_code.h"

#include "core/evaluate/steps/step_program_compiler.h"

namespace isoscope {

StepCode::StepCode(const Tape& tape, std::span<const Instruction> instructions, std::span<const Slot> results,
                   StepNumberKind numbers)
    : tape_(&tape), instructions_(instructions) {
    // Mostly enough; growing would touch the memory twice.
    steps_.reserve(instructions.size() + 1);
    StepProgramCompiler(tape, instructions, numbers, steps_, stretches_).compile(results);
    for (std::uint32_t k = 0; k < steps_.size(); ++k)
        if (tape.isArgument(steps_[k].a) || tape.isArgument(steps_[k].b)) movable_.push_back(k);
}

const StepCode& StepCodes::of(StepNumberKind numbers) const {
    const auto kind = static_cast<std::size_t>(numbers);
    std::call_once(made_[kind], [&] { codes_[kind].emplace(tape_, instructions_, results_, numbers); });
    return *codes_[kind];
}

}  // namespace isoscope
