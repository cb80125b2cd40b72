// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/function/scalar_operations.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numbers>

#include "core/numeric/crackle.h"
#include "core/numeric/noise.h"

namespace isoscope {

namespace {

#define ISOSCOPE_ONE(operation) +1
static_assert(0 ISOSCOPE_SLOPED_OPERATIONS(ISOSCOPE_ONE, ISOSCOPE_ONE)
                      ISOSCOPE_OTHER_OPERATIONS(ISOSCOPE_ONE, ISOSCOPE_ONE) ==
                  std::ranges::count_if(operationTable,
                                        [](const OperationFacts& facts) {
                                            return facts.arity == 1 || facts.arity == 2;
                                        }),
              "the lists of operations of one and two operands name each of them");
#undef ISOSCOPE_ONE

/// Truncation through a 32-bit integer; what does not fit gives the smallest one, as x86 does.
double truncate32(double a) {
    const bool fits = a > -2147483649.0 && a < 2147483648.0;
    return fits ? static_cast<double>(static_cast<std::int32_t>(a)) : -2147483648.0;
}

double fraction(double a) { return a - std::floor(a); }

double triangleWave(double a) {
    const double part = fraction(a);
    return part - 0.5 < 0 ? 2 * part : 2 * (1 - part);
}

double cycle(double a) {
    const double sine = std::sin(2 * std::numbers::pi * fraction(std::abs(a)));
    return a < 0 ? -sine : sine;
}

double crackleValue(const CrackleSettings& settings, double x, double y, double z) {
    if (settings.table) return settings.table->value({x, y, z});
    if (settings.cells) return cellValue(x, y, z);
    const CrackleDistances found = crackleDistances(x, y, z, settings.metric, settings.offset);
    if (settings.solid) {
        const auto& [i, j, k] = found.points[0];
        return noise(settings.noiseGenerator, i, j, k);
    }
    const double value =
        settings.form[0] * found.d[0] + settings.form[1] * found.d[1] + settings.form[2] * found.d[2];
    return std::clamp(value, 0.0, 1.0);
}

std::array<double, 3> crackleDifferences(const CrackleSettings& settings, const std::array<double, 3>& point,
                                         double step) {
    std::array<double, 3> slopes;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        std::array<double, 3> low = point, high = point;
        low[axis] -= step;
        high[axis] += step;
        const double rise = crackleValue(settings, high[0], high[1], high[2]) -
                            crackleValue(settings, low[0], low[1], low[2]);
        slopes[axis] = rise / (high[axis] - low[axis]);
    }
    return slopes;
}

/// Of (|dx|^m + |dy|^m + |dz|^m + o^m)^(1/m) along one axis, by the derivative |dx|^(m-1) / d^(m-1).
double distanceSlope(double apart, double distance, double metric) {
    if (metric == 2) return apart / distance;
    return std::copysign(std::pow(std::abs(apart) / distance, metric - 1), apart);
}

/// Without the clip.
std::array<double, 3> distanceSlopes(const CrackleSettings& settings, const std::array<double, 3>& point,
                                     const CrackleDistances& found) {
    std::array<double, 3> slopes{};
    for (std::size_t k = 0; k < 3; ++k) {
        if (settings.form[k] == 0) continue;
        for (std::size_t axis = 0; axis < 3; ++axis)
            slopes[axis] += settings.form[k] *
                            distanceSlope(point[axis] - found.points[k][axis], found.d[k], settings.metric);
    }
    return slopes;
}

}  // namespace

std::array<double, 3> crackleGradient(const CrackleSettings& settings, const std::array<double, 3>& point,
                                      double step) {
    std::array<double, 3> slopes{};
    if (settings.table || settings.cells || settings.solid) {
        slopes = crackleDifferences(settings, point, step);
    } else {
        const CrackleDistances found =
            crackleDistances(point[0], point[1], point[2], settings.metric, settings.offset);
        const auto& [f, g, h] = settings.form;
        const double value = f * found.d[0] + g * found.d[1] + h * found.d[2];
        if (value > 0 && value < 1) slopes = distanceSlopes(settings, point, found);
    }
    for (double& slope : slopes)
        if (!std::isfinite(slope)) slope = 0;
    return slopes;
}

double evaluateOperation(Operation operation, std::span<const double> operands,
                         const CrackleSettings* crackle) {
    const double a = operands[0];
    const double b = operands.size() > 1 ? operands[1] : 0;
    const double c = operands.size() > 2 ? operands[2] : 0;
    const double d = operands.size() > 3 ? operands[3] : 0;
    switch (operation) {
        case Operation::negate: return -a;
        case Operation::absolute: return std::abs(a);
        case Operation::square: return a * a;
        case Operation::squareRoot: return std::sqrt(a);
        case Operation::exponential: return std::exp(a);
        case Operation::naturalLogarithm: return std::log(a);
        case Operation::decimalLogarithm: return std::log10(a);
        case Operation::sine: return std::sin(a);
        case Operation::cosine: return std::cos(a);
        case Operation::tangent: return std::tan(a);
        case Operation::arcSine: return std::asin(a);
        case Operation::arcCosine: return std::acos(a);
        case Operation::arcTangent: return std::atan(a);
        case Operation::hyperbolicSine: return std::sinh(a);
        case Operation::hyperbolicCosine: return std::cosh(a);
        case Operation::hyperbolicTangent: return std::tanh(a);
        case Operation::areaSine: return std::asinh(a);
        case Operation::areaCosine: return std::acosh(a);
        case Operation::areaTangent: return std::atanh(a);
        case Operation::floor: return std::floor(a);
        case Operation::ceiling: return std::ceil(a);
        case Operation::truncate: return truncate32(a);
        case Operation::fraction: return fraction(a);
        case Operation::triangleWave: return triangleWave(a);
        case Operation::cycle: return cycle(a);
        case Operation::add: return a + b;
        case Operation::subtract: return a - b;
        case Operation::multiply: return a * b;
        case Operation::divide: return a / b;
        case Operation::power: return std::pow(a, b);
        case Operation::arcTangent2: return std::atan2(a, b);
        case Operation::remainder: return std::fmod(a, b);
        case Operation::integerDivide: return truncate32(a / b);
        case Operation::minimum: return a <= b ? a : b;
        case Operation::maximum: return a < b ? b : a;
        case Operation::equal: return a == b;
        case Operation::notEqual: return a != b;
        case Operation::less: return a < b;
        case Operation::lessEqual: return a <= b;
        case Operation::greater: return !(a <= b);
        case Operation::greaterEqual: return !(a < b);
        case Operation::logicalAnd: return a != 0 && b != 0;
        case Operation::logicalOr: return a != 0 || b != 0;
        case Operation::select3: return a < 0 ? b : c;
        case Operation::select4: return a < 0 ? b : a == 0 ? c : d;
        case Operation::noise: return noise(a, b, c, d);
        case Operation::noiseGradientX: return vectorNoise(a, b, c)[0];
        case Operation::noiseGradientY: return vectorNoise(a, b, c)[1];
        case Operation::noiseGradientZ: return vectorNoise(a, b, c)[2];
        case Operation::crackle: return crackleValue(*crackle, a, b, c);
        default: return std::numeric_limits<double>::quiet_NaN();
    }
}

}  // namespace isoscope
