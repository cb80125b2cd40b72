// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <random>
#include <vector>
#include <QString>

#include "core/evaluate/gradient_evaluator.h"
#include "core/evaluate/interval_gradient_evaluator.h"
#include "core/evaluate/reference_evaluator.h"
#include "core/function/graph_builder.h"
#include "tests/support/random_function.h"

/// What IntervalGradientEvaluator says of boxes, held against values and gradients at points of them.
namespace isoscope::test {

/// Of the random functions.
inline const std::vector<double> parameters{1.5, -2, 0.3};

using Box = std::array<Interval, 3>;
using Point = std::array<double, 3>;

/// A cube about a place at most `reach` from the origin along each axis; 10^smallest to 10^largest is half
/// its edge.
inline Box boxAround(std::mt19937_64& random, double reach, double smallest, double largest) {
    Box box;
    const double size = std::pow(10.0, std::uniform_real_distribution<double>(smallest, largest)(random));
    for (Interval& axis : box) {
        const double center = std::uniform_real_distribution<double>(-reach, reach)(random);
        axis = {center - size, center + size, false};
    }
    return box;
}

inline Point inside(std::mt19937_64& random, const Box& box) {
    Point p;
    for (int k = 0; k < 3; ++k)
        p[k] = std::uniform_real_distribution<double>(box[k].low, box[k].high)(random);
    return p;
}

/// Of x, y and z: what `make` makes of three Expressions.
template <class Make>
Function functionOf(Make make) {
    FunctionGraph graph;
    const Expression x(graph, graph.variable(0)), y(graph, graph.variable(1)), z(graph, graph.variable(2));
    const NodeId root = Expression(make(x, y, z)).node();
    return finish(std::move(graph), {root}, 3);
}

template <class Make>
IntervalGradient over(Make make, const Box& box) {
    return IntervalGradientEvaluator(Tape::compile(functionOf(make)), {}).evaluate(box);
}

inline constexpr Interval unit{-1, 1, false};

/// What a function must obey on a box; counts what could be checked.
struct Checks {
    int values = 0, climbs = 0, slopes = 0, bends = 0;
    int finer = 0;  ///< boxes of which UnivariateParts know more
};

/// Whether a gradient is not that of the function, by differences over a millionth: the evaluator at points
/// cuts off slopes beyond a limit wherever they come up, and follows operands that have no value.
inline bool isCutOff(ReferenceEvaluator& reference, const ValueAndGradient& found, const Point& p) {
    constexpr double step = 1e-6, part = 1e-5, largest = 1e6;
    if (std::abs(found.value) > largest) return true;
    const double rounding = 1e-8 * (1 + std::abs(found.value));
    for (std::size_t i = 0; i < 3; ++i) {
        Point before = p, behind = p;
        before[i] -= step;
        behind[i] += step;
        const double slope =
            (reference.evaluate(behind, parameters) - reference.evaluate(before, parameters)) / (2 * step);
        if (std::abs(slope - found.gradient[i]) >
            part * (std::abs(slope) + std::abs(found.gradient[i])) + rounding)
            return true;
    }
    return false;
}

/// Empty when `answer` holds for the function at the two points, else what does not.
inline QString contradiction(const IntervalGradient& answer, ReferenceEvaluator& reference,
                             GradientEvaluator& gradient, const Point& p, const Point& q, Checks& checks) {
    const double fp = reference.evaluate(p, parameters), fq = reference.evaluate(q, parameters);
    if (std::isfinite(fp)) {
        ++checks.values;
        const double rounding = 1e-9 * (1 + std::abs(fp));
        if (!(fp >= answer.value.low - rounding && fp <= answer.value.high + rounding))
            return QString("value (%1, %2 to %3)").arg(fp).arg(answer.value.low).arg(answer.value.high);
    }
    if (!answer.bounded() || answer.value.maybeUndefined || !std::isfinite(fp) || !std::isfinite(fq))
        return {};
    const double way = std::hypot(p[0] - q[0], p[1] - q[1], p[2] - q[2]);
    const double rounding = 1e-9 * (1 + std::abs(fp) + std::abs(fq));
    ++checks.climbs;
    if (std::abs(fp - fq) > answer.steepness * way * (1 + 1e-9) + rounding)
        return QString("steepness (%1 by %2)").arg(std::abs(fp - fq)).arg(answer.steepness * way);
    const ValueAndGradient gp = gradient.evaluate(p[0], p[1], p[2]), gq = gradient.evaluate(q[0], q[1], q[2]);
    const auto& a = gp.gradient;
    const double slack = 1e-9 * (1 + answer.steepness);
    if (answer.steepness >= GradientEvaluator::steepest) return {};
    ++checks.slopes;
    // Asked only where something does not hold.
    const auto unless = [&](QString wrong) {
        return isCutOff(reference, gp, p) || isCutOff(reference, gq, q) ? QString() : wrong;
    };
    const double length = std::hypot(a[0], a[1], a[2]);
    if (length > answer.steepness + slack)
        return unless(QString("length (%1, %2)").arg(length).arg(answer.steepness));
    for (int i = 0; i < 3; ++i)
        if (const SlopeRange& slope = answer.slope[i];
            !(a[i] >= slope.low - slack && a[i] <= slope.high + slack))
            return unless(QString("slope (%1, %2 to %3)").arg(a[i]).arg(slope.low).arg(slope.high));
    if (!answer.smooth || answer.pieced) return {};
    ++checks.bends;
    // Gradient noise rounds coordinates to multiples of 2^-29 (gradientNoiseBounds).
    constexpr double rounded = 0x1p-29;
    for (int i = 0; i < 3; ++i) {
        double most = slack;
        for (int j = 0; j < 3; ++j)
            most += answer.bend[bendIndex(i, j)].size() * (std::abs(p[j] - q[j]) * (1 + 1e-9) + rounded);
        if (std::abs(a[i] - gq.gradient[i]) > most)
            return unless(QString("bend (%1 by %2)").arg(std::abs(a[i] - gq.gradient[i])).arg(most));
    }
    return {};
}

/// Random functions, as `draw` makes them of a generator that begins at `start`, over three boxes each: what
/// is known at once, what evaluateFinely() knows, and evaluateAboutMiddle(). Nothing is counted if anything
/// does not hold, which is told.
template <class Draw>
Checks holdForAll(int rounds, std::uint64_t start, Draw draw) {
    std::mt19937_64 random(start);
    Checks checks;
    for (int round = 0; round < rounds; ++round) {
        const Function function = draw(random);
        const auto tape = Tape::compile(function);
        IntervalGradientEvaluator evaluator(tape, parameters);
        ReferenceEvaluator reference(function);
        GradientEvaluator gradient(tape, parameters);
        for (int tries = 0; tries < 3; ++tries) {
            const Box box = boxAround(random, 3, -5, 0.3);
            const IntervalGradient answer = evaluator.evaluate(box), finer = evaluator.evaluateFinely(box);
            const IntervalGradient aboutMiddle = evaluator.evaluateAboutMiddle(box);
            checks.finer += finer.steepness < answer.steepness ? 1 : 0;
            for (int pair = 0; pair < 6; ++pair) {
                const Point p = inside(random, box), q = inside(random, box);
                QString wrong = contradiction(answer, reference, gradient, p, q, checks);
                Checks others;
                if (wrong.isEmpty()) wrong = contradiction(finer, reference, gradient, p, q, others);
                if (!(finer.steepness <= answer.steepness)) wrong = "finer";
                if (wrong.isEmpty()) wrong = contradiction(aboutMiddle, reference, gradient, p, q, others);
                if (wrong.isEmpty()) continue;
                qCritical("%s is wrong at %a %a %a in [%a,%a]x[%a,%a]x[%a,%a] for\n%s", qPrintable(wrong),
                          p[0], p[1], p[2], box[0].low, box[0].high, box[1].low, box[1].high, box[2].low,
                          box[2].high, describe(function).c_str());
                return {};
            }
        }
    }
    return checks;
}

}  // namespace isoscope::test
