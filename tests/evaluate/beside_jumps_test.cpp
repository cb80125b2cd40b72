// SPDX-License-Identifier: GPL-3.0-or-later
// Slopes over boxes with jumps, side by side of these, and of pieces that are undefined outside their places.
#include <algorithm>
#include <QTest>

#include "tests/support/gradient_bounds.h"
#include "tests/support/tape_of.h"
#include "tests/support/test_setting.h"

using namespace isoscope;
using namespace isoscope::test;

namespace {

const std::uint64_t seed = seedSetting(161803);

RandomFunctionSettings jumpingOperations() {
    RandomFunctionSettings settings;
    settings.loops = false;
    settings.operations = {Operation::floor,        Operation::ceiling,   Operation::fraction,
                           Operation::arcTangent2,  Operation::remainder, Operation::less,
                           Operation::greaterEqual, Operation::select3,   Operation::select4};
    for (const Operation smooth : {Operation::add, Operation::subtract, Operation::multiply, Operation::sine,
                                   Operation::square, Operation::minimum, Operation::absolute})
        for (int k = 0; k < 2; ++k) settings.operations.push_back(smooth);
    return settings;
}

Expression binary(Operation operation, Expression a, Expression b) {
    return Expression(a.graph(), a.graph().binary(operation, a.node(), b.node()));
}
Expression powerOf(Expression a, double exponent) { return binary(Operation::power, a, a.number(exponent)); }

/// What the function is in a box for each combination of the sides of its jumps; none where there are more
/// than five.
std::vector<IntervalGradient> sidesOf(IntervalGradientEvaluator& evaluator, const Box& box) {
    constexpr std::size_t most = 5;
    std::vector<IntervalGradient> all;
    std::vector<unsigned> waiting{0};
    std::vector<std::size_t> decided{0};
    while (!waiting.empty()) {
        const unsigned sides = waiting.back();
        const std::size_t known = decided.back();
        waiting.pop_back();
        decided.pop_back();
        all.push_back(evaluator.evaluateBesideJumps(box, sides));
        if (evaluator.jumpsMet() > most) return {};
        for (std::size_t k = known; k < evaluator.jumpsMet(); ++k) {
            waiting.push_back(sides | 1U << k);
            decided.push_back(k + 1);
        }
    }
    return all;
}

bool holds(const IntervalGradient& side, const ValueAndGradient& at) {
    const double slack = 1e-9 * (1 + std::abs(at.value));
    if (side.hazard > GradientHazard::jump) return true;
    if (!(at.value >= side.value.low - slack && at.value <= side.value.high + slack)) return false;
    double squares = 0;
    for (std::size_t i = 0; i < 3; ++i) {
        const double slope = at.gradient[i], room = 1e-9 * (1 + side.steepness);
        if (!(slope >= side.slope[i].low - room && slope <= side.slope[i].high + room)) return false;
        squares += slope * slope;
    }
    return std::sqrt(squares) <= side.steepness * (1 + 1e-9) + 1e-9;
}

}  // namespace

class BesideJumpsTest : public QObject {
    Q_OBJECT

  private slots:
    void initTestCase() { qInfo("seed %llu", static_cast<unsigned long long>(seed)); }

    void functionsAreOneOfTheirSides_data() {
        QTest::addColumn<quint64>("start");
        QTest::newRow("random") << quint64(seed);
        // The values of a pending wrap were cut off as if they were those of one side of it.
        QTest::newRow("a choice of an angle across its cut") << quint64(5);
    }
    void functionsAreOneOfTheirSides() {
        QFETCH(quint64, start);
        std::mt19937_64 random(start);
        RandomFunctionSettings settings = jumpingOperations();
        int besideJumps = 0, pieces = 0;
        for (int round = 0; round < 2000; ++round) {
            settings.nodes = 2 + static_cast<int>(random() % 12);
            const Function function = randomFunction(random, settings);
            const auto tape = Tape::compile(function);
            IntervalGradientEvaluator evaluator(tape, parameters);
            ReferenceEvaluator reference(function);
            GradientEvaluator gradient(tape, parameters);
            for (int tries = 0; tries < 4; ++tries) {
                const Box box = boxAround(random, 3, -1.5, 0.3);
                const std::vector<IntervalGradient> sides = sidesOf(evaluator, box);
                evaluator.evaluate(box);
                const std::size_t choices = evaluator.openChoices();
                for (int k = 0; k < 6; ++k) {
                    const Point p = inside(random, box);
                    const ValueAndGradient at = gradient.evaluate(p[0], p[1], p[2]);
                    const double length = std::hypot(at.gradient[0], at.gradient[1], at.gradient[2]);
                    // What the evaluator at points cuts off or does not follow.
                    const double value = reference.evaluate(p, parameters);
                    if (!std::isfinite(value) || !(length < 1e6) ||
                        !(std::abs(at.value - value) <= 1e-9 * (1 + std::abs(value))))
                        continue;
                    const auto isHere = [&](const IntervalGradient& side) { return holds(side, at); };
                    if (!sides.empty())
                        QVERIFY2(std::ranges::any_of(sides, isHere), describe(function).c_str());
                    besideJumps += sides.size() > 1 ? 1 : 0;
                    if (choices == 0 || choices > 3) continue;
                    bool found = false;
                    for (unsigned piece = 0; piece < 1U << choices && !found; ++piece)
                        found = isHere(evaluator.evaluatePossiblePiece(box, piece));
                    QVERIFY2(found, describe(function).c_str());
                    ++pieces;
                }
            }
        }
        QVERIFY2(besideJumps > 1000 && pieces > 300,
                 qPrintable(QString("%1 %2").arg(besideJumps).arg(pieces)));
    }

    /// Where two jumps cross, however small the box: each of four sides has a slope of its own, and none is
    /// as long as what holds all of them.
    void crossingJumpsAreToldApart() {
        const auto tape = tapeOf([](auto x, auto y, auto z) {
            return (x + 2) * (floor(x) + 0.5) + (y + 2) * (floor(y) + 0.5) + 0 * z;
        });
        IntervalGradientEvaluator evaluator(tape, {});
        const Interval small{-1e-3, 1e-3, false};
        const Box box{small, small, small};
        QVERIFY(evaluator.evaluate(box).hazard == GradientHazard::jump);
        const std::vector<IntervalGradient> sides = sidesOf(evaluator, box);
        QCOMPARE(sides.size(), std::size_t(4));
        for (const IntervalGradient& side : sides) {
            QVERIFY(side.bounded() && side.smooth);
            QVERIFY(std::abs(side.steepness - std::sqrt(0.5)) < 1e-9);
        }
        // A select jumps where its condition does not make its sides meet, and a comparison.
        const auto others = tapeOf([](auto x, auto y, auto z) {
            return select(x, 3 * y, z) + y * binary(Operation::less, z, x.number(0));
        });
        IntervalGradientEvaluator selects(others, {});
        QCOMPARE(sidesOf(selects, box).size(), std::size_t(4));
        // One of three values at 0, which may be more than a surface.
        const auto three = tapeOf([](auto x, auto y, auto z) { return select(max(x, 0.0), y, 2 * y, z); });
        IntervalGradientEvaluator cases(three, {});
        QCOMPARE(sidesOf(cases, box).size(), std::size_t(1));
    }

    /// |u|^2.5 is u^2.5 or (-u)^2.5, which have no value at the places of the other one.
    void piecesAreKnownWhereTheyMayBe() {
        const auto tape = tapeOf([](auto x, auto y, auto z) { return powerOf(abs(x - y), 2.5) + 0 * z; });
        IntervalGradientEvaluator evaluator(tape, {});
        const Interval small{-0.1, 0.1, false};
        const Box box{small, small, small};
        evaluator.evaluate(box);
        QCOMPARE(evaluator.openChoices(), std::size_t(1));
        for (const unsigned sides : {0U, 1U}) {
            QVERIFY(evaluator.evaluatePiece(box, sides).value.maybeUndefined);
            const IntervalGradient& piece = evaluator.evaluatePossiblePiece(box, sides);
            QVERIFY(piece.bounded() && !piece.value.maybeUndefined && !piece.smooth);
            QVERIFY(piece.value.low >= 0 && piece.value.high < 1.0001 * std::pow(0.2, 2.5));
            QVERIFY(piece.steepness < 1.0001 * std::sqrt(2) * 2.5 * std::pow(0.2, 1.5));
        }
        // The smaller one of two is nowhere above the other.
        const auto least = tapeOf([](auto x, auto y, auto z) { return min(x, y) + 0 * z; });
        IntervalGradientEvaluator smaller(least, {});
        const Box wide{Interval{0, 5, false}, Interval{-1, 1, false}, small};
        smaller.evaluate(wide);
        QCOMPARE(smaller.evaluatePiece(wide, 0).value.high, 5.0);
        QCOMPARE(smaller.evaluatePossiblePiece(wide, 0).value.high, 1.0);
    }

    /// Of |a|^6 + |b|^6 where a is far larger than b: the root is as steep as a, though in which direction it
    /// climbs is not known well.
    void theDirectionOfWhatIsSmallDoesNotMatter() {
        const Box box{Interval{0.203, 0.22, false}, Interval{-0.01, 0.01, false},
                      Interval{0.06, 0.095, false}};
        const IntervalGradient root = over(
            [](auto x, auto y, auto z) {
                const auto a = abs(sqrt(sq(x) + sq(z)) - 0.8), b = abs(3 * y);
                return powerOf(powerOf(a, 6) + powerOf(b, 6), 1.0 / 6);
            },
            box);
        QVERIFY(root.bounded() && root.steepness < 1.001);
        QVERIFY(gradient_rules::lengthAbove(root.slope) > 1.035);
    }
};

QTEST_APPLESS_MAIN(BesideJumpsTest)
#include "beside_jumps_test.moc"
