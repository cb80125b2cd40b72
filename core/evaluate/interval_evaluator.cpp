// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/evaluate/interval_evaluator.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "core/evaluate/algebra/affine_crackle.h"
#include "core/evaluate/algebra/affine_form.h"
#include "core/evaluate/prepared_function.h"
#include "core/function/scalar_operations.h"
#include "core/evaluate/tape/loop_range.h"
#include "core/evaluate/tape/loop_stop.h"
#include "core/numeric/noise.h"
#include "core/numeric/noise_bounds.h"

namespace isoscope {

namespace {

constexpr Interval truth{0, 1, false};
constexpr Interval yes{1, 1, false};
constexpr Interval no{0, 0, false};

/// `int` of a number.
Interval truncate32(const Interval& a) {
    constexpr double smallest = -2147483648.0;
    if (a.empty()) return Interval::point(smallest);
    const bool fits = a.low > -2147483649.0 && a.high < 2147483648.0;
    if (!fits || a.maybeUndefined) return {smallest, 2147483647.0, false};
    return {std::trunc(a.low), std::trunc(a.high), false};
}

/// a < b; an undefined side gives `otherwise`.
Interval less(const Interval& a, const Interval& b, const Interval& otherwise) {
    if (a.empty() || b.empty()) return otherwise;
    const Interval found = a.high < b.low ? yes : a.low >= b.high ? no : truth;
    return a.maybeUndefined || b.maybeUndefined ? hull(found, otherwise) : found;
}

Interval lessEqual(const Interval& a, const Interval& b, const Interval& otherwise) {
    if (a.empty() || b.empty()) return otherwise;
    const Interval found = a.high <= b.low ? yes : a.low > b.high ? no : truth;
    return a.maybeUndefined || b.maybeUndefined ? hull(found, otherwise) : found;
}

Interval equal(const Interval& a, const Interval& b) {
    if (a.empty() || b.empty()) return no;
    if (a.isPoint() && b.isPoint()) return a.low == b.low ? yes : no;
    return a.high < b.low || a.low > b.high ? no : truth;
}

Interval logicalNot(const Interval& a) { return {1 - a.high, 1 - a.low, false}; }

/// Whether a number counts as true: NaN does.
Interval isTrue(const Interval& a) {
    if (a.empty() || a.low > 0 || a.high < 0) return yes;
    return a.isPoint() ? no : truth;
}

/// a <= b ? a : b, and b where a side is undefined.
Interval minimum(const Interval& a, const Interval& b) {
    if (a.empty()) return b;
    if (b.empty()) return b;
    Interval result{std::min(a.low, b.low), std::min(a.high, b.high), b.maybeUndefined};
    if (a.maybeUndefined) result = hull(result, b);
    return result;
}

/// a < b ? b : a, and a where a side is undefined.
Interval maximum(const Interval& a, const Interval& b) {
    if (a.empty()) return a;
    if (b.empty()) return a;
    Interval result{std::max(a.low, b.low), std::max(a.high, b.high), a.maybeUndefined};
    if (b.maybeUndefined) result = hull(result, a);
    return result;
}

Interval select3(const Interval& a, const Interval& negative, const Interval& otherwise) {
    if (a.empty() || a.low >= 0) return otherwise;
    if (a.high < 0 && !a.maybeUndefined) return negative;
    return hull(negative, otherwise);
}

Interval select4(const Interval& a, const Interval& negative, const Interval& zero,
                 const Interval& otherwise) {
    if (a.empty() || a.low > 0) return otherwise;
    if (a.high < 0 && !a.maybeUndefined) return negative;
    if (a.low == 0 && a.high == 0 && !a.maybeUndefined) return zero;
    Interval result = Interval::undefined();
    bool first = true;
    const auto include = [&](bool possible, const Interval& branch) {
        if (!possible) return;
        result = first ? branch : hull(result, branch);
        first = false;
    };
    include(a.low < 0, negative);
    include(a.low <= 0 && a.high >= 0, zero);
    include(a.high > 0 || a.maybeUndefined, otherwise);
    return result;
}

/// Coordinates of a noise: how far it can get from its value at the center of the box.
struct NoiseBox {
    std::array<double, 3> center{};
    double reach = Interval::infinite;

    NoiseBox(std::span<const Interval> box, const NoiseBounds& bounds, bool shifted) {
        double sum = 0, squares = 0;
        for (std::size_t k = 0; k < 3; ++k) {
            const Interval& side = box[k];
            center[k] = side.low / 2 + side.high / 2;
            const double size = std::max(std::abs(side.low), std::abs(side.high));
            // Noise has no bounds worth knowing off its lattice, and its value at 0 where it gets no number.
            if (side.empty() || side.maybeUndefined || !(size < 2147483647.0)) return;
            // Coordinates of gradient noise are rounded at a distance of 10^7 from where they are.
            const double rounding = shifted ? (size + 10000001) * 2.3e-16 : 0;
            const double far = std::max(side.high - center[k], center[k] - side.low);
            // With room for the roundings of what is made of it.
            const double along = (far + size * 2.3e-16 + rounding) * (1 + 1e-14);
            sum += along;
            squares += along * along;
        }
        reach = std::min(sum * bounds.slope, std::sqrt(squares) * bounds.lipschitz);
    }

    Interval around(double value) const {
        return {value - reach - noiseRounding, value + reach + noiseRounding, false};
    }
};

Interval noiseRange(std::span<const Interval> operands) {
    if (!operands[0].isPoint()) return truth;
    const int generator = noiseGeneratorNumber(operands[0].low);
    const NoiseBox box(operands.subspan(1), unclippedNoiseBounds(generator), generator == 3);
    if (!(box.reach < 1)) return truth;
    const Interval range = box.around(noise(generator, box.center[0], box.center[1], box.center[2]));
    return {std::max(0.0, range.low), std::min(1.0, range.high), false};
}

Interval vectorNoiseRange(std::size_t component, std::span<const Interval> operands) {
    constexpr Interval anywhere{-vectorNoiseLimit, vectorNoiseLimit, false};
    const NoiseBox box(operands, latticeNoiseBounds, false);
    if (!(box.reach < 2 * vectorNoiseLimit)) return anywhere;
    const Interval range = box.around(vectorNoise(box.center[0], box.center[1], box.center[2])[component]);
    return {std::max(anywhere.low, range.low), std::min(anywhere.high, range.high), false};
}

/// Infinity is no number that could be bounded: of what it leads to nothing is known.
Interval uniformRange(double value) {
    return std::isinf(value) ? Interval::unknown() : Interval::point(value);
}

/// Around the form of crackle at a box, which has no slope.
Interval crackleNear(const CrackleSettings& settings, std::span<const Interval> operands) {
    std::array<AffineForm, 3> box;
    for (std::size_t k = 0; k < 3; ++k) {
        const double center = operands[k].low + (operands[k].high - operands[k].low) / 2;
        const double reach = std::max(operands[k].high - center, center - operands[k].low);
        box[k] = {center, 0, reach * (1 + 1e-15)};
    }
    const AffineForm form = affineCrackle(box, settings);
    if (!std::isfinite(form.e)) return truth;
    constexpr double rounding = 1e-15;
    return {std::max(0.0, form.a - form.e - rounding), std::min(1.0, form.a + form.e + rounding), false};
}

Interval crackleRange(const CrackleSettings& settings, std::span<const Interval> operands) {
    if (settings.table) return settings.table->range({operands[0], operands[1], operands[2]});
    // Beyond its lattice crackle is undefined.
    constexpr double limit = 4e18;
    bool defined = true;
    for (const Interval& operand : operands)
        defined = defined && !operand.maybeUndefined && !operand.empty() && operand.low >= -limit &&
                  operand.high <= limit;
    Interval result = truth;
    if (defined) result = crackleNear(settings, operands);
    // Other metrics and forms can leave 0..1 only through NaN.
    result.maybeUndefined = !defined || settings.metric != 2 || settings.offset != 0 || settings.solid;
    return result;
}

Interval twoOperands(Operation operation, const Interval& a, const Interval& b) {
    switch (operation) {
        case Operation::add: return a + b;
        case Operation::subtract: return a - b;
        case Operation::multiply: return a * b;
        case Operation::divide: return a / b;
        case Operation::power: return pow(a, b);
        case Operation::arcTangent2: return atan2(a, b);
        case Operation::remainder: return mod(a, b);
        case Operation::integerDivide: return truncate32(a / b);
        case Operation::minimum: return minimum(a, b);
        case Operation::maximum: return maximum(a, b);
        case Operation::equal: return equal(a, b);
        case Operation::notEqual: return logicalNot(equal(a, b));
        case Operation::less: return less(a, b, no);
        case Operation::lessEqual: return lessEqual(a, b, no);
        case Operation::greater: return logicalNot(lessEqual(a, b, no));
        case Operation::greaterEqual: return logicalNot(less(a, b, no));
        case Operation::logicalAnd: return minimum(isTrue(a), isTrue(b));
        case Operation::logicalOr: return maximum(isTrue(a), isTrue(b));
        default: return Interval::unknown();
    }
}

/// What a sum of a few numbers up to 1 may be off, in reals and as computed.
constexpr double unitError = 1e-15;

/// Between 0 and 1, whatever becomes of numbers that are too large.
Interval unitRange(const Interval& a) {
    const bool finite = std::isfinite(a.low) && std::isfinite(a.high);
    return {0, 1, a.maybeUndefined || !finite};
}

Interval fractionRange(const Interval& a) {
    const double step = std::floor(a.low);
    if (a.empty()) return a;
    if (!std::isfinite(step) || step != std::floor(a.high)) return unitRange(a);
    // Exact but for numbers right below 0, which it may take to 1.
    return {std::max(0.0, a.low - step - unitError), std::min(1.0, a.high - step + unitError),
            a.maybeUndefined};
}

Interval triangleRange(const Interval& a) {
    if (a.empty()) return a;
    const double first = std::floor(2 * a.low), last = std::floor(2 * a.high);
    if (!std::isfinite(first) || !(last - first <= 1)) return unitRange(a);
    const auto at = [](double t) {
        return evaluateOperation(Operation::triangleWave, std::span<const double>(&t, 1));
    };
    const double low = at(a.low), high = at(a.high);
    // A kink between both is at a half for even `first`.
    const bool kink = last > first, top = std::fmod(first, 2) == 0;
    return {kink && !top ? 0 : std::max(0.0, std::min(low, high) - unitError),
            kink && top ? 1 : std::min(1.0, std::max(low, high) + unitError), a.maybeUndefined};
}

Interval cycleRange(const Interval& a) {
    if (a.empty()) return a;
    if (!std::isfinite(a.low) || !std::isfinite(a.high)) return {-1, 1, true};
    constexpr double turn = 2 * std::numbers::pi;
    const Interval sine = sin(Interval{turn, std::nextafter(turn, 7), false} * a);
    return {std::max(-1.0, sine.low - 5 * unitError), std::min(1.0, sine.high + 5 * unitError),
            a.maybeUndefined};
}

Interval oneOperand(Operation operation, const Interval& a) {
    switch (operation) {
        case Operation::negate: return -a;
        case Operation::absolute: return abs(a);
        case Operation::square: return square(a);
        case Operation::squareRoot: return sqrt(a);
        case Operation::exponential: return exp(a);
        case Operation::naturalLogarithm: return log(a);
        case Operation::decimalLogarithm: return log10(a);
        case Operation::sine: return sin(a);
        case Operation::cosine: return cos(a);
        case Operation::tangent: return tan(a);
        case Operation::arcSine: return asin(a);
        case Operation::arcCosine: return acos(a);
        case Operation::arcTangent: return atan(a);
        case Operation::hyperbolicSine: return sinh(a);
        case Operation::hyperbolicCosine: return cosh(a);
        case Operation::hyperbolicTangent: return tanh(a);
        case Operation::areaSine: return asinh(a);
        case Operation::areaCosine: return acosh(a);
        case Operation::areaTangent: return atanh(a);
        case Operation::floor: return floor(a);
        case Operation::ceiling: return ceil(a);
        case Operation::truncate: return truncate32(a);
        case Operation::fraction: return fractionRange(a);
        case Operation::triangleWave: return triangleRange(a);
        case Operation::cycle: return cycleRange(a);
        default: return Interval::unknown();
    }
}

}  // namespace

Interval evaluateOperation(Operation operation, std::span<const Interval> operands,
                           const CrackleSettings* crackle) {
    switch (operation) {
        case Operation::select3: return select3(operands[0], operands[1], operands[2]);
        case Operation::select4: return select4(operands[0], operands[1], operands[2], operands[3]);
        case Operation::noise: return noiseRange(operands);
        case Operation::noiseGradientX: return vectorNoiseRange(0, operands);
        case Operation::noiseGradientY: return vectorNoiseRange(1, operands);
        case Operation::noiseGradientZ: return vectorNoiseRange(2, operands);
        case Operation::crackle: return crackleRange(*crackle, operands);
        default: break;
    }
    return operands.size() == 1 ? oneOperand(operation, operands[0])
                                : twoOperands(operation, operands[0], operands[1]);
}

IntervalEvaluator::IntervalEvaluator(std::shared_ptr<const Tape> tape, const UniformValues& uniforms)
    : tape_(std::move(tape)), slots_(tape_->slotCount()) {
    firstOperands_.reserve(tape_->instructions().size());
    std::uint32_t operands = 0;
    for (const Instruction& instruction : tape_->instructions()) {
        firstOperands_.push_back(operands);
        operands += instruction.operandCount;
    }
    operandRanges_.resize(operands);
    for (std::size_t k = 0; k < uniforms.values.size(); ++k)
        slots_[tape_->firstUniform() + k] = uniformRange(uniforms.values[k]);
    for (std::size_t k = 0; k < uniforms.loops.size(); ++k)
        loops_.push_back(std::make_unique<IntervalEvaluator>(tape_->loops()[k].body, uniforms.loops[k]));
}

IntervalEvaluator::IntervalEvaluator(const PreparedFunction& function)
    : IntervalEvaluator(function.tape(), function.uniforms()) {}

IntervalEvaluator::IntervalEvaluator(std::shared_ptr<const Tape> tape, std::span<const double> parameters)
    : IntervalEvaluator(tape, UniformValues(*tape, parameters)) {}

Interval IntervalEvaluator::evaluate(std::span<const Interval> arguments, std::size_t result) {
    forgetRanges();
    run(arguments, LoopRange::topAllowance);
    return slots_[tape_->results()[result]];
}

void IntervalEvaluator::forgetRanges() {
    for (Interval& range : operandRanges_) range = {Interval::infinite, -Interval::infinite, false};
    for (const auto& loop : loops_) loop->forgetRanges();
}

void IntervalEvaluator::run(std::span<const Interval> arguments, double loopAllowance) {
    const auto argumentCount = static_cast<std::size_t>(tape_->argumentCount());
    for (std::size_t k = 0; k < argumentCount; ++k)
        slots_[k] = k < arguments.size() ? arguments[k] : Interval::point(0);
    const std::span<const Instruction> instructions = tape_->instructions();
    for (std::size_t number = 0; number < instructions.size(); ++number) {
        const Instruction& instruction = instructions[number];
        std::array<Interval, 4> operands;
        for (std::size_t k = 0; k < instruction.operandCount; ++k) {
            operands[k] = slots_[instruction.operands[k]];
            Interval& range = operandRanges_[firstOperands_[number] + k];
            range = hull(range, operands[k]);
        }
        const bool isLoop =
            instruction.operation == Operation::sum || instruction.operation == Operation::product;
        const CrackleSettings* crackle =
            instruction.operation == Operation::crackle ? &tape_->crackle(instruction.index) : nullptr;
        slots_[instruction.target] =
            isLoop ? runLoop(instruction, loopAllowance)
                   : evaluateOperation(instruction.operation,
                                       std::span(operands).first(instruction.operandCount), crackle);
    }
}

Interval IntervalEvaluator::runLoop(const Instruction& instruction, double loopAllowance) {
    const TapeLoop& loop = tape_->loop(instruction.index);
    IntervalEvaluator& body = *loops_[instruction.index];
    std::vector<Interval> arguments(1);
    for (const Slot slot : loop.captured) arguments.push_back(slots_[slot]);
    const bool isSum = instruction.operation == Operation::sum;
    const Interval first = slots_[instruction.operands[0]], last = slots_[instruction.operands[1]];
    // The ranges inside hold for every step there may be.
    const auto anySteps = [&](const Interval& steps) {
        arguments[0] = steps;
        body.run(arguments, 0);
        return Interval::unknown();
    };
    if (!first.isPoint() || !last.isPoint()) {
        // The number of steps is open.
        const Interval steps = hull(first, last);
        return steps.empty() ? Interval::point(isSum ? 0 : 1) : anySteps(steps);
    }
    const LoopRange range(first.low, last.low, loopAllowance);
    if (range.tooLong()) return Interval::undefined();
    Interval total = Interval::point(isSum ? 0 : 1);
    if (!range.runs()) return total;
    for (double i = first.low; i <= last.low; i += 1) {
        if (LoopStop::requested()) return anySteps({i, last.low, false});
        arguments[0] = Interval::point(i);
        body.run(arguments, range.bodyAllowance());
        const Interval term = body.slots_[body.tape_->results()[0]];
        total = isSum ? total + term : total * term;
    }
    return total;
}

}  // namespace isoscope
