// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/exact_evaluator.h"

#include <array>
#include <cmath>

#include "core/function/scalar_operations.h"
#include "core/numeric/noise_gradient.h"

namespace isoscope::test {

namespace {

using Unary = int (*)(mpfr_ptr, mpfr_srcptr, mpfr_rnd_t);

ExactNumber truth(bool value) { return ExactNumber(value ? 1 : 0); }

/// Truncation through a 32-bit integer.
ExactNumber truncate32(const ExactNumber& a) {
    ExactNumber result;
    mpfr_trunc(result.get(), a.get());
    const bool fits = !a.isNan() && mpfr_cmp_d(result.get(), -2147483648.0) >= 0 &&
                      mpfr_cmp_d(result.get(), 2147483647.0) <= 0;
    return fits ? result : ExactNumber(-2147483648.0);
}

int negated(mpfr_ptr result, mpfr_srcptr a, mpfr_rnd_t rounding) { return mpfr_neg(result, a, rounding); }
int floored(mpfr_ptr result, mpfr_srcptr a, mpfr_rnd_t) { return mpfr_floor(result, a); }
int ceiled(mpfr_ptr result, mpfr_srcptr a, mpfr_rnd_t) { return mpfr_ceil(result, a); }

int fraction(mpfr_ptr result, mpfr_srcptr a, mpfr_rnd_t rounding) {
    ExactNumber step;
    mpfr_floor(step.get(), a);
    return mpfr_sub(result, a, step.get(), rounding);
}
/// Twice the distance from the next whole number: a fraction of -1e-300 would be rounded to 1.
int triangleWave(mpfr_ptr result, mpfr_srcptr a, mpfr_rnd_t rounding) {
    ExactNumber next;
    mpfr_round(next.get(), a);
    mpfr_sub(result, a, next.get(), rounding);
    mpfr_abs(result, result, rounding);
    return mpfr_mul_ui(result, result, 2, rounding);
}
int cycle(mpfr_ptr result, mpfr_srcptr a, mpfr_rnd_t rounding) {
    const bool negative = mpfr_sgn(a) < 0;
    mpfr_abs(result, a, rounding);
    const ExactNumber size = [&] {
        ExactNumber copy;
        mpfr_set(copy.get(), result, rounding);
        return copy;
    }();
    fraction(result, size.get(), rounding);
    ExactNumber turn;
    mpfr_const_pi(turn.get(), rounding);
    mpfr_mul_ui(turn.get(), turn.get(), 2, rounding);
    mpfr_mul(result, result, turn.get(), rounding);
    mpfr_sin(result, result, rounding);
    return negative ? mpfr_neg(result, result, rounding) : 0;
}

Unary unaryOf(Operation operation) {
    switch (operation) {
        case Operation::negate: return negated;
        case Operation::absolute:
            return [](mpfr_ptr r, mpfr_srcptr a, mpfr_rnd_t m) { return mpfr_abs(r, a, m); };
        case Operation::square: return mpfr_sqr;
        case Operation::squareRoot: return mpfr_sqrt;
        case Operation::exponential: return mpfr_exp;
        case Operation::naturalLogarithm: return mpfr_log;
        case Operation::decimalLogarithm: return mpfr_log10;
        case Operation::sine: return mpfr_sin;
        case Operation::cosine: return mpfr_cos;
        case Operation::tangent: return mpfr_tan;
        case Operation::arcSine: return mpfr_asin;
        case Operation::arcCosine: return mpfr_acos;
        case Operation::arcTangent: return mpfr_atan;
        case Operation::hyperbolicSine: return mpfr_sinh;
        case Operation::hyperbolicCosine: return mpfr_cosh;
        case Operation::hyperbolicTangent: return mpfr_tanh;
        case Operation::areaSine: return mpfr_asinh;
        case Operation::areaCosine: return mpfr_acosh;
        case Operation::areaTangent: return mpfr_atanh;
        case Operation::floor: return floored;
        case Operation::fraction: return fraction;
        case Operation::triangleWave: return triangleWave;
        case Operation::cycle: return cycle;
        case Operation::ceiling: return ceiled;
        default: return nullptr;
    }
}

ExactNumber binary(Operation operation, const ExactNumber& a, const ExactNumber& b) {
    ExactNumber r;
    const bool ordered = !a.isNan() && !b.isNan();
    const int order = ordered ? mpfr_cmp(a.get(), b.get()) : 0;
    const auto nonZero = [](const ExactNumber& n) { return n.isNan() || mpfr_cmp_si(n.get(), 0) != 0; };
    switch (operation) {
        case Operation::add: mpfr_add(r.get(), a.get(), b.get(), MPFR_RNDN); return r;
        case Operation::subtract: mpfr_sub(r.get(), a.get(), b.get(), MPFR_RNDN); return r;
        case Operation::multiply: mpfr_mul(r.get(), a.get(), b.get(), MPFR_RNDN); return r;
        case Operation::divide: mpfr_div(r.get(), a.get(), b.get(), MPFR_RNDN); return r;
        case Operation::power: mpfr_pow(r.get(), a.get(), b.get(), MPFR_RNDN); return r;
        case Operation::arcTangent2: mpfr_atan2(r.get(), a.get(), b.get(), MPFR_RNDN); return r;
        case Operation::remainder: mpfr_fmod(r.get(), a.get(), b.get(), MPFR_RNDN); return r;
        case Operation::integerDivide: mpfr_div(r.get(), a.get(), b.get(), MPFR_RNDN); return truncate32(r);
        case Operation::minimum: return ordered && order <= 0 ? a : b;
        case Operation::maximum: return ordered && order < 0 ? b : a;
        case Operation::equal: return truth(ordered && order == 0);
        case Operation::notEqual: return truth(!ordered || order != 0);
        case Operation::less: return truth(ordered && order < 0);
        case Operation::lessEqual: return truth(ordered && order <= 0);
        case Operation::greater: return truth(!ordered || order > 0);
        case Operation::greaterEqual: return truth(!ordered || order >= 0);
        case Operation::logicalAnd: return truth(nonZero(a) && nonZero(b));
        case Operation::logicalOr: return truth(nonZero(a) || nonZero(b));
        default: mpfr_set_nan(r.get()); return r;
    }
}

/// A number so large or small that a function of it may need millions of digits of pi: such a point counts
/// as lying outside real arithmetic.
bool isBeyondReason(const ExactNumber& a) {
    return mpfr_regular_p(a.get()) != 0 && std::abs(mpfr_get_exp(a.get())) > 5000;
}

/// Noise computed at the rounded coordinates, taken from there to the exact ones along its slope: second
/// derivatives count for nothing over such a distance.
ExactNumber exactNoise(const NoiseGradient& noise, std::span<const ExactNumber> coordinates) {
    ExactNumber result(noise.value);
    for (std::size_t k = 0; k < 3; ++k) {
        const double rounded = coordinates[k].rounded();
        // Beyond its lattice noise has no slope.
        if (!(std::abs(rounded) < 2147483647.0)) continue;
        ExactNumber rest;
        mpfr_sub_d(rest.get(), coordinates[k].get(), rounded, MPFR_RNDN);
        mpfr_mul_d(rest.get(), rest.get(), noise.gradient[k], MPFR_RNDN);
        mpfr_add(result.get(), result.get(), rest.get(), MPFR_RNDN);
    }
    return result;
}

}  // namespace

ExactNumber evaluateExactly(Operation operation, std::span<const ExactNumber> operands,
                            const CrackleSettings* crackle) {
    if (const Unary function = unaryOf(operation)) {
        ExactNumber result;
        function(result.get(), operands[0].get(), MPFR_RNDN);
        return result;
    }
    const ExactNumber& a = operands[0];
    const bool negative = !a.isNan() && a.isNegative();
    switch (operation) {
        case Operation::truncate: return truncate32(a);
        case Operation::select3: return negative ? operands[1] : operands[2];
        case Operation::select4:
            return negative ? operands[1] : !a.isNan() && mpfr_zero_p(a.get()) ? operands[2] : operands[3];
        case Operation::noise:
            return exactNoise(noiseWithGradient(a.rounded(), operands[1].rounded(), operands[2].rounded(),
                                                operands[3].rounded()),
                              operands.subspan(1));
        case Operation::noiseGradientX:
        case Operation::noiseGradientY:
        case Operation::noiseGradientZ: {
            const int component = static_cast<int>(operation) - static_cast<int>(Operation::noiseGradientX);
            return exactNoise(
                vectorNoiseWithGradient(a.rounded(), operands[1].rounded(), operands[2].rounded())[component],
                operands);
        }
        case Operation::crackle: {
            std::array<double, 4> rounded{};
            for (std::size_t k = 0; k < operands.size(); ++k) rounded[k] = operands[k].rounded();
            return ExactNumber(
                evaluateOperation(operation, std::span(rounded).first(operands.size()), crackle));
        }
        default: return binary(operation, a, operands[1]);
    }
}

ExactNumber evaluateExactly(const Function& function, std::span<const ExactNumber> arguments,
                            std::span<const double> parameters, bool& regular) {
    const FunctionGraph& graph = *function.graph;
    const NodeId root = function.results[0];
    std::vector<bool> needed(root + 1, false);
    needed[root] = true;
    for (NodeId id = root + 1; id-- > 0;)
        if (needed[id])
            for (const NodeId operand : graph.operandsOf(id)) needed[operand] = true;
    std::vector<ExactNumber> values(root + 1);
    for (NodeId id = 0; id <= root; ++id) {
        if (!needed[id]) continue;
        const Node& node = graph[id];
        switch (node.operation) {
            case Operation::constant: values[id] = ExactNumber(node.value); continue;
            case Operation::variable: values[id] = arguments[node.index]; continue;
            case Operation::parameter: values[id] = ExactNumber(parameters[node.index]); continue;
            default: break;
        }
        std::vector<ExactNumber> operands;
        for (const NodeId operand : graph.operandsOf(id)) operands.push_back(values[operand]);
        const CrackleSettings* crackle =
            node.operation == Operation::crackle ? &graph.crackleSettings(node.index) : nullptr;
        values[id] = evaluateExactly(node.operation, operands, crackle);
        if (mpfr_inf_p(values[id].get())) regular = false;
        if (isBeyondReason(values[id])) {
            regular = false;
            return values[id];
        }
    }
    return values[root];
}

}  // namespace isoscope::test
