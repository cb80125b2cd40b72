// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/evaluate/reference_evaluator.h"

#include <algorithm>
#include <array>
#include <limits>

#include "core/evaluate/tape/loop_stop.h"
#include "core/function/scalar_operations.h"

namespace isoscope {

ReferenceEvaluator::ReferenceEvaluator(Function function)
    : function_(std::move(function)), values_(function_.graph->size()) {}

ReferenceEvaluator::ReferenceEvaluator(Function function, double loopAllowance)
    : ReferenceEvaluator(std::move(function)) {
    loopAllowance_ = loopAllowance;
}

double ReferenceEvaluator::evaluate(std::span<const double> arguments, std::span<const double> parameters,
                                    std::size_t result) {
    const NodeId root = function_.results[result];
    walk(root, arguments, parameters);
    return values_[root];
}

std::vector<double> ReferenceEvaluator::evaluateAll(std::span<const double> arguments,
                                                    std::span<const double> parameters) {
    std::vector<double> all;
    if (function_.results.empty()) return all;
    walk(*std::max_element(function_.results.begin(), function_.results.end()), arguments, parameters);
    for (const NodeId root : function_.results) all.push_back(values_[root]);
    return all;
}

void ReferenceEvaluator::walk(NodeId last, std::span<const double> arguments,
                              std::span<const double> parameters) {
    const FunctionGraph& graph = *function_.graph;
    for (NodeId id = 0; id <= last; ++id) {
        const Node& node = graph[id];
        switch (node.operation) {
            case Operation::constant: values_[id] = node.value; break;
            case Operation::variable:
                values_[id] = node.index < arguments.size() ? arguments[node.index] : 0;
                break;
            case Operation::parameter:
                values_[id] = node.index < parameters.size() ? parameters[node.index] : 0;
                break;
            case Operation::sum:
            case Operation::product: values_[id] = loopValue(node, parameters); break;
            default: {
                std::array<double, 4> operands{};
                const auto count = static_cast<std::size_t>(arity(node.operation));
                for (std::size_t k = 0; k < count; ++k) operands[k] = values_[node.operands[k]];
                const CrackleSettings* crackle =
                    node.operation == Operation::crackle ? &graph.crackleSettings(node.index) : nullptr;
                values_[id] = evaluateOperation(node.operation, std::span(operands).first(count), crackle);
            }
        }
    }
}

double ReferenceEvaluator::loopValue(const Node& node, std::span<const double> parameters) const {
    const bool isSum = node.operation == Operation::sum;
    const double first = values_[node.operands[0]];
    const double last = values_[node.operands[1]];
    const LoopRange range(first, last, loopAllowance_);
    if (range.tooLong()) return std::numeric_limits<double>::quiet_NaN();

    double total = isSum ? 0 : 1;
    if (!range.runs()) return total;
    ReferenceEvaluator body(function_.graph->loopBody(node.index), range.bodyAllowance());
    std::vector<double> arguments(1);
    for (const NodeId id : function_.graph->captured(node)) arguments.push_back(values_[id]);
    for (double i = first; i <= last && !LoopStop::requested(); i += 1) {
        arguments[0] = i;
        const double term = body.evaluate(arguments, parameters);
        total = isSum ? total + term : total * term;
    }
    return total;
}

}  // namespace isoscope
