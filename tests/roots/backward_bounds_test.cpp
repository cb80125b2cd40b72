// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/roots/cells/backward_bounds.h"

#include <QTest>
#include <array>
#include <cmath>
#include <random>
#include <vector>

#include "core/evaluate/point_evaluator.h"
#include "core/evaluate/prepared_function.h"
#include "tests/support/tape_of.h"
#include "tests/support/test_setting.h"

using namespace isoscope;
using test::tapeOf;

namespace {

const std::uint64_t seed = test::seedSetting(141421);

constexpr double infinite = Interval::infinite;
constexpr Interval inside{-infinite, 0};

BackwardBounds::Box where(const std::shared_ptr<const Tape>& tape, const Interval& wanted,
                          double reach = 10) {
    const auto function = PreparedFunction::of(tape, {});
    return BackwardBounds(*tape, function->uniforms())
        .where(function->links().whole(), wanted, {glm::dvec3(-reach), glm::dvec3(reach)});
}

void compare(const LineRegion& found, const glm::dvec3& low, const glm::dvec3& high) {
    for (int axis = 0; axis < 3; ++axis) {
        QVERIFY2(std::abs(found.low[axis] - low[axis]) < 1e-9, qPrintable(QString::number(found.low[axis])));
        QVERIFY2(std::abs(found.high[axis] - high[axis]) < 1e-9,
                 qPrintable(QString::number(found.high[axis])));
    }
}

Expression ln(const Expression& a) { return apply(Operation::naturalLogarithm, a); }

/// A formula of operations that bounds go through, and of one that they do not.
Expression randomFormula(std::mt19937_64& random, const std::array<Expression, 3>& point, int depth) {
    std::uniform_real_distribution<double> number(-2, 2);
    if (depth == 0) {
        const std::uint64_t leaf = random() % 5;
        return leaf < 3 ? point[leaf] : point[0].number(number(random));
    }
    const auto operand = [&] { return randomFormula(random, point, depth - 1); };
    switch (random() % 15) {
        case 0: return -operand();
        case 1: return abs(operand());
        case 2: return sq(operand());
        case 3: return sqrt(abs(operand()));
        case 4: return exp(operand() * 0.1);
        case 5: return ln(abs(operand()) + 0.5);
        case 6: return operand() / (abs(operand()) + 0.1);
        case 7: return operand() / operand();
        case 8: return min(operand(), operand());
        case 9: return max(operand(), operand());
        case 10: return pow(abs(operand()), point[0].number(0.5 + static_cast<double>(random() % 4)));
        case 11: return sin(operand());
        case 12: return operand() * operand();
        case 13: return operand() - operand();
        default: return operand() + operand();
    }
}

}  // namespace

class BackwardBoundsTest : public QObject {
    Q_OBJECT

  private slots:
    void initTestCase() { qInfo("seed %llu", static_cast<unsigned long long>(seed)); }

    /// A ball, an ellipsoid, a superellipsoid and what is behind quotients and logarithms, to the digit.
    void boxesOfPlainShapesAreTight() {
        BackwardBounds::Box box = where(
            tapeOf([](auto x, auto y, auto z) { return sqrt(sq(x - 1) + sq(y + 2) + sq(z)) - 0.5; }), inside);
        QVERIFY(box.isTight);
        compare(box.region, {0.5, -2.5, -0.5}, {1.5, -1.5, 0.5});
        box = where(tapeOf([](auto x, auto y, auto z) { return 4.0 - sq(x) - sq(2.0 * y) - sq(z / 3.0); }),
                    {0, infinite});
        QVERIFY(box.isTight);
        compare(box.region, {-2, -1, -6}, {2, 1, 6});
        box = where(tapeOf([](auto x, auto y, auto z) {
                        return pow(abs(x), x.number(3)) + exp(-y) + ln(z + 5.0) * 2.0 - 4.0;
                    }),
                    inside, 4);
        QVERIFY(box.isTight);
        // exp(-y) is at least exp(-4), and |x|^3 at least 0.
        compare(box.region, {-std::cbrt(4 - std::exp(-4.0)), -std::log(4.0), -4},
                {std::cbrt(4 - std::exp(-4.0)), 4, std::exp(0.5 * (4 - std::exp(-4.0))) - 5});
    }

    /// What is used twice, or chosen, or not gone through, leaves more than there is.
    void whatIsNotTightSaysSo() {
        const auto isTight = [](auto formula) { return where(tapeOf(formula), inside).isTight; };
        QVERIFY(isTight([](auto x, auto y, auto) { return abs(x) + abs(y) - 1.0; }));
        QVERIFY(!isTight([](auto x, auto y, auto) { return abs(x) + abs(x - y) - 1.0; }));
        QVERIFY(!isTight([](auto x, auto y, auto) { return max(abs(x), abs(y)) - 1.0; }));
        QVERIFY(!isTight([](auto x, auto y, auto) { return sin(x) + abs(y) - 1.0; }));
        const BackwardBounds::Box box =
            where(tapeOf([](auto x, auto y, auto) { return sin(x) + abs(y) - 1.0; }), inside);
        compare(box.region, {-10, -10, -10}, {10, 10, 10});
    }

    void nowhereIsEmpty() {
        const LineRegion region =
            where(tapeOf([](auto x, auto y, auto z) { return sq(x) + sq(y) + sq(z) + 1.0; }), inside).region;
        QVERIFY(!(region.low.x <= region.high.x));
    }

    /// No point of random formulas has a value that is wanted outside of the box.
    void boxesLeaveNothingOut() {
        std::mt19937_64 random(seed);
        std::uniform_real_distribution<double> anywhere(-4, 4), level(-2, 2);
        std::size_t smaller = 0, wantedPoints = 0;
        for (int round = 0; round < 2000; ++round) {
            const auto tape = tapeOf([&](auto x, auto y, auto z) {
                return randomFormula(random, {x, y, z}, 1 + static_cast<int>(random() % 4)) + 1e-3 * x;
            });
            const double low = level(random);
            const Interval wanted = random() % 2 == 0 ? Interval{low, infinite} : Interval{-infinite, low};
            const auto function = PreparedFunction::of(tape, {});
            const LineRegion box = where(tape, wanted, 4).region;
            PointEvaluator points(function);
            for (int axis = 0; axis < 3; ++axis)
                smaller += !(box.low[axis] <= -4 && box.high[axis] >= 4) && box.low[axis] < box.high[axis];
            for (int k = 0; k < 200; ++k) {
                const glm::dvec3 p{anywhere(random), anywhere(random), anywhere(random)};
                if (!wanted.holds(points.evaluate(p.x, p.y, p.z))) continue;
                ++wantedPoints;
                for (int axis = 0; axis < 3; ++axis)
                    QVERIFY2(box.low[axis] <= p[axis] + 1e-9 && p[axis] - 1e-9 <= box.high[axis],
                             qPrintable(QString("round %1, axis %2: %3 in %4 %5")
                                            .arg(round)
                                            .arg(axis)
                                            .arg(p[axis])
                                            .arg(box.low[axis])
                                            .arg(box.high[axis])));
            }
        }
        qInfo("%zu sides of boxes narrower, %zu points inside", smaller, wantedPoints);
        QVERIFY(smaller > 200 && wantedPoints > 100000);
    }
};

QTEST_APPLESS_MAIN(BackwardBoundsTest)
#include "backward_bounds_test.moc"
