// SPDX-License-Identifier: GPL-3.0-or-later
// Noise and its fractal sums (docs/povray/noise.md, section 8). A constant number of octaves is unrolled as
// it is; another one is unrolled to `variableCountLimit`, each octave guarded by the number.
#include <algorithm>
#include <cmath>

#include "core/function/builtins/builtin.h"
#include "core/function/builtins/builtin_formulas.h"
#include "core/numeric/noise.h"

namespace isoscope {

namespace {

/// A constant generator number in its canonical form, so that equal noise is one node.
Expression canonicalGenerator(Expression generator) {
    if (!isConstant(generator)) return generator;
    return generator.number(noiseGeneratorNumber(constantOr(generator, 0)));
}

/// Noise of the call's parameter P5 at the point times `factor`.
Expression scaledNoise(const BuiltinCall& call, Expression factor) {
    return noise(canonicalGenerator(call.p[5]), factor * call.x, factor * call.y, factor * call.z);
}

Expression plainNoise(const BuiltinCall& call) {
    return noise(canonicalGenerator(call.p[5]), call.x, call.y, call.z);
}

/// Highest octave to unroll for a count of this value.
int octavesToUnroll(Expression count) {
    if (!isConstant(count)) return variableCountLimit;
    const double value = constantOr(count, 0);
    return std::isnan(value) ? 0 : static_cast<int>(std::clamp(std::ceil(value), 0.0, double(octaveLimit)));
}

/// `next` where index < count, else `previous`; decided here when the count is constant, as only octaves
/// below it are unrolled then.
Expression whileBelow(int index, Expression count, Expression next, Expression previous) {
    return isConstant(count) ? next : select(index - count, next, previous);
}

/// `with` where the remainder is not 0, else `without`.
Expression whenFractional(Expression remainder, Expression with, Expression without) {
    if (isConstant(remainder)) return constantOr(remainder, 0) != 0 ? with : without;
    return select(remainder, with, without, with);
}

Expression truncated(Expression a) { return apply(Operation::truncate, a); }

/// v to the whole part of `exponent`, at least to 0; by multiplication when it is a small constant.
Expression wholePower(Expression v, Expression exponent) {
    const Expression whole = max(v.number(0), truncated(exponent));
    const double known = constantOr(whole, 9);
    return known <= 8 ? powi(v, static_cast<int>(known)) : pow(v, whole);
}

Expression heteroMultifractal(const BuiltinCall& call) {
    const auto& p = call.p;
    const Expression &lacunarity = p[1], &octaves = p[2], &offset = p[3];
    const Expression falloff = pow(lacunarity, -p[0]);
    const auto signedNoise = [&](Expression factor) { return 2 * scaledNoise(call, factor) - 1 + offset; };

    Expression v = 2 * plainNoise(call) - 1 + offset;
    // Frequency and weight of the octave behind the last one.
    Expression frequency = lacunarity, weight = falloff;
    Expression nextFrequency = frequency, nextWeight = weight;
    const int steps = isConstant(octaves) ? octavesToUnroll(octaves) : variableCountLimit;
    for (int i = 1; i < steps; ++i) {
        const Expression c = signedNoise(frequency) * weight;
        v = whileBelow(i, octaves, v + c * wholePower(v, p[4]), v);
        frequency = frequency * lacunarity;
        weight = weight * falloff;
        nextFrequency = whileBelow(i, octaves, frequency, nextFrequency);
        nextWeight = whileBelow(i, octaves, weight, nextWeight);
    }
    const Expression remainder = octaves - truncated(octaves);
    return whenFractional(remainder, v + remainder * signedNoise(nextFrequency) * nextWeight * v, v);
}

Expression ridge(const BuiltinCall& call) {
    const auto& p = call.p;
    const Expression &lambda = p[0], &octaves = p[1], &omega = p[2], &offset = p[3], &level = p[4];
    const Expression range = max(level, 1 - level);
    const auto height = [&](Expression value) { return abs(value - level) / range - offset; };

    Expression v = height(plainNoise(call));
    Expression total = v.number(1);
    Expression frequency = lambda, weight = omega;
    Expression nextFrequency = frequency, nextWeight = weight;
    const Expression whole = truncated(octaves);
    // Octave i counts where i <= whole, which is i - 1 < whole.
    for (int i = 2; i <= octavesToUnroll(whole); ++i) {
        v = whileBelow(i - 1, whole, v + weight * height(scaledNoise(call, frequency)), v);
        total = whileBelow(i - 1, whole, total + weight, total);
        frequency = frequency * lambda;
        weight = weight * omega;
        nextFrequency = whileBelow(i - 1, whole, frequency, nextFrequency);
        nextWeight = whileBelow(i - 1, whole, weight, nextWeight);
    }
    const Expression remainder = octaves - whole;
    const Expression part = remainder * nextWeight;
    v = whenFractional(remainder, v + part * height(scaledNoise(call, nextFrequency)), v);
    total = whenFractional(remainder, total + part, total);
    return v / (max(offset, 1 - offset) * total);
}

Expression ridgedMultifractal(const BuiltinCall& call) {
    const auto& p = call.p;
    const Expression &lacunarity = p[1], &octaves = p[2], &offset = p[3], &gain = p[4];
    const auto ridgeOf = [&](Expression value) { return sq(offset - abs(2 * value - 1)); };

    Expression s = ridgeOf(plainNoise(call));
    Expression v = s;
    Expression frequency = lacunarity;
    for (int i = 1; i < octavesToUnroll(octaves); ++i) {
        const Expression gate = clamp(gain * s, s.number(0), s.number(1));
        s = gate * ridgeOf(scaledNoise(call, frequency));
        v = whileBelow(i, octaves, v + s * pow(frequency, -p[0]), v);
        frequency = frequency * lacunarity;
    }
    return v;
}

Expression sceneNoise(const BuiltinCall& call) {
    return noise(call.x.number(call.noiseGenerator), call.x, call.y, call.z);
}

/// internal(77) evaluates the pattern of a pattern function; called without one it is 0.
Expression missingPattern(const BuiltinCall& call) { return call.x.number(0); }

Expression chosenNoise(const BuiltinCall& call) {
    return noise(canonicalGenerator(call.p[0]), call.x, call.y, call.z);
}

constexpr NumberedFormula formulas[] = {
    {29, heteroMultifractal}, {58, ridge},          {59, ridgedMultifractal},
    {76, sceneNoise},         {77, missingPattern}, {78, chosenNoise},
};

}  // namespace

std::span<const NumberedFormula> fractalFormulas() { return formulas; }

}  // namespace isoscope
