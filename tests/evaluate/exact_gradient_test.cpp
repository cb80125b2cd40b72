// SPDX-License-Identifier: GPL-3.0-or-later
// Gradients against derivatives at 200 bits: those over boxes hold them, those at points are near them, on
// every instruction set in turn.
#include <cmath>
#include <QTest>

#include "core/evaluate/gradient_evaluator.h"
#include "core/evaluate/interval_gradient_evaluator.h"
#include "tests/support/exact_line.h"
#include "tests/support/exact_pieces.h"
#include "tests/support/instruction_sets.h"
#include "tests/support/random_function.h"
#include "tests/support/test_setting.h"

using namespace isoscope;
using namespace isoscope::test;

namespace {

constexpr std::uint64_t defaultSeed = 17320508;
constexpr double defaultGraphs = 4000;

/// Every operation that exact jets have a rule for.
RandomFunctionSettings coveredOperations() {
    RandomFunctionSettings settings;
    settings.loops = false;
    settings.parameters = 0;
    for (int k = 0; k < operationCount; ++k)
        if (hasExactRule(static_cast<Operation>(k))) settings.operations.push_back(static_cast<Operation>(k));
    return settings;
}

/// The derivative along an axis at a point; none where there is none.
std::optional<ExactRange> exactSlope(const Function& function, const glm::dvec3& point, int axis) {
    glm::dvec3 direction(0);
    direction[axis] = 1;
    ExactLine line(function, {}, {point, direction, 0, 1}, 0);
    const ExactJet& jet = line.at(0);
    // GradientEvaluator counts no steeper slopes, on the way either.
    if (!jet.isSloped || !line.isWithin(GradientEvaluator::steepest / 10)) return {};
    // At a kink the derivatives beside it are hulled.
    ExactNumber width;
    mpfr_sub(width.get(), jet.slope.high.get(), jet.slope.low.get(), MPFR_RNDU);
    if (mpfr_cmp_d(width.get(), 1e-30) > 0) return {};
    return jet.slope;
}

struct Counts {
    int slopes = 0, bounded = 0, points = 0;
};

/// The gradient over a box, at points of it; empty if it holds the exact ones.
QString checkBox(const Function& function, const std::shared_ptr<const Tape>& tape, std::mt19937_64& random,
                 Counts& counts) {
    IntervalGradientEvaluator evaluator(tape, {});
    std::array<Interval, 3> box;
    for (Interval& side : box) {
        const double middle = uniform(random, -4, 4), radius = std::pow(10.0, uniform(random, -6, 0.3));
        side = {middle - radius, middle + radius, false};
    }
    const IntervalGradient found = evaluator.evaluate(std::span<const Interval, 3>(box));
    counts.bounded += found.bounded();
    for (int sample = 0; sample < 4; ++sample) {
        glm::dvec3 point;
        for (int axis = 0; axis < 3; ++axis) {
            const Interval& side = box[static_cast<std::size_t>(axis)];
            point[axis] = sample == 0 ? side.low : uniform(random, side.low, side.high);
        }
        for (int axis = 0; axis < 3; ++axis) {
            const std::optional<ExactRange> exact = exactSlope(function, point, axis);
            if (!exact) continue;
            ++counts.slopes;
            const SlopeRange& range = found.slope[static_cast<std::size_t>(axis)];
            if (mpfr_cmp_d(exact->high.get(), range.low) < 0 || mpfr_cmp_d(exact->low.get(), range.high) > 0)
                return QString::asprintf("[%.17g, %.17g] does not hold the slope %.17g along axis %d",
                                         range.low, range.high, exact->low.rounded(), axis);
        }
    }
    return {};
}

/// Gradients at points, where the function is tame around them: within a relative error that no cancellation
/// explains.
QString checkPoints(const Function& function, const std::shared_ptr<const Tape>& tape,
                    std::mt19937_64& random, Counts& counts) {
    GradientEvaluator gradients(tape, {});
    IntervalGradientEvaluator boxes(tape, {});
    for (int sample = 0; sample < 4; ++sample) {
        glm::dvec3 p;
        std::array<Interval, 3> box;
        for (int axis = 0; axis < 3; ++axis) {
            p[axis] = uniform(random, -4, 4);
            box[static_cast<std::size_t>(axis)] = Interval::point(p[axis]);
        }
        const IntervalGradient range = boxes.evaluate(std::span<const Interval, 3>(box));
        if (!range.bounded()) continue;
        ValueAndGradient found;
        const std::array x{p.x}, y{p.y}, z{p.z};
        gradients.evaluate(x, y, z, {&found, 1});
        for (std::size_t axis = 0; axis < 3; ++axis) {
            // What rounding leaves open, as the enclosure at the point tells, and as much again.
            const double low = range.slope[axis].low, high = range.slope[axis].high;
            const double slack = 4 * (high - low) + 1e-12 * (std::abs(low) + std::abs(high)) + 1e-300;
            const double slope = found.gradient[axis];
            if (!exactSlope(function, p, static_cast<int>(axis))) continue;
            ++counts.points;
            if (!(low - slack <= slope && slope <= high + slack))
                return QString::asprintf("the slope %.17g along axis %zu is not in [%.17g, %.17g]", slope,
                                         axis, low, high);
        }
    }
    return {};
}

}  // namespace

class ExactGradientTest : public QObject {
    Q_OBJECT

  private slots:
    void gradientsHoldExactDerivatives() {
        const std::uint64_t seed = seedSetting(defaultSeed);
        const double wanted = setting("ISOSCOPE_GRADIENT_GRAPHS", defaultGraphs);
        qInfo("seed %llu, %g graphs", static_cast<unsigned long long>(seed), wanted);
        std::mt19937_64 random(seed);
        RandomFunctionSettings settings = coveredOperations();
        const auto sets = instructionSets();
        Counts counts;
        for (double graph = 0; graph < wanted; ++graph) {
            const auto& [set, setName] = sets[static_cast<std::size_t>(graph) % sets.size()];
            const ForcedInstructionSet forced(set);
            settings.nodes = 1 + static_cast<int>(random() % 12);
            Function function = randomFunction(random, settings);
            function.results.resize(1);
            const auto tape = Tape::compile(function);
            for (const auto check : {checkBox, checkPoints}) {
                const QString problem = check(function, tape, random, counts);
                QVERIFY2(problem.isEmpty(),
                         qPrintable(QString::asprintf("graph %g, %s: ", graph, setName) + problem + "\n" +
                                    QString::fromStdString(describe(function))));
            }
        }
        qInfo("%d slopes in boxes, %d at points; %d boxes bounded", counts.slopes, counts.points,
              counts.bounded);
        QVERIFY(counts.slopes > 3 * wanted && counts.points > wanted);
    }
};

QTEST_APPLESS_MAIN(ExactGradientTest)
#include "exact_gradient_test.moc"
