// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/exchange/function_text.h"

#include <array>
#include <cmath>

#include "core/text/number_format.h"

namespace isoscope {

namespace {

/// Names of functions by operation; empty for what is written otherwise.
const char* functionName(Operation operation) {
    switch (operation) {
        case Operation::absolute: return "abs";
        case Operation::squareRoot: return "sqrt";
        case Operation::exponential: return "exp";
        case Operation::naturalLogarithm: return "ln";
        case Operation::decimalLogarithm: return "log";
        case Operation::sine: return "sin";
        case Operation::cosine: return "cos";
        case Operation::tangent: return "tan";
        case Operation::arcSine: return "asin";
        case Operation::arcCosine: return "acos";
        case Operation::arcTangent: return "atan";
        case Operation::hyperbolicSine: return "sinh";
        case Operation::hyperbolicCosine: return "cosh";
        case Operation::hyperbolicTangent: return "tanh";
        case Operation::areaSine: return "asinh";
        case Operation::areaCosine: return "acosh";
        case Operation::areaTangent: return "atanh";
        case Operation::floor: return "floor";
        case Operation::ceiling: return "ceil";
        case Operation::truncate: return "int";
        case Operation::power: return "pow";
        case Operation::arcTangent2: return "atan2";
        case Operation::remainder: return "mod";
        case Operation::minimum: return "min";
        case Operation::maximum: return "max";
        case Operation::select3:
        case Operation::select4: return "select";
        default: return "";
    }
}

/// Between two operands, with parentheses around the whole.
const char* infix(Operation operation) {
    switch (operation) {
        case Operation::add: return " + ";
        case Operation::subtract: return " - ";
        case Operation::multiply: return "*";
        case Operation::divide: return "/";
        case Operation::equal: return " = ";
        case Operation::notEqual: return " != ";
        case Operation::less: return " < ";
        case Operation::lessEqual: return " <= ";
        case Operation::greater: return " > ";
        case Operation::greaterEqual: return " >= ";
        default: return "";
    }
}

std::string numberText(double value) {
    if (!std::isfinite(value)) return {};
    const std::string text = shortestNumber(value);
    return value < 0 ? "(" + text + ")" : text;
}

/// Empty when it cannot be written.
std::string textOf(const Node& node, const std::vector<std::string>& texts,
                   const std::vector<std::string>& arguments, std::span<const double> parameterTable) {
    const auto operand = [&](std::size_t k) -> const std::string& { return texts[node.operands[k]]; };
    switch (node.operation) {
        case Operation::constant: return numberText(node.value);
        case Operation::variable: return node.index < arguments.size() ? arguments[node.index] : "";
        case Operation::parameter:
            return node.index < parameterTable.size() ? numberText(parameterTable[node.index]) : "";
        case Operation::negate: return "(-" + operand(0) + ")";
        case Operation::square: return "pow(" + operand(0) + ", 2)";
        default: break;
    }
    const int count = arity(node.operation);
    if (const std::string between = infix(node.operation); !between.empty())
        return "(" + operand(0) + between + operand(1) + ")";
    const std::string name = functionName(node.operation);
    if (name.empty() || count < 1) return {};
    std::string text = name + "(" + operand(0);
    for (int k = 1; k < count; ++k) text += ", " + operand(static_cast<std::size_t>(k));
    return text + ")";
}

}  // namespace

std::optional<std::string> functionText(const Function& function, const std::vector<std::string>& arguments,
                                        std::span<const double> parameterTable) {
    const FunctionGraph& graph = *function.graph;
    const NodeId result = function.results[0];
    std::vector<bool> used(graph.size(), false);
    used[result] = true;
    for (NodeId id = result + 1; id-- > 0;)
        if (used[id])
            for (const NodeId operand : graph.operandsOf(id)) used[operand] = true;
    std::vector<std::string> texts(graph.size());
    std::size_t written = 0;
    for (NodeId id = 0; id <= result; ++id) {
        if (!used[id]) continue;
        texts[id] = textOf(graph[id], texts, arguments, parameterTable);
        written += texts[id].size();
        if (texts[id].empty() || texts[id].size() > functionLengthLimit ||
            written > 100 * functionLengthLimit)
            return std::nullopt;
    }
    return texts[result];
}

}  // namespace isoscope
