// SPDX-License-Identifier: GPL-3.0-or-later
// Turbulence, and the patterns made of noise.
#include <algorithm>

#include "core/function/builtins/formula_blocks.h"
#include "core/function/patterns/pattern_call.h"

namespace isoscope {

namespace {

constexpr int mostOctaves = 10;

int octaveCount(int octaves) { return std::clamp(octaves, 1, mostOctaves); }

Expression scaled(Expression coordinate, double factor) {
    return factor == 1 ? coordinate : factor * coordinate;
}

/// m(q) of scalar turbulence: generators above 1 are stretched.
Expression turbulenceTerm(const PatternCall& call, double factor) {
    const Expression value = patternNoise(call, factor);
    return call.generator > 1 ? 2 * value - 0.5 : value;
}

Expression unitClamp(Expression value) { return clamp(value, value.number(0), value.number(1)); }

Expression agate(const PatternCall& call) {
    const double amount = singlePrecision(call.pattern.agateTurbulence);
    const Expression c = 0.5 * (1 + cycle(1.3 * amount * turbulence(call) + 1.1 * call.z));
    // c is never negative and never above 1: the sine is not beyond +-1.
    return pow(c, c.number(0.77));
}

Expression granite(const PatternCall& call) {
    Expression sum = call.number(0);
    double frequency = 1;
    for (int i = 0; i < 6; ++i, frequency *= 2) {
        const Expression value = patternNoise(call, 4 * frequency);
        const Expression term = call.generator == 1 ? abs(0.5 - value) : min(abs(1 - 2 * value), 0.5);
        sum = i == 0 ? term : sum + term / frequency;
    }
    return sum;
}

Expression wrinkles(const PatternCall& call) {
    Expression sum = call.number(0);
    double frequency = 1;
    for (int i = 0; i < 10; ++i, frequency *= 2) {
        const Expression value = patternNoise(call, frequency);
        const Expression term = call.generator == 1 ? value : unitClamp(2 * value - 0.5);
        sum = i == 0 ? term : sum + term / frequency;
    }
    return 0.5 * sum;
}

Expression marble(const PatternCall& call) {
    const auto& amounts = call.pattern.turbulence;
    return amounts && (*amounts)[0] != 0 ? call.x + (*amounts)[0] * turbulence(call) : call.x;
}

Expression wood(const PatternCall& call) {
    const auto& amounts = call.pattern.turbulence;
    if (!amounts) return length(call.x, call.y);
    const auto moved = [&](Expression coordinate, std::size_t axis) {
        return coordinate + cycle((coordinate + turbulenceComponent(call, axis)) * (*amounts)[axis]);
    };
    return length(moved(call.x, 0), moved(call.y, 1));
}

}  // namespace

Expression patternNoise(const PatternCall& call, double factor) {
    return noise(call.number(call.generator), scaled(call.x, factor), scaled(call.y, factor),
                 scaled(call.z, factor));
}

Expression turbulence(const PatternCall& call) {
    const double lambda = singlePrecision(call.pattern.lambda), omega = singlePrecision(call.pattern.omega);
    Expression sum = turbulenceTerm(call, 1);
    if (call.generator > 1) sum = unitClamp(sum);
    double frequency = lambda, weight = omega;
    for (int i = 2; i <= octaveCount(call.pattern.octaves); ++i, frequency *= lambda, weight *= omega)
        sum = sum + weight * turbulenceTerm(call, frequency);
    return sum;
}

Expression vectorTurbulence(const PatternPoint& point, std::size_t axis, int octaves, double lambda,
                            double omega) {
    constexpr Operation components[] = {Operation::noiseGradientX, Operation::noiseGradientY,
                                        Operation::noiseGradientZ};
    FunctionGraph& graph = point[0].graph();
    const auto term = [&](double factor) -> Expression {
        return {graph, graph.ternary(components[axis], scaled(point[0], factor).node(),
                                     scaled(point[1], factor).node(), scaled(point[2], factor).node())};
    };
    const double ratio = singlePrecision(lambda), decay = singlePrecision(omega);
    Expression sum = term(1);
    double frequency = ratio, weight = decay;
    for (int i = 2; i <= octaveCount(octaves); ++i, frequency *= ratio, weight *= decay)
        sum = sum + weight * term(frequency);
    return sum;
}

Expression turbulenceComponent(const PatternCall& call, std::size_t axis) {
    const Pattern& pattern = call.pattern;
    return vectorTurbulence({call.x, call.y, call.z}, axis, pattern.octaves, pattern.lambda, pattern.omega);
}

Expression noisePattern(const PatternCall& call) {
    switch (call.pattern.kind) {
        case PatternKind::agate: return agate(call);
        case PatternKind::dents: return powi(patternNoise(call), 3);
        case PatternKind::granite: return granite(call);
        case PatternKind::marble: return marble(call);
        case PatternKind::wood: return wood(call);
        case PatternKind::wrinkles: return wrinkles(call);
        default: return patternNoise(call);
    }
}

}  // namespace isoscope
