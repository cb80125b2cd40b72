// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/evaluate/box_evaluator.h"

#include <cfenv>
#include <cmath>
#include <QTest>

#include "core/evaluate/interval_evaluator.h"
#include "core/evaluate/reference_evaluator.h"
#include "core/function/graph_builder.h"
#include "tests/support/exact_pieces.h"
#include "tests/support/instruction_sets.h"
#include "tests/support/random_function.h"
#include "tests/support/tape_of.h"
#include "tests/support/test_setting.h"

using namespace isoscope;
using namespace isoscope::test;

namespace {

const std::uint64_t seed = seedSetting(693147);

BoxLanes randomBoxes(std::mt19937_64& random, double widest) {
    BoxLanes boxes;
    for (int k = 0; k < 3; ++k)
        for (std::size_t i = 0; i < batchLanes; ++i) {
            const double center = uniform(random, -4, 4);
            const double reach = random() % 8 ? widest * std::pow(10.0, uniform(random, -6, 0)) : 0;
            boxes.low[k][i] = center - reach;
            boxes.high[k][i] = center + reach;
        }
    return boxes;
}

std::array<Interval, 3> boxOf(const BoxLanes& boxes, std::size_t lane) {
    std::array<Interval, 3> box;
    for (int k = 0; k < 3; ++k) box[k] = {boxes.low[k][lane], boxes.high[k][lane], false};
    return box;
}

/// A point of the box, corners more often than not.
std::array<ExactNumber, 3> pointIn(std::mt19937_64& random, const BoxLanes& boxes, std::size_t lane) {
    std::array<ExactNumber, 3> point;
    for (int k = 0; k < 3; ++k) {
        const double low = boxes.low[k][lane], high = boxes.high[k][lane];
        const double inside = std::clamp(uniform(random, low, std::nextafter(high, 10)), low, high);
        point[k] = ExactNumber(random() % 3 == 0 ? low : random() % 2 ? high : inside);
    }
    return point;
}

bool holds(const Interval& range, const ExactNumber& value) {
    if (value.isNan()) return range.maybeUndefined;
    return mpfr_cmp_d(value.get(), range.low) >= 0 && mpfr_cmp_d(value.get(), range.high) <= 0;
}

QByteArray text(const Interval& range) {
    return QString::asprintf("[%.17g, %.17g]%s", range.low, range.high, range.maybeUndefined ? "?" : "")
        .toLatin1();
}

Function operationFunction(Operation operation, bool uniformFirst, std::mt19937_64& random) {
    FunctionGraph graph;
    std::vector<NodeId> operands;
    for (int k = 0; k < 4; ++k)
        operands.push_back(k == 0 && uniformFirst ? graph.parameter(0) : graph.variable(k % 3));
    const NodeId root = addOperation(graph, operation, operands, random);
    return finish(std::move(graph), {root}, 3);
}

/// Whether `a` is hardly wider than `b`.
bool hardlyWider(const Interval& a, const Interval& b) {
    if (a.empty() || b.empty()) return a.empty() == b.empty();
    const double slack = 1e-8 * std::max({1.0, std::abs(b.low), std::abs(b.high)});
    return a.low >= b.low - slack && a.high <= b.high + slack && (b.maybeUndefined || !a.maybeUndefined);
}

std::vector<Operation> boundedOperations() {
    std::vector<Operation> operations;
    for (int k = 0; k < operationCount; ++k)
        if (arity(static_cast<Operation>(k)) > 0 && static_cast<Operation>(k) != Operation::crackle)
            operations.push_back(static_cast<Operation>(k));
    return operations;
}

}  // namespace

class BoxEvaluatorTest : public QObject {
    Q_OBJECT

  private slots:
    void initTestCase() { qInfo("seed %llu", static_cast<unsigned long long>(seed)); }

    void everyOperationHoldsItsValuesAndIsAsTightAsTheScalarOne() {
        std::mt19937_64 random(seed);
        for (const auto& [target, set] : instructionSets()) {
            const ForcedInstructionSet forced(target);
            for (const Operation operation : boundedOperations())
                for (int round = 0; round < 12; ++round) {
                    const Function function =
                        operationFunction(operation, arity(operation) > 1 && round % 3 == 2, random);
                    const std::array parameters{round % 2 ? std::round(uniform(random, -4, 4))
                                                          : uniform(random, -3, 3)};
                    const auto tape = Tape::compile(function);
                    BoxEvaluator evaluator(tape, parameters);
                    IntervalEvaluator scalar(tape, parameters);
                    const BoxLanes boxes = randomBoxes(random, round < 6 ? 5 : 0.1);
                    std::array<Interval, batchLanes> ranges;
                    evaluator.evaluate(boxes, ranges);
                    for (std::size_t lane = 0; lane < batchLanes; ++lane) {
                        bool regular = true;
                        const ExactNumber value =
                            evaluateExactly(function, pointIn(random, boxes, lane), parameters, regular);
                        const QByteArray place = QByteArray(set) + ", " +
                                                 std::string(name(operation)).c_str() + ": " +
                                                 text(ranges[lane]);
                        QVERIFY2(!regular || holds(ranges[lane], value),
                                 place + " does not hold " + QByteArray::number(value.rounded(), 'g', 17));
                        const Interval wanted = scalar.evaluate(boxOf(boxes, lane));
                        QVERIFY2(hardlyWider(ranges[lane], wanted), place + " is wider than " + text(wanted));
                    }
                }
        }
    }

    /// Rounding leads to no values that the operation cannot have, so that roots, logarithms and arc
    /// functions behind it are defined.
    void rangesEndWhereTheirOperationDoes() {
        using enum Operation;
        struct Case {
            Operation operation;
            double low, high, least, most;
        };
        constexpr double any = std::numeric_limits<double>::quiet_NaN();
        const Case cases[] = {{exponential, -2000, -1000, 0, any},
                              {exponential, -1000, 1, 0, any},
                              {square, -1e-200, 1e-200, 0, any},
                              {square, 1e-200, 2e-200, 0, any},
                              {absolute, -1, 2, 0, 2},
                              {squareRoot, 0, 4, 0, 2},
                              {sine, 1, 2, any, 1},
                              {sine, -2, 5, -1, 1},
                              {cosine, -1, 1, any, 1},
                              {cosine, 0, 100, -1, 1},
                              {hyperbolicTangent, 30, 40, any, 1},
                              {hyperbolicCosine, -1, 2, 1, any},
                              {hyperbolicTangent, -40, 40, -1, 1},
                              {floor, -0.5, 0.5, -1, 0},
                              {ceiling, -0.5, 0.5, 0, 1},
                              {triangleWave, -3, 3, 0, 1}};
        for (const auto& [target, set] : instructionSets()) {
            const ForcedInstructionSet forced(target);
            for (const Case& each : cases) {
                FunctionGraph graph;
                const NodeId root = graph.unary(each.operation, graph.variable(0));
                BoxEvaluator evaluator(Tape::compile(finish(std::move(graph), {root}, 3)), {});
                BoxLanes boxes;
                boxes.low[0].fill(each.low);
                boxes.high[0].fill(each.high);
                std::array<Interval, batchLanes> ranges;
                evaluator.evaluate(boxes, ranges);
                for (const Interval& range : ranges)
                    QVERIFY2((std::isnan(each.least) || range.low == each.least) &&
                                 (std::isnan(each.most) || range.high == each.most),
                             QByteArray(set) + ", " + std::string(name(each.operation)).c_str() + ": " +
                                 text(range));
            }
        }
    }

    void randomFunctionsHoldTheirExactValues() {
        for (const auto& [target, set] : instructionSets()) {
            const ForcedInstructionSet forced(target);
            std::mt19937_64 random(seed + 1);
            RandomFunctionSettings settings;
            settings.loops = false;
            settings.parameters = 0;
            settings.operations = boundedOperations();
            int bounded = 0;
            for (int round = 0; round < 300; ++round) {
                settings.nodes = 1 + static_cast<int>(random() % 14);
                Function function = randomFunction(random, settings);
                function.results.resize(1);
                BoxEvaluator evaluator(Tape::compile(function), {});
                const BoxLanes boxes = randomBoxes(random, 1);
                std::array<Interval, batchLanes> ranges;
                evaluator.evaluate(boxes, ranges);
                for (std::size_t lane = 0; lane < batchLanes; ++lane) {
                    bounded += ranges[lane].width() < INFINITY;
                    bool regular = true;
                    const ExactNumber value =
                        evaluateExactly(function, pointIn(random, boxes, lane), {}, regular);
                    QVERIFY2(!regular || holds(ranges[lane], value),
                             QByteArray(set) + ", round " + QByteArray::number(round) + ": " +
                                 text(ranges[lane]) + " does not hold " +
                                 QByteArray::number(value.rounded(), 'g', 17) + "\n" +
                                 describe(function).c_str());
                }
            }
            QVERIFY2(bounded > 300 * int(batchLanes) / 2, set);
        }
    }

    /// A tape that is shortened by the choices gives the same ranges in the same boxes.
    void choicesShortenTheTapeWithoutChangingIt() {
        std::mt19937_64 random(seed + 2);
        RandomFunctionSettings settings;
        settings.loops = false;
        settings.parameters = 2;
        settings.operations = {Operation::add,       Operation::subtract, Operation::multiply,
                               Operation::minimum,   Operation::maximum,  Operation::absolute,
                               Operation::select3,   Operation::select4,  Operation::square,
                               Operation::squareRoot};
        const std::array parameters{0.7, -1.2};
        std::size_t whole = 0, left = 0;
        for (int round = 0; round < 300; ++round) {
            settings.nodes = 10 + static_cast<int>(random() % 30);
            const Function function = randomFunction(random, settings);
            const auto tape = Tape::compile(function);
            BoxEvaluator evaluator(tape, parameters);
            BoxLanes boxes = randomBoxes(random, 0.2);
            // Boxes next to each other, so that something is decided in all of them.
            for (int k = 0; k < 3; ++k)
                for (std::size_t i = 1; i < batchLanes; ++i) {
                    boxes.low[k][i] = boxes.low[k][0] + 0.001 * double(i);
                    boxes.high[k][i] = boxes.high[k][0] + 0.001 * double(i);
                }
            std::array<Interval, 20> ranges, shortened;
            evaluator.evaluate(boxes, ranges);
            const TapeLinks links(*tape);
            TapeSimplifier simplifier(links);
            QCOMPARE(evaluator.choices().size(), simplifier.choiceCount());
            SimplifiedTape simplifiedTape;
            simplifier.simplify(evaluator.choices(), 0, simplifiedTape);
            evaluator.evaluate(boxes, simplifiedTape, shortened);
            whole += tape->instructions().size();
            left += simplifiedTape.instructions.size();
            for (std::size_t i = 0; i < ranges.size(); ++i)
                QVERIFY2(shortened[i] == ranges[i] || (shortened[i].empty() && ranges[i].empty()),
                         text(shortened[i]) + " instead of " + text(ranges[i]) + "\n" +
                             describe(function).c_str());
        }
        QVERIFY2(left < whole / 2, qPrintable(QString::asprintf("%zu of %zu", left, whole)));
    }

    /// Of equal numbers min and max are the first one, whose 0 may have another sign.
    void rangesThatMeetLeaveTheSecondOperandOpen() {
        const auto choiceOf = [](auto make, double x, double y) {
            BoxEvaluator evaluator(tapeOf(make), {});
            BoxLanes boxes;
            boxes.low[0][0] = x, boxes.high[0][0] = x + 1;
            boxes.low[1][0] = y, boxes.high[1][0] = y + 1;
            Interval range;
            evaluator.evaluate(boxes, {&range, 1});
            return evaluator.choices()[0];
        };
        const auto least = [](auto x, auto y, auto) { return min(x, y); };
        const auto greatest = [](auto x, auto y, auto) { return max(x, y); };
        QCOMPARE(choiceOf(least, -1, 0), Choice::first);
        QCOMPARE(choiceOf(least, 0, -1), Choice::open);
        QCOMPARE(choiceOf(least, 0, -1.5), Choice::second);
        QCOMPARE(choiceOf(greatest, 0, -1), Choice::first);
        QCOMPARE(choiceOf(greatest, -1, 0), Choice::open);
        QCOMPARE(choiceOf(greatest, -1.5, 0), Choice::second);
    }

    /// Values as doubles may be on the other side of each other than those of real arithmetic.
    void choicesAreDecidedBeyondRoundings() {
        const auto choiceOf = [](auto make, double gap) {
            const auto tape = tapeOf(make);
            BoxEvaluator evaluator(tape, {});
            BoxLanes boxes;
            boxes.high[0][0] = 1;
            boxes.low[1][0] = 1 + gap, boxes.high[1][0] = 2;
            Interval range;
            std::vector<LaneChoices> choices;
            const TapeLinks links(*tape);
            evaluator.evaluateChoices(boxes, links.whole(), SignStakes(), {&range, 1}, choices);
            return choices[0].of(0);
        };
        const auto least = [](auto x, auto y, auto) { return min(x, y); };
        const auto greatest = [](auto x, auto y, auto) { return max(x, y); };
        QCOMPARE(choiceOf(least, 4e-16), Choice::open);
        QCOMPARE(choiceOf(greatest, 4e-16), Choice::open);
        QCOMPARE(choiceOf(least, 4e-15), Choice::first);
        QCOMPARE(choiceOf(greatest, 4e-15), Choice::second);
    }

    void aLanesAnswerDependsOnNothingElse() {
        std::mt19937_64 random(seed + 3);
        RandomFunctionSettings settings;
        settings.parameters = 0;
        settings.nodes = 25;
        for (int round = 0; round < 50; ++round) {
            const auto tape = Tape::compile(randomFunction(random, settings));
            BoxEvaluator evaluator(tape, {});
            const BoxLanes boxes = randomBoxes(random, 1);
            std::array<Interval, batchLanes> all;
            evaluator.evaluate(boxes, all);
            for (std::size_t lane = 0; lane < batchLanes; ++lane) {
                BoxLanes one;
                for (int k = 0; k < 3; ++k) {
                    one.low[k][0] = boxes.low[k][lane];
                    one.high[k][0] = boxes.high[k][lane];
                }
                std::array<Interval, 1> alone;
                evaluator.evaluate(one, alone);
                QVERIFY(alone[0] == all[lane]);
            }
        }
    }

    void loopsHoldTheReference() {
        FunctionGraph body;
        const Expression i(body, body.variable(0)), a(body, body.variable(1));
        const NodeId term = (sin(a * i) / i).node();
        FunctionGraph graph;
        const NodeId captured[] = {graph.variable(1)};
        const NodeId root = graph.loop(Operation::sum, graph.constant(1), graph.parameter(0),
                                       finish(std::move(body), {term}, 2), captured);
        const Function function = finish(std::move(graph), {root}, 3);
        std::mt19937_64 random(seed + 4);
        for (const double steps : {0.0, 1.0, 7.0}) {
            BoxEvaluator evaluator(Tape::compile(function), {{steps}});
            ReferenceEvaluator reference(function);
            const BoxLanes boxes = randomBoxes(random, 0.1);
            std::array<Interval, batchLanes> ranges;
            evaluator.evaluate(boxes, ranges);
            for (std::size_t lane = 0; lane < batchLanes; ++lane) {
                QVERIFY(ranges[lane].width() <= 2 * steps * 0.11 && !ranges[lane].maybeUndefined);
                for (const double y : {boxes.low[1][lane], boxes.high[1][lane]}) {
                    const double value = reference.evaluate({{0, y, 0}}, {{steps}});
                    QVERIFY(ranges[lane].low <= value + 1e-12 && value - 1e-12 <= ranges[lane].high);
                }
            }
        }
        // With bounds that are not one number nothing is known.
        FunctionGraph open, one;
        const NodeId unit = one.variable(0);
        const NodeId openRoot = open.loop(Operation::sum, open.constant(1), open.variable(0),
                                          finish(std::move(one), {unit}, 1), {});
        BoxEvaluator evaluator(Tape::compile(finish(std::move(open), {openRoot}, 3)), {});
        BoxLanes boxes;
        boxes.low[0].fill(3);
        boxes.high[0].fill(3);
        boxes.high[0][1] = 4;
        std::array<Interval, 2> ranges;
        evaluator.evaluate(boxes, ranges);
        QCOMPARE(ranges[0].low, 6.0);
        QCOMPARE(ranges[0].high, 6.0);
        QVERIFY(ranges[1].width() == INFINITY && ranges[1].maybeUndefined);
    }

    void leavesTheRoundingModeAsItWas() {
        FunctionGraph graph;
        const Expression x(graph, graph.variable(0)), y(graph, graph.variable(1));
        const NodeId root = (sin(x) + exp(y) * noise(x.number(2), x, y, x)).node();
        BoxEvaluator evaluator(Tape::compile(finish(std::move(graph), {root}, 3)), {});
        std::array<Interval, 3> ranges;
        evaluator.evaluate(BoxLanes(), ranges);
        QCOMPARE(std::fegetround(), FE_TONEAREST);
        QVERIFY(ranges[0].width() < 1e-13);
        QCOMPARE(evaluator.evaluations(), std::uint64_t{3});
    }

    void endsThatAreNoNumbersAreUnlimited() {
        FunctionGraph graph;
        const NodeId root = (Expression(graph, graph.variable(0)) * 2).node();
        BoxEvaluator evaluator(Tape::compile(finish(std::move(graph), {root}, 3)), {});
        BoxLanes boxes;
        boxes.low[0][0] = 1;
        boxes.high[0][0] = NAN;
        std::array<Interval, 1> range;
        evaluator.evaluate(boxes, range);
        QCOMPARE(range[0].low, 2.0);
        QCOMPARE(range[0].high, Interval::infinite);
    }
};

QTEST_APPLESS_MAIN(BoxEvaluatorTest)
#include "box_evaluator_test.moc"
