// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/evaluate/tape/tape.h"

#include "core/evaluate/reference_evaluator.h"
#include "core/evaluate/tape/tape_compiler.h"

namespace isoscope {

std::shared_ptr<const Tape> Tape::compile(const Function& function) {
    return TapeCompiler(function, TapeCompiler::Role::function).compile();
}

std::vector<double> Tape::uniforms(std::span<const double> parameters) const {
    if (uniformCount_ == 0) return {};
    return ReferenceEvaluator(uniformFunction_).evaluateAll({}, parameters);
}

}  // namespace isoscope
