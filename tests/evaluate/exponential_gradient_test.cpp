// SPDX-License-Identifier: GPL-3.0-or-later
// Gradients over boxes of sums of exponentials and of their logarithms: smooth minima.
#include <cmath>
#include <QTest>

#include "tests/support/gradient_bounds.h"
#include "tests/support/test_setting.h"

using namespace isoscope;
using namespace isoscope::test;

namespace {

const std::uint64_t seed = seedSetting(27182818);

Expression ln(Expression a) { return apply(Operation::naturalLogarithm, a); }

/// Logarithms, powers and shares of sums of exponentials of random functions.
Function randomSum(std::mt19937_64& random) {
    const auto number = [&](double low, double high) {
        return std::uniform_real_distribution<double>(low, high)(random);
    };
    return functionOf([&](auto x, auto y, auto z) {
        const auto part = [&] {
            const Expression along = number(-2, 2) * x + number(-2, 2) * y + number(-1, 1) * z;
            switch (random() % 4) {
                case 0: return along;
                case 1: return number(-3, 3) * sqrt(sq(x - number(-1, 1)) + sq(y) + sq(z));
                case 2: return sin(along) + y;
                default: return max(along, x);
            }
        };
        const auto sum = [&] {
            Expression all = number(0.1, 3) * exp(part());
            for (auto k = 1 + random() % 3; k > 0; --k) {
                const Expression more = exp(part());
                all = random() % 3 == 0 ? all + more / number(0.5, 4) : all + more;
            }
            return random() % 4 == 0 ? all + number(0.01, 2) : all;
        };
        const Expression all = sum();
        switch (random() % 7) {
            case 0: return ln(all);
            case 1: return apply(Operation::decimalLogarithm, all) * number(-2, 2);
            case 2: return pow(all, all.number(number(-2, 2)));
            case 3: return number(0.2, 2) / all;
            case 4: return ln(1 / all + exp(part()));
            case 5: return ln(pow(all, all.number(0.3)) + 1) + x;
            default: return ln(ln(1 + all)) + 0.1 * sq(all / 20);
        }
    });
}

}  // namespace

class ExponentialGradientTest : public QObject {
    Q_OBJECT

  private slots:
    void initTestCase() { qInfo("seed %llu", static_cast<unsigned long long>(seed)); }

    void sumsOfExponentialsStayWithinTheirBounds() {
        const Checks checks = holdForAll(20000, seed, randomSum);
        QVERIFY2(checks.slopes > 200000 && checks.bends > 100000, qPrintable(QString::number(checks.bends)));
    }

    /// No steeper than what it is the minimum of, in whatever box; by its operations alone it seemed 700
    /// times as steep in this one.
    void aSmoothMinimumIsNoSteeperThanItsParts() {
        const auto minimum = [](auto x, auto y, auto z) {
            const Expression first = sqrt(sq(x) + sq(y) + sq(z)) - 0.6;
            const Expression second = sqrt(sq(x - 0.7) + sq(y) + sq(z)) - 0.5;
            return ln(exp(-8 * first) + exp(-8 * second) + exp(-8 * (y + 0.5))) / -8;
        };
        const IntervalGradient whole = over(minimum, Box{unit, unit, unit});
        QVERIFY(whole.bounded() && whole.steepness >= 1 && whole.steepness < 1 + 1e-12);
        const Interval far{2, 2.1, false};
        const IntervalGradient beside = over(minimum, Box{far, far, far});
        QVERIFY(beside.smooth && beside.slope[1].low > 0.55 && beside.slope[1].high < 1 + 1e-12);
        // A constant among them has no slope.
        const IntervalGradient flat = over([](auto x, auto, auto) { return ln(1 + exp(3 * x)); },
                                           Box{Interval{-9, -8, false}, unit, unit});
        QVERIFY(flat.steepness > 0 && flat.steepness < 3 * std::exp(-24) * (1 + 1e-9));
        QVERIFY(flat.slope[0].low > 3 * std::exp(-27) * (1 - 1e-9) / (1 + std::exp(-27)));
    }

    /// The square of a slope that doubles hold may be beyond them: a product of such slopes had none at all.
    void slopesWhoseSquaresOverflowAreKnown() {
        const IntervalGradient steep = over([](auto x, auto y, auto) { return exp(200 * x) * y; },
                                            Box{Interval{2, 2.001, false}, Interval{1, 1.001, false}, unit});
        QVERIFY(steep.bounded() && steep.steepness >= 200 * std::exp(400.2) * (1 - 1e-12));
        QVERIFY(steep.slope[0].high >= 200 * std::exp(400.2) * (1 - 1e-12));
        QVERIFY(std::isinf(rootAbove(std::nan(""))) && rootAbove(-1) == 0);
    }

    /// A sum with anything else, or less than nothing of one, is no sum of exponentials.
    void othersAreNotTakenForSums() {
        const Box box{Interval{0.5, 1, false}, unit, unit};
        const IntervalGradient moved = over([](auto x, auto, auto) { return ln(exp(x) - 1); }, box);
        QVERIFY(moved.steepness >= std::exp(0.5) / (std::exp(0.5) - 1));
        const IntervalGradient less = over([](auto x, auto, auto) { return ln(exp(2 * x) - exp(x)); }, box);
        QVERIFY(less.steepness >= (2 * std::exp(0.5) - 1) / (std::exp(0.5) - 1));
        const IntervalGradient other = over([](auto x, auto y, auto) { return ln(exp(x) + sq(y)); }, box);
        QVERIFY(other.slope[1].low < 0 && other.slope[1].high > 2 / (std::exp(0.5) + 1));
    }
};

QTEST_APPLESS_MAIN(ExponentialGradientTest)
#include "exponential_gradient_test.moc"
