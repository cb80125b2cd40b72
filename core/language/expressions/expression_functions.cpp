// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/language/expressions/expression_functions.h"

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <unordered_map>

#include "core/evaluate/reference_evaluator.h"
#include "core/function/patterns/pattern_warp.h"
#include "core/function/scalar_operations.h"
#include "core/language/tokens/povray_refusals.h"
#include "core/shapes/transform.h"

namespace isoscope {

namespace {

using Call = const ExpressionCall&;

/// The same arithmetic as inside functions, with 32-bit integers and all.
Operand computed(Operation operation, std::initializer_list<double> operands) {
    return Operand::number(evaluateOperation(operation, {operands.begin(), operands.size()}));
}

/// An operation of one operand, within its SceneDomain.
Operand unary(Call call) {
    const double a = call.number(0);
    const SceneDomain domain = factsOf(call.operation).domain;
    if (domain == SceneDomain::positive && !(a > 0)) {
        call.error("`" + call.name + "` needs a positive number.");
        return Operand::number(0);
    }
    const double inside = domain == SceneDomain::unit ? std::clamp(a, -1.0, 1.0) : a;
    if (domain == SceneDomain::unit && inside != a)
        call.warning("`" + call.name + "` is defined from -1 to 1 only; the nearer end is taken.");
    return computed(call.operation, {inside});
}

Operand binary(Call call) { return computed(call.operation, {call.number(0), call.number(1)}); }

Operand folded(Call call) {
    double result = call.number(0);
    for (std::size_t i = 1; i < call.arguments.size(); ++i)
        result = computed(call.operation, {result, call.number(i)}).value();
    return Operand::number(result);
}

Operand squareRoot(Call call) {
    if (call.number(0) < 0) call.error("The square root of a negative number does not exist.");
    return Operand::number(call.number(0) < 0 ? 0 : std::sqrt(call.number(0)));
}

Operand power(Call call) {
    if (call.number(0) == 0 && call.number(1) == 0) {
        call.error("0 to the power of 0 does not exist.");
        return Operand::number(0);
    }
    return computed(Operation::power, {call.number(0), call.number(1)});
}

Operand angle(Call call) {
    if (call.number(0) == 0 && call.number(1) == 0)
        warnOfRefusal(call.tokens.context(), call.range, "takes no `atan2(0, 0)`; here it is 0.",
                      "test for this case before");
    return computed(Operation::arcTangent2, {call.number(0), call.number(1)});
}

Operand degrees(Call call) { return Operand::number(call.number(0) * (180 / 3.14159265358979323846)); }
Operand radians(Call call) { return Operand::number(call.number(0) * (3.14159265358979323846 / 180)); }

Operand select(Call call) {
    const double a = call.number(0);
    if (call.arguments.size() == 3) return Operand::number(a < 0 ? call.number(1) : call.number(2));
    return Operand::number(a < 0 ? call.number(1) : a == 0 ? call.number(2) : call.number(3));
}

template <typename Combine>
Operand bitwise(Call call, Combine combine) {
    const auto whole = [](double value) {
        return static_cast<std::int32_t>(computed(Operation::truncate, {value}).value());
    };
    std::int32_t result = whole(call.number(0));
    for (std::size_t i = 1; i < call.arguments.size(); ++i) result = combine(result, whole(call.number(i)));
    return Operand::number(result);
}

Operand random(Call call) {
    const std::optional<double> value = call.tokens.context().random.next(call.number(0));
    if (!value) call.error("`rand` needs a stream that `seed` has begun.");
    return Operand::number(value.value_or(0));
}

Operand fromVector(const glm::dvec3& v) {
    VectorValue vector;
    vector.components = {v.x, v.y, v.z, 0, 0};
    return Operand::of(vector);
}

Operand normalized(Call call) {
    const glm::dvec3 v = call.vector(0);
    const double length = glm::length(v);
    if (length != 0) return fromVector(v / length);
    call.warning("A vector of length 0 has no direction; it stays <0, 0, 0>.");
    return fromVector({0, 0, 0});
}

/// `vturbulence(LAMBDA, OMEGA, OCTAVES, V)`.
Operand vectorTurbulence(Call call) {
    const int octaves = static_cast<int>(std::clamp(call.number(2), 1.0, 10.0));
    const glm::dvec3 at = call.vector(3);
    FunctionGraph graph;
    const auto number = [&](double value) { return Expression(graph, graph.constant(value)); };
    const PatternPoint point{number(at.x), number(at.y), number(at.z)};
    std::vector<NodeId> results;
    for (std::size_t axis = 0; axis < 3; ++axis)
        results.push_back(vectorTurbulence(point, axis, octaves, call.number(0), call.number(1)).node());
    if (!call.tokens.charge(graph.size(), call.range)) return fromVector({0, 0, 0});
    const std::vector<double> values =
        ReferenceEvaluator(finish(std::move(graph), std::move(results), 0)).evaluateAll({});
    return fromVector({values[0], values[1], values[2]});
}

}  // namespace

glm::dvec3 ExpressionCall::vector(std::size_t i) const {
    const auto& c = arguments[i].vector.components;
    return {c[0], c[1], c[2]};
}

void ExpressionCall::error(std::string message) const {
    tokens.context().error("outside-domain", range, std::move(message));
}

void ExpressionCall::warning(std::string message) const {
    tokens.context().warning("outside-domain", range, std::move(message));
}

namespace {

/// The functions that are operations and have no rules of their own here.
void addOperations(std::vector<ExpressionFunction>& functions) {
    for (int i = 0; i < operationCount; ++i) {
        const auto operation = static_cast<Operation>(i);
        const OperationFacts& facts = factsOf(operation);
        if (facts.form != CallForm::plain && facts.form != CallForm::folded) continue;
        if (std::ranges::find(functions, facts.word(), &ExpressionFunction::name) != functions.end())
            continue;
        if (facts.form == CallForm::folded)
            functions.push_back({facts.word(), "ff*", folded, operation});
        else if (facts.arity == 1)
            functions.push_back({facts.word(), "f", unary, operation});
        else
            functions.push_back({facts.word(), "ff", binary, operation});
    }
}

}  // namespace

const std::vector<ExpressionFunction>& floatFunctions() {
    static const auto all = [] {
        std::vector<ExpressionFunction> table{
            {"atan2", "ff", angle},
            {"bitwise_and", "fff*", [](Call c) { return bitwise(c, [](auto a, auto b) { return a & b; }); }},
            {"bitwise_or", "fff*", [](Call c) { return bitwise(c, [](auto a, auto b) { return a | b; }); }},
            {"bitwise_xor", "fff*", [](Call c) { return bitwise(c, [](auto a, auto b) { return a ^ b; }); }},
            {"degrees", "f", degrees},
            {"pow", "ff", power},
            {"radians", "f", radians},
            {"rand", "f", random},
            {"seed", "f",
             [](Call c) { return Operand::number(c.tokens.context().random.seed(c.number(0))); }},
            {"select", "ffff?", select},
            {"sqrt", "f", squareRoot},
            {"vdot", "vv", [](Call c) { return Operand::number(glm::dot(c.vector(0), c.vector(1))); }},
            {"vlength", "v", [](Call c) { return Operand::number(glm::length(c.vector(0))); }},
        };
        addOperations(table);
        return table;
    }();
    return all;
}

const std::vector<ExpressionFunction>& vectorFunctions() {
    static const std::vector<ExpressionFunction> table{
        {"vaxis_rotate", "vvf",
         [](Call c) {
             return fromVector(Transform::axisRotation(c.vector(1), c.number(2)).point(c.vector(0)));
         }},
        {"vcross", "vv", [](Call c) { return fromVector(glm::cross(c.vector(0), c.vector(1))); }},
        {"vnormalize", "v", normalized},
        {"vrotate", "vv",
         [](Call c) { return fromVector(Transform::rotation(c.vector(1)).point(c.vector(0))); }},
        {"vturbulence", "fffv", vectorTurbulence},
    };
    return table;
}

const ExpressionFunction* findExpressionFunction(std::string_view name) {
    static const std::unordered_map<std::string_view, const ExpressionFunction*> byName = [] {
        std::unordered_map<std::string_view, const ExpressionFunction*> functions;
        for (const auto* table : {&floatFunctions(), &vectorFunctions(), &stringFunctions()})
            for (const ExpressionFunction& function : *table) functions.emplace(function.name, &function);
        return functions;
    }();
    const auto found = byName.find(name);
    return found == byName.end() ? nullptr : found->second;
}

}  // namespace isoscope
