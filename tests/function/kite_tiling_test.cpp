// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/function/patterns/kite_tiling.h"

#include <cmath>
#include <numbers>
#include <QTest>
#include <random>

#include "tests/support/test_setting.h"

using namespace isoscope;

namespace {

const std::uint64_t seed = test::seedSetting(20261130);

/// The values at places are those of POV-Ray: tests/data/texture/lookups.csv.
double valueAt(const KiteTiling& tiling, PlanePoint point) { return tiling.value({point[0], 0, point[1]}); }

PlanePoint turned(PlanePoint p, double degrees) {
    const double angle = degrees * (std::numbers::pi / 180), c = std::cos(angle), s = std::sin(angle);
    return {c * p[0] - s * p[1], s * p[0] + c * p[1]};
}

}  // namespace

class KiteTilingTest : public QObject {
    Q_OBJECT

  private slots:
    void initTestCase() { qInfo("seed %llu", static_cast<unsigned long long>(seed)); }

    void everythingIsFivefoldAroundTheOrigin_data() {
        QTest::addColumn<bool>("pentagons");
        QTest::newRow("pentagons") << true;
        QTest::newRow("kites and darts") << false;
    }
    void everythingIsFivefoldAroundTheOrigin() {
        QFETCH(bool, pentagons);
        const KiteTiling tiling(pentagons ? KiteTiling::Tiles::pentagons : KiteTiling::Tiles::kites);
        std::mt19937_64 engine(seed);
        int differing = 0;
        constexpr int rounds = 20000;
        for (int round = 0; round < rounds; ++round) {
            const double size = std::pow(10, std::uniform_real_distribution<double>(-2, 5)(engine));
            std::uniform_real_distribution<double> within(-size, size);
            const PlanePoint p{within(engine), within(engine)};
            const double value = valueAt(tiling, p);
            QVERIFY(value >= 0 && value <= 1);
            const bool same = std::abs(valueAt(tiling, {p[0], -p[1]}) - value) < 1e-6 &&
                              std::abs(valueAt(tiling, turned(p, 72)) - value) < 1e-6 &&
                              std::abs(valueAt(tiling, turned(p, 216)) - value) < 1e-6;
            differing += !same;
        }
        // Values jump at sides, near which rounding decides.
        QVERIFY2(differing < rounds / 1000, qPrintable(QString::number(differing)));
    }

    /// There are as many more kites than darts as kites are larger: by the golden ratio.
    void kitesTakeTheirShareOfThePlane() {
        const KiteTiling tiling(KiteTiling::Tiles::kites);
        std::mt19937_64 engine(seed);
        std::uniform_real_distribution<double> within(-2000, 2000);
        constexpr int rounds = 100000;
        int kites = 0;
        for (int round = 0; round < rounds; ++round)
            kites += valueAt(tiling, {within(engine), within(engine)}) < 0.5;
        const double golden = std::numbers::phi, share = golden * golden / (golden * golden + 1);
        QVERIFY2(std::abs(kites / double(rounds) - share) < 0.008, qPrintable(QString::number(kites)));
    }

    void cornersThatPointInwardsTakeTheGreaterDistance() {
        const PenroseShape arrow{0, {{2, 0}, {0, 2}, {0.5, 0}, {0, -2}}};
        QVERIFY(std::abs(arrow.depth({0.6, 0}) - 0.1 * 2 / std::hypot(2, 0.5)) < 1e-12);
        QVERIFY(arrow.depth({0.4, 0}) < 0);
        QVERIFY(arrow.depth({0.2, 1.5}) > 0);
        QVERIFY(arrow.depth({0.2, -1.5}) > 0);
    }

    void placesWithoutATileAreZero() {
        for (const KiteTiling::Tiles tiles : {KiteTiling::Tiles::pentagons, KiteTiling::Tiles::kites}) {
            const KiteTiling tiling(tiles);
            QCOMPARE(valueAt(tiling, {2e9, 0}), 0.0);
            QCOMPARE(valueAt(tiling, {0, std::nan("")}), 0.0);
            QCOMPARE(valueAt(tiling, {-HUGE_VAL, 0}), 0.0);
            QVERIFY(valueAt(tiling, {-1e9, 1e9}) >= 0);
        }
    }
};

QTEST_APPLESS_MAIN(KiteTilingTest)
#include "kite_tiling_test.moc"
