// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include "core/function/function_graph.h"

namespace isoscope {

/// Evaluates a function at one point by walking its graph with standard mathematics: slow, obvious, and what
/// every other evaluator is held against. An object keeps scratch memory: use one per thread.
class ReferenceEvaluator {
  public:
    /// `function` must be valid().
    explicit ReferenceEvaluator(Function function);

    /// Result number `result` for `arguments` (at least argumentCount numbers) and the scene's parameter
    /// table (missing slots count as 0). A loop whose bounds would make it run more than `loopLimit` steps
    /// gives NaN.
    double evaluate(std::span<const double> arguments, std::span<const double> parameters = {},
                    std::size_t result = 0);

    static constexpr double loopLimit = 1e6;

  private:
    double loopValue(const Node& node, std::span<const double> parameters);

    Function function_;
    std::vector<double> values_;
};

}  // namespace isoscope
