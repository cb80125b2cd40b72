// SPDX-License-Identifier: GPL-3.0-or-later
// What is left of a value less a whole number near it, which repeats space: where it steps, and from what
// value.
#include "core/evaluate/tape/rounding_cuts.h"

#include <cmath>
#include <numbers>
#include <QTest>

#include "tests/support/gradient_bounds.h"
#include "tests/support/test_setting.h"

using namespace isoscope;
using namespace isoscope::test;

namespace {

const std::uint64_t seed = seedSetting(16180339);

Expression whole(Operation rounding, Expression u) { return apply(rounding, u); }

/// The cuts that are known of a function.
template <class Make>
std::vector<double> cutsOf(Make make) {
    const auto tape = Tape::compile(functionOf(make));
    std::vector<double> known;
    for (const double cut : roundingCuts(*tape, tape->uniforms({})))
        if (!std::isnan(cut)) known.push_back(cut);
    return known;
}

}  // namespace

class RoundingCutsTest : public QObject {
    Q_OBJECT

  private slots:
    void initTestCase() { qInfo("seed %llu", static_cast<unsigned long long>(seed)); }

    void cutsAreKnown() {
        using Cuts = std::vector<double>;
        QCOMPARE(cutsOf([](auto x, auto, auto) { return x - floor(x + 0.5); }), Cuts{-0.5});
        QCOMPARE(cutsOf([](auto x, auto y, auto) { return sin(x * y) - floor(0.25 + sin(x * y)); }),
                 Cuts{-0.25});
        QCOMPARE(cutsOf([](auto x, auto, auto) { return x - floor(x - 0.5); }), Cuts{0.5});
        QCOMPARE(cutsOf([](auto x, auto, auto) { return x - whole(Operation::ceiling, x - 0.5); }),
                 Cuts{-0.5});
        // Of something else, or a multiple of it.
        QVERIFY(cutsOf([](auto x, auto y, auto) { return x - floor(y + 0.5); }).empty());
        QVERIFY(cutsOf([](auto x, auto, auto) { return x - floor(2 * x); }).empty());
        QVERIFY(cutsOf([](auto x, auto, auto) { return floor(x + 0.5) - x; }).empty());
        QVERIFY(cutsOf([](auto x, auto y, auto) { return x - floor(x + y); }).empty());
    }

    /// Across the step of a rounding in the middle an even function has a kink, others a jump.
    void evenFunctionsOfTheRestDoNotJump() {
        const Box box{Interval{0.3, 0.8, false}, unit, unit};
        const auto hazardOf = [&](auto make) { return over(make, box).hazard; };
        const auto rest = [](Expression u, double shift) { return u - floor(u + shift); };
        QCOMPARE(hazardOf([&](auto x, auto, auto) { return abs(rest(x, 0.5)); }), GradientHazard::none);
        QCOMPARE(hazardOf([&](auto x, auto, auto) { return sq(rest(x, 0.5)); }), GradientHazard::none);
        QCOMPARE(hazardOf([&](auto x, auto, auto) { return abs(rest(x, 0.5) + 0.1); }), GradientHazard::jump);
        QCOMPARE(hazardOf([&](auto x, auto, auto) { return abs(rest(x, 0.4)); }), GradientHazard::jump);
        QCOMPARE(hazardOf([&](auto x, auto, auto) { return rest(x, 0.5); }), GradientHazard::jump);
        QCOMPARE(hazardOf([&](auto x, auto, auto) { return abs(2 * x - floor(2 * x) - 0.5); }),
                 GradientHazard::none);
        QCOMPARE(hazardOf([&](auto x, auto, auto) { return abs(2 * x - floor(2 * x) - 0.4); }),
                 GradientHazard::jump);
        QCOMPARE(hazardOf([&](auto x, auto, auto) { return abs(x - whole(Operation::ceiling, x - 0.5)); }),
                 GradientHazard::none);
        QCOMPARE(hazardOf([&](auto x, auto, auto) { return abs(x - whole(Operation::ceiling, x + 0.5)); }),
                 GradientHazard::jump);
        // int steps where floor does, or ceil.
        const IntervalGradient steps =
            over([](auto x, auto, auto) { return whole(Operation::truncate, 2 * x) + x; }, box);
        QVERIFY(steps.hazard == GradientHazard::jump && steps.slope[0].high < 1 + 1e-12);
        QCOMPARE(over([](auto x, auto,
                         auto) { return cos(2 * std::numbers::pi * whole(Operation::truncate, 2 * x)); },
                      box)
                     .hazard,
                 GradientHazard::none);
    }

    void repeatedSpaceStaysWithinItsBounds() {
        const Checks checks = holdForAll(20000, seed, [](std::mt19937_64& random) {
            return functionOf([&](auto x, auto y, auto z) {
                const double shifts[] = {0, 0.5, -0.5, 1.5, 0.25};
                const auto rest = [&](Expression u) {
                    const double shift = shifts[random() % std::size(shifts)];
                    using enum Operation;
                    const Operation roundings[] = {Operation::floor, ceiling, truncate};
                    const Expression left = u - apply(roundings[random() % 3], u + shift);
                    const double added[] = {0, 0.5, -0.5};
                    return left + added[random() % std::size(added)];
                };
                const auto shaped = [&](Expression u) {
                    switch (random() % 5) {
                        case 0: return abs(u);
                        case 1: return sq(u);
                        case 2: return cos(2 * std::numbers::pi * u);
                        case 3: return max(abs(u), u.number(0.3));
                        default: return apply(Operation::cycle, u);
                    }
                };
                const Expression first = shaped(rest(2 * x + y)), second = shaped(rest(sin(z) + x));
                return random() % 2 == 0 ? first + z : sqrt(sq(first) + sq(second) + sq(y));
            });
        });
        QVERIFY2(checks.slopes > 100000, qPrintable(QString::number(checks.slopes)));
    }
};

QTEST_APPLESS_MAIN(RoundingCutsTest)
#include "rounding_cuts_test.moc"
