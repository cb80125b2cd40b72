// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/function/graph_copy.h"

#include <array>
#include <set>

namespace isoscope {

namespace {

void collectSlots(const Function& function, std::set<int>& slots) {
    for (const NodeId result : function.results) {
        const std::vector<bool> needed = neededNodes(*function.graph, result);
        for (NodeId id = 0; id <= result; ++id) {
            const Node& node = (*function.graph)[id];
            if (!needed[id]) continue;
            if (node.operation == Operation::parameter) slots.insert(static_cast<int>(node.index));
            if (node.operation == Operation::sum || node.operation == Operation::product)
                collectSlots(function.graph->loopBody(node.index), slots);
        }
    }
}

/// The function with variable number `index` in the place of the parameter.
Function freed(const Function& function, int slot, int index) {
    FunctionGraph graph;
    GraphCopy copy;
    copy.variable = [&](std::uint32_t k) { return graph.variable(static_cast<int>(k)); };
    copy.parameter = [&](std::uint32_t k) {
        return static_cast<int>(k) == slot ? graph.variable(index) : graph.parameter(static_cast<int>(k));
    };
    bool failed = false;
    copy.body = [&](const Function& body, std::vector<NodeId>& captured) {
        const int next = 1 + static_cast<int>(captured.size());
        captured.push_back(graph.variable(index));
        Function inner = freed(body, slot, next);
        failed = failed || !inner.valid();
        return failed ? body : inner;
    };
    const NodeId result = copy.into(graph, function);
    if (failed || graph.overflowed()) return {};
    return finish(std::move(graph), {result}, index + 1);
}

}  // namespace

NodeId operationNode(FunctionGraph& graph, Operation operation, std::span<const NodeId> operands) {
    switch (operands.size()) {
        case 1: return graph.unary(operation, operands[0]);
        case 2: return graph.binary(operation, operands[0], operands[1]);
        case 3: return graph.ternary(operation, operands[0], operands[1], operands[2]);
        default: return graph.quaternary(operation, operands[0], operands[1], operands[2], operands[3]);
    }
}

std::vector<bool> neededNodes(const FunctionGraph& graph, NodeId result) {
    std::vector<bool> needed(graph.size(), false);
    needed[result] = true;
    for (NodeId id = result + 1; id-- > 0;)
        if (needed[id])
            for (const NodeId operand : graph.operandsOf(id)) needed[operand] = true;
    return needed;
}

NodeId GraphCopy::into(FunctionGraph& graph, const Function& function, std::size_t result) const {
    const FunctionGraph& source = *function.graph;
    const NodeId last = function.results[result];
    const std::vector<bool> needed = neededNodes(source, last);
    std::vector<NodeId> copy(source.size(), noNode);
    for (NodeId id = 0; id <= last && !graph.overflowed(); ++id) {
        if (!needed[id]) continue;
        const Node& node = source[id];
        const auto operand = [&](int k) { return copy[node.operands[static_cast<std::size_t>(k)]]; };
        switch (node.operation) {
            case Operation::constant: copy[id] = graph.constant(node.value); continue;
            case Operation::variable: copy[id] = variable(node.index); continue;
            case Operation::parameter:
                copy[id] = parameter ? parameter(node.index) : graph.parameter(static_cast<int>(node.index));
                continue;
            case Operation::crackle:
                copy[id] =
                    graph.crackle(source.crackleSettings(node.index), operand(0), operand(1), operand(2));
                continue;
            case Operation::sum:
            case Operation::product: {
                std::vector<NodeId> captured;
                for (const NodeId value : source.captured(node)) captured.push_back(copy[value]);
                const Function& old = source.loopBody(node.index);
                const Function inner = body ? body(old, captured) : old;
                copy[id] = graph.loop(node.operation, operand(0), operand(1), inner, captured);
                continue;
            }
            default: break;
        }
        std::array<NodeId, 4> operands{};
        const auto count = static_cast<std::size_t>(arity(node.operation));
        for (std::size_t k = 0; k < count; ++k) operands[k] = copy[node.operands[k]];
        copy[id] = operationNode(graph, node.operation, std::span(operands).first(count));
    }
    return graph.overflowed() ? static_cast<NodeId>(graph.size() - 1) : copy[last];
}

std::vector<int> parameterSlots(const Function& function) {
    std::set<int> slots;
    if (function.valid()) collectSlots(function, slots);
    return {slots.begin(), slots.end()};
}

Function withFreeParameter(const Function& function, int slot) {
    return function.valid() ? freed(function, slot, function.argumentCount) : Function{};
}

}  // namespace isoscope
