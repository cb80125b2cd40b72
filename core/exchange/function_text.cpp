// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/exchange/function_text.h"

#include <cmath>

#include "core/text/number_format.h"

namespace isoscope {

namespace {

std::string numberText(double value) {
    if (!std::isfinite(value)) return {};
    const std::string text = shortestNumber(value);
    return value < 0 ? "(" + text + ")" : text;
}

/// Empty when it cannot be written.
std::string textOf(const Node& node, const std::vector<std::string>& texts,
                   const std::vector<std::string>& arguments, std::span<const double> parameterTable,
                   FunctionNotation notation) {
    const auto operand = [&](std::size_t k) -> const std::string& { return texts[node.operands[k]]; };
    switch (node.operation) {
        case Operation::constant: return numberText(node.value);
        case Operation::variable: return node.index < arguments.size() ? arguments[node.index] : "";
        case Operation::parameter:
            return node.index < parameterTable.size() ? numberText(parameterTable[node.index]) : "";
        default: break;
    }
    const OperationFacts& facts = factsOf(node.operation);
    if (notation == FunctionNotation::virtualight && !facts.common) return {};
    std::string text;
    for (const char c : facts.text) {
        if (c == '#' || c == '@')
            text += operand(c == '@');
        else
            text += c;
    }
    if (!text.empty() || facts.call.empty() || facts.arity < 1) return text;
    text = std::string(facts.word()) + "(" + operand(0);
    for (int k = 1; k < facts.arity; ++k) text += ", " + operand(static_cast<std::size_t>(k));
    return text + ")";
}

}  // namespace

std::optional<std::string> functionText(const Function& function, const std::vector<std::string>& arguments,
                                        std::span<const double> parameterTable, FunctionNotation notation,
                                        const std::map<NodeId, std::string>& named) {
    const FunctionGraph& graph = *function.graph;
    const NodeId result = function.results[0];
    std::vector<bool> used(graph.size(), false);
    used[result] = true;
    for (NodeId id = result + 1; id-- > 0;)
        if (used[id] && (id == result || !named.contains(id)))
            for (const NodeId operand : graph.operandsOf(id)) used[operand] = true;
    std::vector<std::string> texts(graph.size());
    std::size_t written = 0;
    for (NodeId id = 0; id <= result; ++id) {
        if (!used[id]) continue;
        const auto name = named.find(id);
        texts[id] = name != named.end() && id != result
                        ? name->second
                        : textOf(graph[id], texts, arguments, parameterTable, notation);
        written += texts[id].size();
        if (texts[id].empty() || texts[id].size() > functionLengthLimit ||
            written > 100 * functionLengthLimit)
            return std::nullopt;
    }
    return texts[result];
}

}  // namespace isoscope
