// SPDX-License-Identifier: GPL-3.0-or-later
// Gradients over boxes that hold the cut of an angle, or the jump of a remainder: none where the function
// does not show it.
#include <array>
#include <numbers>
#include <QTest>

#include "core/evaluate/interval_gradient_evaluator.h"
#include "tests/support/tape_of.h"

using namespace isoscope;
using namespace isoscope::test;

namespace {

using Box = std::array<Interval, 3>;

constexpr Interval unit{-1, 1, false};

template <class Make>
IntervalGradient over(Make make, const Box& box) {
    return IntervalGradientEvaluator(tapeOf(make), {}).evaluate(box);
}

}  // namespace

class AngleCutTest : public QObject {
    Q_OBJECT

  private slots:
    void theCutOfAnAngleIsNoJumpForWholeTurns() {
        const Box behind{Interval{-2, -1, false}, Interval{-0.5, 0.5, false}, unit};
        const auto wave = [](double turns) {
            return [turns](auto x, auto y, auto) { return sin(turns * atan2(y, x) + 0.25); };
        };
        QVERIFY(over(wave(3), behind).bounded());
        QVERIFY(over(wave(3), behind).smooth);
        QVERIFY(over(wave(3), behind).steepness < 3 * 1.01);
        QCOMPARE(over(wave(2.5), behind).hazard, GradientHazard::jump);
        QCOMPARE(over([](auto x, auto y, auto) { return atan2(y, x); }, behind).hazard, GradientHazard::jump);
        const Interval middle{0.8, 1.2, false};
        const auto sawtooth = [](auto x, auto, auto) { return sin(2 * std::numbers::pi * (x - floor(x))); };
        QVERIFY(over(sawtooth, {middle, unit, unit}).bounded());
        const auto remainder = [](auto x, auto, auto) {
            return sin(2 * std::numbers::pi * mod(x, x.number(1)));
        };
        QVERIFY(over(remainder, {middle, unit, unit}).bounded());
        QVERIFY(over(remainder, {Interval{-1.2, -0.8, false}, unit, unit}).bounded());
    }

    /// Only the negative half of the axis is a cut.
    void anAngleAwayFromItsCutIsSmooth() {
        const auto angle = [](auto x, auto y, auto) { return atan2(y, x); };
        for (const Box& box : {Box{Interval{1, 2, false}, Interval{-0.5, 0.5, false}, unit},
                               Box{Interval{-2, -1, false}, Interval{0.25, 0.5, false}, unit}}) {
            const IntervalGradient answer = over(angle, box);
            QVERIFY(answer.bounded() && answer.smooth);
            QVERIFY(answer.steepness < 1 + 1e-9);  // 1 / distance
            QVERIFY(answer.value.high - answer.value.low < 1.1);
        }
    }

    /// A remainder shows nothing of a cut where whole divisors make up the turn and the dividend has one
    /// sign.
    void aRemainderJumpsAtACutThatItDoesNotDivide() {
        const Box behind{Interval{-2, -1, false}, Interval{-0.1, 0.1, false}, unit};
        const auto remainder = [&](double turned, double divisor) {
            return over([=](auto x, auto y, auto) { return mod(atan2(y, x) + turned, x.number(divisor)); },
                        behind);
        };
        constexpr double pi = std::numbers::pi;
        // From 4 pi to 2 pi, in the middle between the divisor's own jumps.
        QVERIFY(remainder(3 * pi + 1, 2 * pi).bounded());
        QVERIFY(remainder(3 * pi + 0.5, pi / 2).bounded());
        QCOMPARE(remainder(3 * pi + 0.5, 2.5).hazard, GradientHazard::jump);
        // From pi to -pi, where remainders have the sign of the dividend.
        QCOMPARE(remainder(0.5, pi / 2).hazard, GradientHazard::jump);
    }

    void aCutThatChangesTheSignIsNoJumpForEvenFunctions() {
        const Box behind{Interval{-2, -1, false}, Interval{-0.5, 0.5, false}, unit};
        const auto half = over([](auto x, auto y, auto) { return cos(atan2(y, x) / 2); }, behind);
        QVERIFY(half.bounded());
        // On both sides of the cut, and not over the whole turn between them.
        QVERIFY(half.value.high < 0.3 && half.steepness < 0.51);
        QVERIFY(over([](auto x, auto y, auto) { return sq(atan2(y, x)); }, behind).bounded());
        const auto moved = [](auto x, auto y, auto) { return sq(atan2(y, x) + 0.25); };
        QCOMPARE(over(moved, behind).hazard, GradientHazard::jump);
        const auto odd = [](auto x, auto y, auto) { return sin(atan2(y, x) / 2); };
        QCOMPARE(over(odd, behind).hazard, GradientHazard::jump);
        const Box step{Interval{0.8, 1.2, false}, unit, unit};
        const auto fromMiddle = [](auto x, auto, auto) { return abs(mod(x, x.number(1)) - 0.5); };
        QVERIFY(over(fromMiddle, step).bounded());
        const auto beside = [](auto x, auto, auto) { return abs(mod(x, x.number(1)) - 0.25); };
        QCOMPARE(over(beside, step).hazard, GradientHazard::jump);
    }

    void aDividedAngleIsNoJumpForWaves() {
        const Box behind{Interval{-2, -1, false}, Interval{-0.5, 0.5, false}, unit};
        const auto wave = [](double turns) {
            return [turns](auto x, auto y, auto) {
                return apply(Operation::triangleWave, turns * atan2(y, x) / (2 * std::numbers::pi));
            };
        };
        QVERIFY(over(wave(3), behind).bounded());
        QVERIFY(over(wave(3), behind).steepness < 1);
        QCOMPARE(over(wave(2.5), behind).hazard, GradientHazard::jump);
        const auto turned = [](auto x, auto y, auto) {
            return mod(atan2(y, x) + 8, x.number(2 * std::numbers::pi));
        };
        QVERIFY(over(turned, behind).bounded());
    }
};

QTEST_APPLESS_MAIN(AngleCutTest)
#include "angle_cut_test.moc"
