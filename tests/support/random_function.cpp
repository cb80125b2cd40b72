// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/random_function.h"

#include <array>
#include <cmath>
#include <limits>

namespace isoscope::test {

namespace {

NodeId pick(std::mt19937_64& random, const std::vector<NodeId>& pool) {
    // Prefers what is young, so that graphs grow deep as well as wide.
    const std::size_t a = random() % pool.size(), b = random() % pool.size();
    return pool[std::max(a, b)];
}

Function randomBody(std::mt19937_64& random, int captured, const RandomFunctionSettings& settings);

NodeId addLoop(FunctionGraph& graph, std::mt19937_64& random, const std::vector<NodeId>& pool,
               const RandomFunctionSettings& settings) {
    const int count = static_cast<int>(random() % 3);
    std::vector<NodeId> captured;
    for (int k = 0; k < count; ++k) captured.push_back(pick(random, pool));
    RandomFunctionSettings inner = settings;
    inner.nodes = 5;
    inner.loops = settings.loops && random() % 4 == 0;
    const Function body = randomBody(random, count, inner);
    // Bounds of a handful of steps, different in every lane: from int(a mod 3) to a mod 5.
    const NodeId from = graph.binary(Operation::remainder, pick(random, pool), graph.constant(3));
    const NodeId to = graph.binary(Operation::remainder, pick(random, pool), graph.constant(5));
    const Operation operation = random() % 2 ? Operation::sum : Operation::product;
    return graph.loop(operation, random() % 2 ? from : graph.unary(Operation::truncate, from), to, body,
                      captured);
}

void grow(FunctionGraph& graph, std::mt19937_64& random, std::vector<NodeId>& pool,
          const RandomFunctionSettings& settings) {
    const std::span<const Operation> operations =
        settings.operations.empty() ? exactOperations() : std::span<const Operation>(settings.operations);
    for (int k = 0; k < settings.nodes; ++k) {
        if (settings.loops && random() % 12 == 0) {
            pool.push_back(addLoop(graph, random, pool, settings));
            continue;
        }
        std::array<NodeId, 4> operands;
        for (NodeId& operand : operands) operand = pick(random, pool);
        pool.push_back(addOperation(graph, operations[random() % operations.size()], operands, random));
    }
}

Function randomBody(std::mt19937_64& random, int captured, const RandomFunctionSettings& settings) {
    FunctionGraph graph;
    std::vector<NodeId> pool;
    for (int k = 0; k <= captured; ++k) pool.push_back(graph.variable(k));
    if (settings.parameters > 0) pool.push_back(graph.parameter(0));
    pool.push_back(graph.constant(anyNumber(random)));
    grow(graph, random, pool, settings);
    const NodeId result = pool.back();
    return finish(std::move(graph), {result}, captured + 1);
}

}  // namespace

const std::vector<double>& specialNumbers() {
    using Limits = std::numeric_limits<double>;
    static const std::vector<double> numbers = [] {
        std::vector<double> positive{0.0,
                                     1.0,
                                     0.5,
                                     2.0,
                                     3.0,
                                     7.0,
                                     0.1,
                                     1e-300,
                                     1e300,
                                     1e-10,
                                     1e17,
                                     2147483646.5,
                                     2147483647.0,
                                     2147483648.0,
                                     2147483649.0,
                                     9007199254740993.0,
                                     700.5,
                                     710.0,
                                     14.6,
                                     14.4,
                                     29999.0,
                                     30001.0,
                                     1e7,
                                     M_PI,
                                     M_PI / 2,
                                     Limits::max(),
                                     Limits::min(),
                                     Limits::denorm_min(),
                                     1.0 + Limits::epsilon(),
                                     1.0 - Limits::epsilon() / 2,
                                     Limits::infinity()};
        std::vector<double> all;
        for (const double number : positive) {
            all.push_back(number);
            all.push_back(-number);
        }
        all.push_back(Limits::quiet_NaN());
        return all;
    }();
    return numbers;
}

double anyNumber(std::mt19937_64& random) {
    const auto uniform = [&](double low, double high) {
        return std::uniform_real_distribution<double>(low, high)(random);
    };
    switch (random() % 8) {
        case 0: return specialNumbers()[random() % specialNumbers().size()];
        case 1: return std::ldexp(uniform(-1, 1), static_cast<int>(random() % 2000) - 1000);
        case 2: return std::round(uniform(-20, 20));
        default: return (random() % 2 ? 1 : -1) * std::pow(10.0, uniform(-3, 3));
    }
}

std::vector<Operation> operationsWithSlopes() {
#define ISOSCOPE_NAME(operation) Operation::operation,
    return {ISOSCOPE_SLOPED_OPERATIONS(ISOSCOPE_NAME, ISOSCOPE_NAME)};
#undef ISOSCOPE_NAME
}

std::span<const Operation> exactOperations() {
    static constexpr std::array operations{
        Operation::negate,         Operation::absolute,       Operation::square,        Operation::squareRoot,
        Operation::floor,          Operation::ceiling,        Operation::truncate,      Operation::add,
        Operation::fraction,       Operation::triangleWave,   Operation::subtract,      Operation::multiply,
        Operation::divide,         Operation::remainder,      Operation::integerDivide, Operation::minimum,
        Operation::maximum,        Operation::equal,          Operation::notEqual,      Operation::less,
        Operation::lessEqual,      Operation::greater,        Operation::greaterEqual,  Operation::logicalAnd,
        Operation::logicalOr,      Operation::select3,        Operation::select4,       Operation::noise,
        Operation::noiseGradientX, Operation::noiseGradientY, Operation::noiseGradientZ};
    return operations;
}

NodeId addOperation(FunctionGraph& graph, Operation operation, std::span<const NodeId> operands,
                    std::mt19937_64& random) {
    if (operation == Operation::crackle) {
        CrackleSettings settings;
        settings.metric = 1 + static_cast<double>(random() % 4);
        settings.solid = random() % 4 == 0;
        settings.offset = random() % 3 ? 0 : 0.25;
        return graph.crackle(settings, operands[0], operands[1], operands[2]);
    }
    switch (arity(operation)) {
        case 1: return graph.unary(operation, operands[0]);
        case 2: return graph.binary(operation, operands[0], operands[1]);
        case 3: return graph.ternary(operation, operands[0], operands[1], operands[2]);
        default: return graph.quaternary(operation, operands[0], operands[1], operands[2], operands[3]);
    }
}

Function randomFunction(std::mt19937_64& random, const RandomFunctionSettings& settings) {
    FunctionGraph graph;
    std::vector<NodeId> pool;
    for (int k = 0; k < 3; ++k) pool.push_back(graph.variable(k));
    for (int k = 0; k < settings.parameters; ++k) pool.push_back(graph.parameter(k));
    for (int k = 0; k < 2; ++k) pool.push_back(graph.constant(anyNumber(random)));
    grow(graph, random, pool, settings);
    std::vector<NodeId> results{pool.back(), pool[random() % pool.size()]};
    return finish(std::move(graph), std::move(results), 3);
}

std::string describe(const Function& function) {
    const FunctionGraph& graph = *function.graph;
    std::string text;
    for (NodeId id = 0; id <= function.results[0]; ++id) {
        const Node& node = graph[id];
        text += "#" + std::to_string(id) + " = " + std::string(name(node.operation));
        if (node.operation == Operation::constant) text += " " + std::to_string(node.value);
        if (node.operation == Operation::variable) text += " " + std::to_string(node.index);
        for (const NodeId operand : graph.operandsOf(id)) text += " #" + std::to_string(operand);
        text += "\n";
    }
    return text;
}

}  // namespace isoscope::test
