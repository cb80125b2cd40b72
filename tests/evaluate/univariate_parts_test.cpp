// SPDX-License-Identifier: GPL-3.0-or-later
// What IntervalGradientEvaluator knows more finely of parts that have one operand.
#include <cmath>
#include <QTest>

#include "tests/support/gradient_bounds.h"
#include "tests/support/test_setting.h"

using namespace isoscope;
using namespace isoscope::test;

namespace {

const std::uint64_t seed = seedSetting(31415926);

/// Of one operand, which is a form or a product, and beside it of the coordinates.
Function randomRidge(std::mt19937_64& random) {
    const auto number = [&](double low, double high) {
        return std::uniform_real_distribution<double>(low, high)(random);
    };
    return functionOf([&](auto x, auto y, auto z) {
        const auto u = random() % 3 == 0 ? number(-1, 1) * x * y + z
                                         : number(-2, 2) * x + number(-2, 2) * y + number(-1, 1) * z;
        auto value = u;
        for (int k = 2 + static_cast<int>(random() % 3); k > 0; --k) {
            using enum Operation;
            const Operation some[] = {sine,   exponential, hyperbolicTangent, arcTangent, areaSine,
                                      square, cosine,      absolute};
            value = apply(some[random() % std::size(some)], number(-2, 2) * value + number(-1, 1));
            if (random() % 3 == 0) value = value * u;
            if (random() % 4 == 0) value = 1 / (1.5 + sq(value));
        }
        return random() % 2 == 0 ? value : value + x * sin(y) * number(-1, 1);
    });
}

}  // namespace

class UnivariatePartsTest : public QObject {
    Q_OBJECT

  private slots:
    void initTestCase() { qInfo("seed %llu", static_cast<unsigned long long>(seed)); }

    void functionsOfOneOperandStayWithinFinerBounds() {
        const Checks checks = holdForAll(20000, seed + 12, randomRidge);
        QVERIFY2(checks.slopes > 200000 && checks.bends > 100000 && checks.finer > 20000,
                 qPrintable(QString::number(checks.finer)));
    }

    /// u / (1 + u^2) is no steeper than 1, and bends by 1.4571 at most; by its operations alone it seems far
    /// steeper over this box.
    void aFractionIsKnownFinely() {
        const Function fraction = functionOf([](auto x, auto y, auto z) {
            const auto u = x + y + z;
            return u / (1 + sq(u));
        });
        IntervalGradientEvaluator evaluator(Tape::compile(fraction), {});
        QVERIFY(evaluator.hasFiner());
        const IntervalGradient coarse = evaluator.evaluate(Box{unit, unit, unit});
        const IntervalGradient fine = evaluator.evaluateFinely(Box{unit, unit, unit});
        const double steepest = std::sqrt(3.0), bent = 1.4571;
        QVERIFY(coarse.steepness > 15 * steepest);
        QVERIFY(fine.steepness >= steepest && fine.steepness < 2.5 * steepest);
        const Interval part{-0.25, 0.25, false};
        QVERIFY(evaluator.evaluate(Box{part, part, part}).steepness > 1.5 * steepest);
        const IntervalGradient near = evaluator.evaluateFinely(Box{part, part, part});
        QVERIFY(near.steepness >= steepest && near.steepness < 1.06 * steepest);
        QVERIFY(near.slope[0].low > 0 && near.slope[0].high < 1.06);
        QVERIFY(near.bend[0].size() < 3 * bent);
        // Nothing is kept of the box.
        QCOMPARE(evaluator.evaluate(Box{unit, unit, unit}).steepness, coarse.steepness);
    }

    /// A sigmoid is no steeper than a quarter, and bends by 1/(6 sqrt 3) at most.
    void aSigmoidIsKnownFinely() {
        const Function sigmoid =
            functionOf([](auto x, auto y, auto z) { return 1 / (1 + exp(-(x + y + z))); });
        IntervalGradientEvaluator evaluator(Tape::compile(sigmoid), {});
        QVERIFY(evaluator.hasFiner());
        const double steepest = std::sqrt(3.0) / 4, bent = 1 / (6 * std::sqrt(3.0));
        const IntervalGradient fine = evaluator.evaluateFinely(Box{unit, unit, unit});
        QVERIFY(fine.steepness >= steepest && fine.steepness < 2.5 * steepest);
        const Interval part{-0.25, 0.25, false};
        const IntervalGradient near = evaluator.evaluateFinely(Box{part, part, part});
        QVERIFY(near.steepness >= steepest && near.steepness < 1.06 * steepest);
        QVERIFY(near.slope[0].low > 0 && near.slope[0].high < 1.06 * 0.25);
        QVERIFY(near.bend[0].size() < 3 * bent);
    }

    /// A constant without a value was infinity to the parts, and the greater one was that.
    void aConstantWithoutAValueStaysOne() {
        const Function function =
            functionOf([](auto, auto, auto z) { return max(sq(z), z.number(std::nan(""))); });
        IntervalGradientEvaluator evaluator(Tape::compile(function), {});
        const IntervalGradient fine = evaluator.evaluateFinely(Box{unit, unit, Interval{2, 2.1, false}});
        QVERIFY(fine.steepness >= 4.2 && fine.slope[2].high >= 4.2);
    }

    void whatHasNoPartsHasNothingFiner() {
        const auto hasFiner = [](auto make) {
            return IntervalGradientEvaluator(Tape::compile(functionOf(make)), {}).hasFiner();
        };
        QVERIFY(!hasFiner([](auto x, auto y, auto z) { return x * y + z; }));
        QVERIFY(!hasFiner([](auto x, auto y, auto z) { return sin(x + y) + z; }));
        // A length has its slope of its own, and one operation beside it is known exactly.
        QVERIFY(!hasFiner([](auto x, auto y, auto z) { return sin(sqrt(sq(x) + sq(y) + sq(z))); }));
        QVERIFY(hasFiner([](auto x, auto y, auto z) { return sq(sin(x * y)) + z; }));
        QVERIFY(hasFiner([](auto x, auto y, auto z) { return sq(sin(x)) * y + z; }));
    }
};

QTEST_APPLESS_MAIN(UnivariatePartsTest)
#include "univariate_parts_test.moc"
