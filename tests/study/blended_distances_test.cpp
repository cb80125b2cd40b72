// SPDX-License-Identifier: GPL-3.0-or-later
// Functions of few distances, such as smooth minima: which roots and choices of a tape belong together, and
// what is known of slopes where distances have no direction.
#include <QTest>

#include "core/evaluate/interval_gradient_evaluator.h"
#include "core/evaluate/prepared_function.h"
#include "core/evaluate/tape/linked_choices.h"
#include "core/evaluate/tape/shared_roots.h"
#include "core/study/arguments/root_bound.h"
#include "tests/support/gradient_bounds.h"
#include "tests/support/tape_of.h"
#include "tests/support/test_setting.h"

using namespace isoscope;
using namespace isoscope::test;

namespace {

const std::uint64_t seed = seedSetting(271828);

Expression distance(Expression x, Expression y, Expression z, const Point& from) {
    return sqrt(sq(x - from[0]) + sq(y - from[1]) + sq(z - from[2]));
}

/// Made of the leaves, each of which may come several times.
Expression anyBlend(std::mt19937_64& random, const std::vector<Expression>& leaves, int depth) {
    if (depth == 0) return leaves[random() % leaves.size()];
    const Expression a = anyBlend(random, leaves, depth - 1);
    const unsigned kind = random() % 8;
    if (kind == 0) return abs(a - 0.4);
    if (kind == 1) return sq(a);
    if (kind == 2) return sin(3 * a);
    const Expression b = anyBlend(random, leaves, static_cast<int>(random() % static_cast<unsigned>(depth)));
    switch (kind) {
        case 3: return min(a, b) - 0.3 * sq(max(0.5 - abs(a - b), 0.0));
        case 4: return max(a, b) + abs(b - a);
        case 5: return a * b;
        case 6: return a - 0.5 * b;
        default: return min(a, b);
    }
}

std::vector<Operation> operationsAt(const Tape& tape, std::span<const std::size_t> instructions) {
    std::vector<Operation> result;
    for (const std::size_t i : instructions) result.push_back(tape.instructions()[i].operation);
    return result;
}

/// The choices of a tape that an earlier one decides, and of these the reversed ones.
std::pair<int, int> ledChoices(const Tape& tape) {
    std::pair<int, int> count;
    for (const LinkedChoice& link : linkedChoices(tape)) {
        count.first += link.first != LinkedChoice::none ? 1 : 0;
        count.second += link.reversed ? 1 : 0;
    }
    return count;
}

}  // namespace

class BlendedDistancesTest : public QObject {
    Q_OBJECT

  private slots:
    void initTestCase() { qInfo("seed %llu", static_cast<unsigned long long>(seed)); }

    void rootsThatCountInSeveralWaysAreFound() {
        const Point a{0.1, 0.2, 0.3}, b{-0.4, 0, 0.5};
        const auto one = tapeOf([&](auto x, auto y, auto z) { return distance(x, y, z, a) - 1; });
        QVERIFY(sharedRoots(*one).empty());
        const auto sum =
            tapeOf([&](auto x, auto y, auto z) { return distance(x, y, z, a) + distance(x, y, z, b); });
        QVERIFY(sharedRoots(*sum).empty());
        const auto blend = tapeOf([&](auto x, auto y, auto z) {
            const auto p = distance(x, y, z, a), q = distance(x, y, z, b);
            return min(p, q) + abs(p - q);
        });
        const std::vector<std::size_t> roots = sharedRoots(*blend);
        QCOMPARE(operationsAt(*blend, roots), (std::vector{Operation::squareRoot, Operation::squareRoot}));
        QVERIFY(roots[0] < roots[1]);
        // One in another one counts through that alone; also where both count, both are told.
        const auto torus = tapeOf([&](auto x, auto y, auto z) {
            const auto ring = sqrt(sq(sqrt(x * x + z * z) - 1) + y * y);
            return ring * sin(ring);
        });
        QCOMPARE(sharedRoots(*torus).size(), std::size_t(1));
        const auto both = tapeOf([&](auto x, auto y, auto z) {
            const auto axis = sqrt(x * x + z * z);
            const auto ring = sqrt(sq(axis - 1) + y * y);
            return ring + axis * sin(axis);
        });
        QCOMPARE(sharedRoots(*both).size(), std::size_t(2));
    }

    void choicesOfOneDifferenceAreLinked() {
        const auto led = [](auto make) { return ledChoices(*tapeOf(make)); };
        // The smaller one is the first where the difference is below 0, the magnitude takes its operand
        // above.
        QCOMPARE(led([](auto x, auto y, auto) { return min(x, y) * abs(x - y); }), std::pair(1, 1));
        QCOMPARE(led([](auto x, auto y, auto) { return min(x, y) * abs(y - x); }), std::pair(1, 0));
        QCOMPARE(led([](auto x, auto y, auto) { return max(x, y) * abs(x - y); }), std::pair(1, 0));
        QCOMPARE(led([](auto x, auto y, auto) { return max(x, y) * sin(min(y, x)); }), std::pair(1, 0));
        QCOMPARE(led([](auto x, auto y, auto z) { return abs(z) * select(z, x, y); }), std::pair(1, 1));
        QCOMPARE(led([](auto x, auto y, auto z) { return min(x, y) * abs(x - z); }), std::pair(0, 0));
    }

    /// Where a and b are the same, min(a, b) + |a - b| / 2 is one of two functions, not one of four.
    void linkedChoicesAreTakenTogether() {
        const auto tape = tapeOf([](auto x, auto y, auto z) { return min(x, y) + 0.5 * abs(x - y) + 0 * z; });
        IntervalGradientEvaluator evaluator(tape, {});
        const Box box{unit, unit, unit};
        evaluator.evaluate(box);
        QCOMPARE(evaluator.openChoices(), std::size_t(1));
        for (const unsigned sides : {0U, 1U}) {
            const IntervalGradient piece = evaluator.evaluatePiece(box, sides);
            QCOMPARE(evaluator.margins().size(), std::size_t(1));
            QVERIFY(std::abs(piece.slope[0].low - 0.5) < 1e-12 &&
                    std::abs(piece.slope[1].high - 0.5) < 1e-12);
        }
    }

    /// Around the centre of a ball the distance from it has any direction; of a blend of two distances no
    /// slope is longer than 1 all the same.
    void blendsAreKnownAroundTheirCentres() {
        const auto tape = tapeOf([](auto x, auto y, auto z) {
            const auto a = distance(x, y, z, {0, 0, 0}), b = distance(x, y, z, {0.7, 0, 0});
            return min(a, b) - 0.25 * sq(max(1.0 - abs(a - b), 0.0));
        });
        IntervalGradientEvaluator evaluator(tape, {});
        const Interval small{-0.001, 0.001, false};
        const Box box{small, small, small}, away{Interval{2, 2.1, false}, small, small};
        QVERIFY(evaluator.evaluate(box).steepness > 1.1);
        QVERIFY(evaluator.hasBlurredRoots());
        const double bound = evaluator.steepnessByRoots(box);
        QVERIFY(bound >= 1 && bound < 1.01);
        evaluator.evaluate(away);
        QVERIFY(!evaluator.hasBlurredRoots());
    }

    /// Random functions of two distances and a coordinate.
    void noSlopeIsLongerThanTheBounds() {
        std::mt19937_64 random(seed);
        int inBoxes = 0, inContainers = 0, pieces = 0;
        for (int round = 0; round < 200; ++round) {
            const Function function = functionOf([&](auto x, auto y, auto z) {
                const std::vector<Expression> leaves{distance(x, y, z, {0.3, 0, 0.1}),
                                                     distance(x, y, z, {-0.4, 0.2, 0}), y};
                return anyBlend(random, leaves, 3);
            });
            const auto prepared = PreparedFunction::of(Tape::compile(function), {});
            IntervalGradientEvaluator evaluator(*prepared);
            GradientEvaluator gradients(prepared);
            const Box box = boxAround(random, 0.5, -3, -0.5);
            const double bound = evaluator.steepnessByRoots(box);
            inBoxes += std::isfinite(bound);
            double steepest = 0;
            evaluator.evaluate(box);
            const std::size_t choices = evaluator.openChoices();
            for (int k = 0; k < 20; ++k) {
                const Point p = inside(random, box);
                const ValueAndGradient at = gradients.evaluate(p[0], p[1], p[2]);
                const double slope = std::hypot(at.gradient[0], at.gradient[1], at.gradient[2]);
                QVERIFY2(slope <= bound * (1 + 1e-9) + 1e-9, describe(function).c_str());
                steepest = std::max(steepest, slope);
                if (choices == 0 || choices > 3) continue;
                // One of the pieces is the function there.
                bool found = false;
                for (unsigned sides = 0; sides < 1U << choices && !found; ++sides) {
                    const IntervalGradient& piece = evaluator.evaluatePiece(box, sides);
                    found = at.value >= piece.value.low - 1e-9 && at.value <= piece.value.high + 1e-9;
                    for (std::size_t i = 0; i < 3; ++i)
                        found = found && at.gradient[i] >= piece.slope[i].low - 1e-9 &&
                                at.gradient[i] <= piece.slope[i].high + 1e-9;
                }
                ++pieces;
                QVERIFY2(found, describe(function).c_str());
            }
            const Container around =
                ContainerBox{{box[0].low, box[1].low, box[2].low}, {box[0].high, box[1].high, box[2].high}};
            const RootBound byRoots = boundByRoots(*prepared, GradientDomain(around), 1.3 * steepest);
            QVERIFY(byRoots.boxes < 31'000);
            QVERIFY2(steepest <= byRoots.bound * (1 + 1e-9) + 1e-9, describe(function).c_str());
            inContainers += std::isfinite(byRoots.bound);
        }
        QVERIFY(inBoxes > 150 && inContainers > 20 && pieces > 200);
    }
};

QTEST_GUILESS_MAIN(BlendedDistancesTest)
#include "blended_distances_test.moc"
