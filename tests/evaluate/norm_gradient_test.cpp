// SPDX-License-Identifier: GPL-3.0-or-later
// Gradients over boxes of lengths, sums of powers and their roots.
#include <cmath>
#include <QTest>

#include "tests/support/gradient_bounds.h"
#include "tests/support/test_setting.h"

using namespace isoscope;
using namespace isoscope::test;

namespace {

const std::uint64_t seed = seedSetting(31415926);

/// Roots of sums of powers of random functions of each coordinate, of every kind of exponent.
Function randomNorm(std::mt19937_64& random) {
    const auto number = [&](double low, double high) {
        return std::uniform_real_distribution<double>(low, high)(random);
    };
    return functionOf([&](auto x, auto y, auto z) {
        const double exponents[] = {1, 1.5, 2, 2, 2.6, 3, 4, 5, 6, 2 / 0.3};
        const auto exponent = [&] { return exponents[random() % std::size(exponents)]; };
        const double common = exponent();
        const auto part = [&] {
            const double e = random() % 6 == 0 ? exponent() : common;
            const auto along = number(-2, 2) * x + number(-2, 2) * y + number(-1, 1) * z;
            const auto u = random() % 3 == 0   ? sin(along)
                           : random() % 2 == 0 ? along + number(-1, 1)
                                               : sq(along);
            if (e == 2 && random() % 2 == 0) return sq(u);
            if (e == 4 && random() % 2 == 0) return pow(u, u.number(4));
            // As the language writes whole powers.
            const int whole = static_cast<int>(e);
            if (e > 2 && e == whole && random() % 2 == 0) return powi(whole % 2 == 0 ? u : abs(u), whole);
            return pow(abs(u), u.number(e));
        };
        auto sum = number(0.1, 2) * part() + part();
        if (random() % 3 == 0) sum = sum + part() / 3;
        if (random() % 3 == 0) sum = sum + number(0, 0.5);
        if (random() % 4 == 0) sum = sum / number(0.2, 3);
        if (random() % 8 == 0) sum = select(sum, sum, sum.number(number(-1, 1)), sum);
        const double root = random() % 4 == 0 ? number(1, 3) / common : 1 / common;
        return root == 0.5 ? sqrt(sum) : pow(sum, x.number(root));
    });
}

}  // namespace

class NormGradientTest : public QObject {
    Q_OBJECT

  private slots:
    void initTestCase() { qInfo("seed %llu", static_cast<unsigned long long>(seed)); }

    void rootsOfSumsOfPowersStayWithinTheirBounds() {
        const Checks checks = holdForAll(20000, seed + 4, randomNorm);
        QVERIFY2(checks.slopes > 100000 && checks.bends > 50000, qPrintable(QString::number(checks.bends)));
    }

    /// Not as wide as what the sum and its root say one after the other.
    void normsHaveSharpSlopes() {
        const Box box{Interval{0.3, 0.7, false}, Interval{0.9, 1.1, false}, unit};
        const IntervalGradient circle = over([](auto x, auto y, auto) { return sqrt(sq(x) + sq(y)); }, box);
        const double least = 0.3 / std::hypot(0.3, 1.1), most = 0.7 / std::hypot(0.7, 0.9);
        QVERIFY(std::abs(circle.slope[0].low - least) < 1e-9 && std::abs(circle.slope[0].high - most) < 1e-9);
        // A section with rounded corners, across the middle of a side: straight there, and no kink.
        const Box side{Interval{-0.1, 0.1, false}, Interval{0.9, 1.1, false}, unit};
        const IntervalGradient section = over(
            [](auto x, auto y, auto) {
                return pow(pow(abs(x), x.number(4)) + pow(abs(y), x.number(4)), x.number(0.25));
            },
            side);
        QVERIFY(section.smooth && !section.pieced);
        QVERIFY(section.slope[0].size() < 0.0015 && section.slope[1].low > 0.999);
        QVERIFY(section.bend[bendIndex(0, 0)].size() < 0.05);
    }

    /// pow(x, 4) is read as products; pow(x, 2) beside it has a smaller exponent.
    void productsArePowers() {
        const auto steepness = [](auto make) { return over(make, Box{unit, unit, unit}).steepness; };
        const auto isAbout = [](double found, double exact) {
            return found >= exact * (1 - 1e-12) && found < exact * (1 + 1e-9);
        };
        for (const int n : {3, 4, 5, 6, 7, 8}) {
            const double found = steepness([&](auto x, auto y, auto z) {
                const auto part = [&](auto u) { return powi(n % 2 == 0 ? u : abs(u), n); };
                return pow(part(x) + part(y) + part(z), x.number(1.0 / n));
            });
            QVERIFY2(isAbout(found, 1), qPrintable(QString("%1 for %2").arg(found).arg(n)));
        }
        // The root of x^4 + y^2 climbs as x^2 does at most, or y.
        QVERIFY(isAbout(steepness([](auto x, auto y, auto) { return sqrt(powi(x, 4) + sq(y)); }), 2));
        QVERIFY(isAbout(steepness([](auto x, auto y, auto) { return sqrt(sq(y) + powi(x, 4)); }), 2));
        // Of an odd power of what changes its sign there is no root.
        QVERIFY(
            !over([](auto x, auto y, auto) { return pow(powi(x, 3) + powi(abs(y), 3), x.number(1.0 / 3)); },
                  Box{unit, unit, unit})
                 .bounded());
    }

    /// Also about the centre, where the slopes of the sum and its root tell nothing.
    void normsOfScaledSumsHaveTheirSteepness() {
        const auto steepness = [](double factor, double exponent) {
            return over(
                       [&](auto x, auto y, auto) {
                           return pow(
                               (pow(abs(x), x.number(exponent)) + pow(abs(y), x.number(exponent))) / factor,
                               x.number(1 / exponent));
                       },
                       {unit, unit, unit})
                .steepness;
        };
        for (const double factor : {0.25, 1.0, 9.0})
            for (const double exponent : {2.0, 3.0, 4.0}) {
                const double exact = std::pow(factor, -1 / exponent), found = steepness(factor, exponent);
                QVERIFY2(found >= exact && found < exact * (1 + 1e-9),
                         qPrintable(QString("%1 for %2").arg(found).arg(exact)));
            }
    }

    /// d2/dy2 sqrt(x^2 + y^2) is x^2 / sqrt(x^2 + y^2)^3.
    void normsHaveSharpBends() {
        const Box box{Interval{0.99, 1.01, false}, Interval{-0.01, 0.01, false}, unit};
        const IntervalGradient circle =
            over([](auto x, auto y,
                    auto) { return pow(pow(abs(x), x.number(2)) + pow(abs(y), x.number(2)), x.number(0.5)); },
                 box);
        QVERIFY(circle.smooth && !circle.pieced);
        const SlopeRange across = circle.bend[bendIndex(1, 1)];
        QVERIFY2(across.low > 0.9 && across.high < 1.1,
                 qPrintable(QString("%1 to %2").arg(across.low).arg(across.high)));
        QVERIFY(circle.bend[bendIndex(0, 0)].size() < 0.01);
    }

    /// Beside a constant the sum tells more of bends than its norm, whose parts forget that they are shares.
    void bendsOfARootAreNoWiderThanThoseOfItsSum() {
        const IntervalGradient root =
            over([](auto x, auto y,
                    auto) { return sqrt(pow(abs(x), x.number(6)) + pow(abs(y), x.number(6)) + 4); },
                 {Interval{0.25, 1.25, false}, Interval{-0.0625, 0.0625, false}, unit});
        // d2/dxdy sqrt(s) is -s_x s_y / (4 s^(3/2)), and s is at least 4.
        const double most = 6 * std::pow(1.25, 5) * 6 * std::pow(0.0625, 5) / (4 * 8);
        QVERIFY(root.smooth && !root.pieced);
        QVERIFY(root.bend[bendIndex(0, 1)].size() < most * (1 + 1e-9));
    }

    /// sqrt((1 + sin u) / 3) is sqrt(2/3) |sin(u/2 + pi/4)|: of its root nothing is known but the steepness.
    void rootsOfDividedWavesHaveTheirSteepness() {
        const IntervalGradient wave =
            over([](auto x, auto y, auto) { return sqrt((1 + sin(x + y)) / 3); }, {unit, unit, unit});
        const double exact = std::sqrt(1.0 / 3);
        QVERIFY2(wave.steepness >= exact * (1 - 1e-15) && wave.steepness < exact * (1 + 1e-9),
                 qPrintable(QString::number(wave.steepness)));
    }

    /// Wherever the two parts of a section are perpendicular, its slope is that of the steeper one.
    void sectionsOfPerpendicularPartsAreNoSteeperThanThese() {
        const Box box{Interval{0.45, 0.55, false}, Interval{0.45, 0.55, false}, unit};
        const auto turned = [](auto x, auto y, auto) {
            const auto a = 0.6 * x - 0.8 * y, b = 0.8 * x + 0.6 * y;
            return pow(pow(abs(a), x.number(10)) + pow(abs(b), x.number(10)), x.number(0.1));
        };
        QVERIFY(over(turned, box).bounded() && over(turned, box).steepness < 1 + 1e-9);
        const Box middle{unit, unit, unit};
        QVERIFY(over(turned, middle).bounded() && over(turned, middle).steepness < 1 + 1e-9);
    }

    void distancesKeepTheirSlopeAtTheirCentre() {
        const Box box{unit, unit, unit};
        const IntervalGradient sphere =
            over([](auto x, auto y, auto z) { return sqrt(sq(x) + sq(y) + sq(z)) - 1; }, box);
        QVERIFY(sphere.bounded() && sphere.steepness < 1 + 1e-12);
        const IntervalGradient torus = over(
            [](auto x, auto y, auto z) { return sqrt(sq(sqrt(sq(x) + sq(z)) - 1) + sq(y)) - 0.25; }, box);
        QVERIFY(torus.bounded() && torus.steepness < 1 + 1e-12);
        const IntervalGradient turned = over(
            [](auto x, auto y, auto) { return sqrt(sq(0.6 * x - 0.8 * y) + sq(0.8 * x + 0.6 * y)); }, box);
        QVERIFY(turned.bounded() && turned.steepness < 1 + 1e-12);
        const IntervalGradient cube =
            over([](auto x, auto y, auto z) { return max(abs(x), max(abs(y), abs(z))); }, box);
        QVERIFY(cube.bounded() && cube.steepness < 1 + 1e-12);
        const IntervalGradient octahedron =
            over([](auto x, auto y, auto z) { return abs(x) + abs(y) + abs(z); }, box);
        QVERIFY(octahedron.bounded() && octahedron.steepness < std::sqrt(3.0) + 1e-12);
    }

    /// Of the products of random vectors, with and without roundings around them: the longest sum of the
    /// vectors times numbers whose squares sum up to 1, by many steps of the power iteration, is held and
    /// hardly exceeded.
    void largestEigenvaluesAreBoundedClosely() {
        std::mt19937_64 random(seed);
        std::uniform_real_distribution<double> number(-2, 2);
        for (int round = 0; round < 500; ++round) {
            std::array<double, 6> m{};
            const int vectors = 1 + static_cast<int>(random() % 4);
            for (int k = 0; k < vectors; ++k) {
                const double v[3] = {number(random), number(random), number(random)};
                for (std::size_t i = 0; i < 3; ++i)
                    for (std::size_t j = i; j < 3; ++j) m[bendIndex(i, j)] += v[i] * v[j];
            }
            Point w{1, 0.7, -0.4};
            double largest = 0;
            for (int step = 0; step < 2000; ++step) {
                Point next{};
                for (std::size_t i = 0; i < 3; ++i)
                    for (std::size_t j = 0; j < 3; ++j) next[i] += m[bendIndex(i, j)] * w[j];
                largest = std::hypot(next[0], next[1], next[2]);
                for (std::size_t i = 0; i < 3; ++i) w[i] = next[i] / largest;
            }
            std::array<SlopeRange, 6> exact, wide;
            for (std::size_t k = 0; k < 6; ++k) {
                exact[k] = {m[k], m[k]};
                wide[k] = {m[k] - 1e-3, m[k] + 2e-3};
            }
            const double bound = gradient_rules::eigenvalueAbove(exact);
            QVERIFY(bound >= largest * (1 - 1e-12) && bound < 1.0001 * largest);
            const double wider = gradient_rules::eigenvalueAbove(wide);
            QVERIFY(wider >= bound * (1 - 1e-4) && wider < 1.0001 * (largest + 9e-3));
        }
        // What is not finite has no bound, and no matrix but nothing has none at all.
        QVERIFY(!(gradient_rules::eigenvalueAbove({SlopeRange::within(INFINITY)}) < INFINITY));
        QVERIFY(gradient_rules::eigenvalueAbove({}) < 1e-100);
    }

    /// How far a place is beyond two planes that look away from each other: neither distance is negative, and
    /// where one grows the other falls. Of any signs the norm would climb by 1.34.
    void partsThatAreNotNegativeAddUpWhereTheyClimbAlike() {
        const auto beyond = [](Expression u) { return max(u, 0.0); };
        const Interval near{-0.01, 0.01, false};
        const IntervalGradient corner =
            over([&](auto x, auto y, auto) { return sqrt(sq(beyond(x)) + sq(beyond(0.6 * y - 0.8 * x))); },
                 {near, near, near});
        QVERIFY(corner.bounded() && corner.steepness < 1 + 1e-6);
        const IntervalGradient alike =
            over([&](auto x, auto y, auto) { return sqrt(sq(beyond(x)) + sq(beyond(0.6 * y + 0.8 * x))); },
                 {near, near, near});
        QVERIFY(alike.steepness >= std::sqrt(1.8) && alike.steepness < 1.0001 * std::sqrt(1.8));
        // Of different signs it is the other way round.
        const IntervalGradient opposite =
            over([&](auto x, auto y, auto) { return sqrt(sq(beyond(x)) + sq(-beyond(0.6 * y - 0.8 * x))); },
                 {near, near, near});
        QVERIFY(opposite.steepness < 1 + 1e-6);
    }
};

QTEST_APPLESS_MAIN(NormGradientTest)
#include "norm_gradient_test.moc"
