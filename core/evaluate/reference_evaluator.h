// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include "core/evaluate/tape/loop_range.h"
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
    /// gives NaN (see LoopRange).
    double evaluate(std::span<const double> arguments, std::span<const double> parameters = {},
                    std::size_t result = 0);

    /// All results at once.
    std::vector<double> evaluateAll(std::span<const double> arguments,
                                    std::span<const double> parameters = {});

    static constexpr double loopLimit = LoopRange::topAllowance;

  private:
    ReferenceEvaluator(Function function, double loopAllowance);

    /// Computes the values of nodes 0 to `last`.
    void walk(NodeId last, std::span<const double> arguments, std::span<const double> parameters);
    double loopValue(const Node& node, std::span<const double> parameters) const;

    Function function_;
    std::vector<double> values_;
    double loopAllowance_ = loopLimit;
};

}  // namespace isoscope
