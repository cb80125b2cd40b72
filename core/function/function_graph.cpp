// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/function/function_graph.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

#include "core/function/graph_copy.h"
#include "core/function/scalar_operations.h"

namespace isoscope {

namespace {

std::size_t combine(std::size_t seed, std::size_t value) {
    return seed ^ (value + 0x9e3779b97f4a7c15ull + (seed << 6) + (seed >> 2));
}

std::size_t hashOf(const Node& node) {
    std::size_t hash = combine(static_cast<std::size_t>(node.operation), node.index);
    hash = combine(hash, std::bit_cast<std::uint64_t>(node.value));
    for (const NodeId operand : node.operands) hash = combine(hash, operand);
    // Its low bits depend on all of what is in it.
    return (hash * 0x9e3779b97f4a7c15ull) >> 32;
}

/// Powers of 2: to multiply by 1 / value gives what the division does, to the last bit, and takes less time.
bool hasExactInverse(double value) {
    int exponent = 0;
    return std::abs(std::frexp(value, &exponent)) == 0.5 && std::isnormal(value) && std::isnormal(1 / value);
}

}  // namespace

bool operator==(const Node& a, const Node& b) {
    return a.operation == b.operation && a.index == b.index &&
           std::bit_cast<std::uint64_t>(a.value) == std::bit_cast<std::uint64_t>(b.value) &&
           a.operands == b.operands;
}

/// Where a node is, or is to be.
std::size_t FunctionGraph::placeOf(const Node& node) const {
    const std::size_t last = places_.size() - 1;
    std::size_t place = hashOf(node) & last;
    while (places_[place] != noNode && nodes_[places_[place]] != node) place = (place + 1) & last;
    return place;
}

/// Room for twice as many nodes.
void FunctionGraph::makePlaces() {
    constexpr std::size_t fewest = 64;
    places_.assign(std::max(fewest, 2 * places_.size()), noNode);
    for (NodeId id = 0; id < nodes_.size(); ++id) places_[placeOf(nodes_[id])] = id;
}

NodeId FunctionGraph::intern(const Node& node) {
    if (places_.size() < 2 * (nodes_.size() + 1)) makePlaces();
    const std::size_t place = placeOf(node);
    if (places_[place] != noNode) return places_[place];
    // The last place is kept for the NaN that stands for everything that does not fit.
    if (nodes_.size() + 1 >= nodeLimit) {
        if (!overflowed_) {
            Node nan;
            nan.value = std::numeric_limits<double>::quiet_NaN();
            nodes_.push_back(nan);
        }
        overflowed_ = true;
        return static_cast<NodeId>(nodes_.size() - 1);
    }
    const auto id = static_cast<NodeId>(nodes_.size());
    nodes_.push_back(node);
    places_[place] = id;
    return id;
}

NodeId FunctionGraph::constant(double value) {
    Node node;
    // One NaN is as good as another; a single one keeps the graph hash-consed.
    node.value = std::isnan(value) ? std::numeric_limits<double>::quiet_NaN() : value;
    return intern(node);
}

NodeId FunctionGraph::variable(int index) {
    Node node;
    node.operation = Operation::variable;
    node.index = static_cast<std::uint32_t>(index);
    return intern(node);
}

NodeId FunctionGraph::parameter(int slot) {
    Node node;
    node.operation = Operation::parameter;
    node.index = static_cast<std::uint32_t>(slot);
    return intern(node);
}

NodeId FunctionGraph::unary(Operation operation, NodeId a) {
    if (isConstant(a)) {
        const double operands[] = {value(a)};
        return constant(evaluateOperation(operation, operands));
    }
    Node node;
    node.operation = operation;
    node.operands[0] = a;
    return intern(node);
}

NodeId FunctionGraph::binary(Operation operation, NodeId a, NodeId b) {
    if (isConstant(a) && isConstant(b)) {
        const double operands[] = {value(a), value(b)};
        return constant(evaluateOperation(operation, operands));
    }
    if (operation == Operation::multiply && a == b) return unary(Operation::square, a);
    if (operation == Operation::divide && isConstant(b) && hasExactInverse(value(b)))
        return value(b) == 1 ? a : binary(Operation::multiply, a, constant(1 / value(b)));
    const bool isFraction = operation == Operation::subtract && nodes_[b].operation == Operation::floor &&
                            nodes_[b].operands[0] == a;
    if (isFraction) return unary(Operation::fraction, a);
    Node node;
    node.operation = operation;
    node.operands[0] = a;
    node.operands[1] = b;
    return intern(node);
}

NodeId FunctionGraph::ternary(Operation operation, NodeId a, NodeId b, NodeId c) {
    if (isConstant(a) && isConstant(b) && isConstant(c)) {
        const double operands[] = {value(a), value(b), value(c)};
        return constant(evaluateOperation(operation, operands));
    }
    if (operation == Operation::select3 && isConstant(a)) return value(a) < 0 ? b : c;
    Node node;
    node.operation = operation;
    node.operands = {a, b, c, noNode};
    return intern(node);
}

NodeId FunctionGraph::quaternary(Operation operation, NodeId a, NodeId b, NodeId c, NodeId d) {
    if (isConstant(a) && isConstant(b) && isConstant(c) && isConstant(d)) {
        const double operands[] = {value(a), value(b), value(c), value(d)};
        return constant(evaluateOperation(operation, operands));
    }
    if (operation == Operation::select4 && isConstant(a)) return value(a) < 0 ? b : value(a) == 0 ? c : d;
    Node node;
    node.operation = operation;
    node.operands = {a, b, c, d};
    return intern(node);
}

NodeId FunctionGraph::crackle(const CrackleSettings& settings, NodeId x, NodeId y, NodeId z) {
    auto known = std::find(crackles_.begin(), crackles_.end(), settings);
    if (known == crackles_.end()) known = crackles_.insert(crackles_.end(), settings);
    if (isConstant(x) && isConstant(y) && isConstant(z)) {
        const double operands[] = {value(x), value(y), value(z)};
        return constant(evaluateOperation(Operation::crackle, operands, &settings));
    }
    Node node;
    node.operation = Operation::crackle;
    node.index = static_cast<std::uint32_t>(known - crackles_.begin());
    node.operands = {x, y, z, noNode};
    return intern(node);
}

NodeId FunctionGraph::loop(Operation operation, NodeId first, NodeId last, const Function& body,
                           std::span<const NodeId> captured) {
    if (overflowed_) return static_cast<NodeId>(size() - 1);
    const bool isSum = operation == Operation::sum;
    if (isConstant(first) && isConstant(last)) {
        const double from = value(first), to = value(last);
        // An empty range, or a bound that is NaN, gives the neutral element.
        if (!(from <= to)) return constant(isSum ? 0 : 1);
        // Beyond 2^53 adding 1 changes nothing, and the loop would not end.
        if (to - from < unrollLimit && std::abs(from) < 9007199254740992.0 &&
            std::abs(to) < 9007199254740992.0) {
            std::vector<NodeId> arguments(1, noNode);
            arguments.insert(arguments.end(), captured.begin(), captured.end());
            NodeId total = constant(isSum ? 0 : 1);
            bool started = false;
            for (double i = from; i <= to; i += 1) {
                arguments[0] = constant(i);
                const NodeId term = inlineCall(body, arguments);
                total = started ? binary(isSum ? Operation::add : Operation::multiply, total, term) : term;
                started = true;
            }
            return total;
        }
    }
    Node node;
    node.operation = operation;
    node.index = static_cast<std::uint32_t>(loops_.size());
    node.operands = {first, last, noNode, noNode};
    loops_.push_back({std::make_shared<Function>(body), {captured.begin(), captured.end()}});
    return intern(node);
}

NodeId FunctionGraph::inlineCall(const Function& callee, std::span<const NodeId> arguments,
                                 std::size_t result) {
    GraphCopy copy;
    copy.variable = [&](std::uint32_t index) { return arguments[index]; };
    return copy.into(*this, callee, result);
}

std::vector<NodeId> FunctionGraph::operandsOf(NodeId id) const {
    const Node& node = nodes_[id];
    std::vector<NodeId> operands;
    for (const NodeId operand : node.operands)
        if (operand != noNode) operands.push_back(operand);
    const std::span<const NodeId> captured = this->captured(node);
    operands.insert(operands.end(), captured.begin(), captured.end());
    return operands;
}

Function finish(FunctionGraph&& graph, std::vector<NodeId> results, int argumentCount) {
    return {std::make_shared<const FunctionGraph>(std::move(graph)), std::move(results), argumentCount};
}

}  // namespace isoscope
