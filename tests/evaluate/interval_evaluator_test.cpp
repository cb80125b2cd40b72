// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/evaluate/interval_evaluator.h"

#include <cmath>
#include <QTest>

#include "core/evaluate/reference_evaluator.h"
#include "core/function/graph_builder.h"
#include "core/function/scalar_operations.h"
#include "tests/support/random_function.h"
#include "tests/support/test_setting.h"

using namespace isoscope;
using namespace isoscope::test;

namespace {

const std::uint64_t seed = seedSetting(90125);

/// An interval around `anyNumber`, of any width, with finite ends.
Interval anyInterval(std::mt19937_64& random) {
    double a = anyNumber(random);
    while (!std::isfinite(a)) a = anyNumber(random);
    switch (random() % 4) {
        case 0: return Interval::point(a);
        case 1: {
            double b = anyNumber(random);
            while (!std::isfinite(b)) b = anyNumber(random);
            return {std::min(a, b), std::max(a, b), false};
        }
        default: {
            const double radius = std::pow(10.0, std::uniform_real_distribution<double>(-6, 1)(random));
            return {a - radius, a + radius, false};
        }
    }
}

double inside(std::mt19937_64& random, const Interval& a) {
    switch (random() % 6) {
        case 0: return a.low;
        case 1: return a.high;
        default: break;
    }
    const double value = std::uniform_real_distribution<double>(0, 1)(random);
    return std::clamp(a.low * (1 - value) + a.high * value, a.low, a.high);
}

Interval operationOf(Operation operation, std::initializer_list<Interval> operands) {
    return evaluateOperation(operation, std::span(operands.begin(), operands.size()));
}

}  // namespace

class IntervalEvaluatorTest : public QObject {
    Q_OBJECT

  private slots:
    void initTestCase() { qInfo("seed %llu", static_cast<unsigned long long>(seed)); }

    void everyOperationHoldsItsValues() {
        std::mt19937_64 random(seed);
        const CrackleSettings crackle;
        for (int number = 0; number < operationCount; ++number) {
            const Operation operation = static_cast<Operation>(number);
            const int count = arity(operation);
            if (count <= 0) continue;
            const int rounds = operation == Operation::crackle ? 200 : 20000;
            for (int round = 0; round < rounds; ++round) {
                std::array<Interval, 4> boxes;
                for (Interval& box : boxes) box = anyInterval(random);
                const Interval range = evaluateOperation(operation, std::span(boxes).first(count), &crackle);
                for (int sample = 0; sample < 4; ++sample) {
                    std::array<double, 4> point;
                    for (int k = 0; k < 4; ++k) point[k] = inside(random, boxes[k]);
                    const double value =
                        evaluateOperation(operation, std::span(point).first(count), &crackle);
                    if (!range.holds(value))
                        QFAIL(qPrintable(QString::asprintf(
                            "%s([%a, %a], [%a, %a]) = [%a, %a] %d does not hold %a at %a %a",
                            std::string(name(operation)).c_str(), boxes[0].low, boxes[0].high, boxes[1].low,
                            boxes[1].high, range.low, range.high, range.maybeUndefined, value, point[0],
                            point[1])));
                }
            }
        }
    }

    void randomFunctionsHoldTheirValues() {
        std::mt19937_64 random(seed + 1);
        RandomFunctionSettings settings;
        for (int k = 0; k < operationCount; ++k)
            if (arity(static_cast<Operation>(k)) > 0 && static_cast<Operation>(k) != Operation::crackle)
                settings.operations.push_back(static_cast<Operation>(k));
        int useful = 0;
        for (int round = 0; round < 3000; ++round) {
            settings.nodes = 1 + static_cast<int>(random() % 12);
            const Function function = randomFunction(random, settings);
            const std::vector<double> parameters{1.5, -2, 0.3};
            IntervalEvaluator interval(Tape::compile(function), parameters);
            ReferenceEvaluator reference(function);
            std::array<Interval, 3> box;
            for (Interval& axis : box) {
                const double center = std::uniform_real_distribution<double>(-5, 5)(random);
                const double radius = std::pow(10.0, std::uniform_real_distribution<double>(-4, 0.5)(random));
                axis = {center - radius, center + radius, false};
            }
            const Interval range = interval.evaluate(box);
            useful += range.width() < 100;
            for (int sample = 0; sample < 10; ++sample) {
                const std::array<double, 3> point{inside(random, box[0]), inside(random, box[1]),
                                                  inside(random, box[2])};
                const double value = reference.evaluate(point, parameters);
                // An infinite intermediate value is outside real arithmetic.
                if (!std::isfinite(value)) continue;
                if (!range.holds(value))
                    QFAIL(qPrintable(QString::asprintf("round %d: [%a, %a] does not hold %a", round,
                                                       range.low, range.high, value)));
            }
        }
        QVERIFY2(useful > 1000, qPrintable(QString::number(useful)));
    }

    void pointsStayNarrow() {
        QVERIFY(operationOf(Operation::add, {Interval::point(0.1), Interval::point(0.2)}).width() < 2e-16);
        QVERIFY(operationOf(Operation::sine, {Interval::point(1)}).width() < 1e-14);
        QCOMPARE(operationOf(Operation::floor, {Interval{1.2, 1.7, false}}), Interval::point(1));
    }

    void productsThatUnderflowAreHeld() {
        const Interval tiny =
            operationOf(Operation::multiply, {Interval::point(-1e-200), Interval::point(1e-200)});
        QVERIFY(tiny.low < 0 && tiny.high == 0);
        const Interval positive =
            operationOf(Operation::multiply, {Interval::point(-1e-200), Interval::point(-1e-200)});
        QVERIFY(positive.low == 0 && positive.high > 0);
        QCOMPARE(operationOf(Operation::multiply, {Interval::point(0), {-3, 5, false}}),
                 (Interval{0, 0, false}));
    }

    void infiniteConstantsLeaveEverythingOpen() {
        // pow(x, 1/0) is 0 for 0 < x < 1, not undefined.
        FunctionGraph graph;
        const Expression x(graph, graph.variable(0));
        const NodeId root = cos(pow(x, x.number(INFINITY))).node();
        IntervalEvaluator evaluator(Tape::compile(finish(std::move(graph), {root}, 1)), {});
        QVERIFY(evaluator.evaluate({{Interval{0.2, 0.5, false}}}).holds(1));
    }

    void knowsWhereValuesAreUndefined() {
        QCOMPARE(operationOf(Operation::squareRoot, {Interval{-2, -1, false}}), Interval::undefined());
        QVERIFY(operationOf(Operation::squareRoot, {Interval{-1, 4, false}}).maybeUndefined);
        QVERIFY(!operationOf(Operation::squareRoot, {Interval{0, 4, false}}).maybeUndefined);
        QCOMPARE(operationOf(Operation::divide, {Interval::point(1), Interval{-1, 1, false}}),
                 Interval::unknown());
        QVERIFY(operationOf(Operation::arcSine, {Interval{2, 3, false}}).empty());
        // min takes the second operand when the first is undefined, max the first.
        const Interval two = Interval::point(2);
        QCOMPARE(operationOf(Operation::minimum, {Interval::undefined(), two}), two);
        QVERIFY(operationOf(Operation::minimum, {two, Interval::undefined()}).empty());
        QCOMPARE(operationOf(Operation::maximum, {two, Interval::undefined()}), two);
        QCOMPARE(operationOf(Operation::greater, {two, Interval::undefined()}), Interval::point(1));
        QCOMPARE(operationOf(Operation::less, {two, Interval::undefined()}), Interval::point(0));
        QCOMPARE(operationOf(Operation::select3, {Interval::undefined(), two, Interval::point(3)}),
                 Interval::point(3));
    }

    void keepsSquaresPositiveEverywhere() {
        FunctionGraph graph;
        const Expression x(graph, graph.variable(0)), y(graph, graph.variable(1));
        const NodeId root = sqrt(sq(x) + sq(y) + 1).node();
        IntervalEvaluator interval(Tape::compile(finish(std::move(graph), {root}, 3)), {});
        const std::array box{Interval::all(), Interval::all(), Interval::all()};
        const Interval range = interval.evaluate(box);
        QVERIFY(range.low > 0.999 && !range.maybeUndefined);
        QVERIFY(interval.operandRange(4, 0).low >= 0.999);
    }

    /// By its slope, however far from the origin.
    void noiseOfANarrowBoxIsNarrow() {
        for (const double sign : {1.0, -1.0})
            for (const double generator : {0.0, 1.0, 2.0, 3.0}) {
                const auto side = [sign](double at) {
                    return Interval{sign * at - 1e-4, sign * at + 1e-4, false};
                };
                const Interval range = operationOf(
                    Operation::noise, {Interval::point(generator), side(50.3), side(30.6), side(70.2)});
                QVERIFY2(range.width() > 0 && range.width() < 6e-3,
                         qPrintable(QString::number(range.width())));
            }
    }

    void cyclesStayBetweenTheirPeaks() {
        QVERIFY(operationOf(Operation::cycle, {Interval{0, 1, false}}) == (Interval{-1, 1, false}));
        QVERIFY(operationOf(Operation::cycle, {Interval{0.2, 0.3, false}}).high == 1.0);
        QVERIFY(operationOf(Operation::cycle, {Interval{0.7, 0.8, false}}).low == -1.0);
    }

    void crackleIsDefinedUpToTheEndsOfItsLattice() {
        const CrackleSettings crackle;
        constexpr double last = 4e18;
        const Interval unit{0, 1, false};
        const auto over = [&](const Interval& side) {
            const std::array box{unit, side, unit};
            return evaluateOperation(Operation::crackle, box, &crackle);
        };
        QVERIFY(over({-last, last, false}) == unit);
        for (const double end : {-last, last}) {
            const std::array point{0.5, end, 0.5};
            QVERIFY(std::isfinite(evaluateOperation(Operation::crackle, point, &crackle)));
            QVERIFY(over(Interval::point(std::nextafter(end, 2 * end))).maybeUndefined);
        }
    }

    void loopsWithoutBoundsHaveNoSteps() {
        for (const auto& [loop, empty] :
             {std::pair{Operation::sum, 0.0}, std::pair{Operation::product, 1.0}}) {
            FunctionGraph body;
            const NodeId term = body.unary(Operation::square, body.variable(0));
            FunctionGraph graph;
            const NodeId bound = graph.unary(Operation::squareRoot, graph.variable(0));
            const NodeId root = graph.loop(loop, bound, bound, finish(std::move(body), {term}, 1), {});
            const Function function = finish(std::move(graph), {root}, 3);
            const std::array point{-1.0, 0.0, 0.0};
            QCOMPARE(ReferenceEvaluator(function).evaluate(point, {}), empty);
            IntervalEvaluator interval(Tape::compile(function), {});
            QCOMPARE(interval.evaluate(std::array{Interval{-2, -1, false}}), Interval::point(empty));
        }
    }

    void loopsWithOpenBoundsAreUnknown() {
        FunctionGraph body;
        const NodeId term = body.unary(Operation::square, body.variable(0));
        FunctionGraph graph;
        const NodeId root = graph.loop(Operation::sum, graph.constant(1), graph.variable(0),
                                       finish(std::move(body), {term}, 1), {});
        IntervalEvaluator interval(Tape::compile(finish(std::move(graph), {root}, 3)), {});
        QCOMPARE(interval.evaluate(std::array{Interval{3, 4, false}}), Interval::unknown());
        const Interval fixed = interval.evaluate(std::array{Interval::point(3)});
        QVERIFY(fixed.holds(14) && fixed.width() < 1e-13);
    }
};

QTEST_APPLESS_MAIN(IntervalEvaluatorTest)
#include "interval_evaluator_test.moc"
