// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/numeric/noise_range.h"

#include <QTest>
#include <random>

#include "core/numeric/noise_bounds.h"
#include "core/numeric/noise_gradient.h"

using namespace isoscope;

namespace {

constexpr std::uint64_t seed = 20260;

NoiseGradient noiseAt(NoiseKind kind, const std::array<double, 3>& p) {
    if (kind == NoiseKind::gradient) return gradientNoiseWithGradient(p[0], p[1], p[2]);
    return vectorNoiseWithGradient(p[0], p[1], p[2])[static_cast<int>(kind)];
}

double lengthOf(const NoiseGradient& noise) {
    return std::hypot(noise.gradient[0], noise.gradient[1], noise.gradient[2]);
}

}  // namespace

class NoiseRangeTest : public QObject {
    Q_OBJECT

  private slots:
    void initTestCase() { qInfo("seed %llu", static_cast<unsigned long long>(seed)); }

    void holdsTheNoiseAndItsGradient() {
        std::mt19937_64 random(seed);
        int tight = 0;
        for (int round = 0; round < 6000; ++round) {
            const NoiseKind kind = static_cast<NoiseKind>(random() % 4);
            const double size = std::pow(10.0, std::uniform_real_distribution<double>(-4, 0.3)(random));
            std::array<double, 3> low, high;
            for (int k = 0; k < 3; ++k) {
                low[k] = std::uniform_real_distribution<double>(-60, 60)(random);
                high[k] = low[k] + size * std::uniform_real_distribution<double>(0, 1)(random);
            }
            const NoiseRange range = noiseRange(kind, low, high);
            tight += range.steepness < 2;
            for (int sample = 0; sample < 8; ++sample) {
                std::array<double, 3> p;
                for (int k = 0; k < 3; ++k)
                    p[k] = sample == 0   ? low[k]
                           : sample == 1 ? high[k]
                                         : std::uniform_real_distribution<double>(low[k], high[k])(random);
                const NoiseGradient noise = noiseAt(kind, p);
                QVERIFY(range.value.low <= noise.value && noise.value <= range.value.high);
                QVERIFY(lengthOf(noise) <= range.steepness);
                for (int k = 0; k < 3; ++k)
                    QVERIFY(range.slope[k].low <= noise.gradient[k] &&
                            noise.gradient[k] <= range.slope[k].high);
            }
        }
        QVERIFY2(tight > 2000, qPrintable(QString::number(tight)));
    }

    /// Within a lattice cell and across several: the gradients at two places of a box differ by no more than
    /// the second derivatives times the way between them.
    void gradientsChangeByTheirSecondDerivatives() {
        std::mt19937_64 random(seed + 2);
        int tight = 0;
        for (int round = 0; round < 6000; ++round) {
            const NoiseKind kind = static_cast<NoiseKind>(random() % 4);
            const double size = std::pow(10.0, std::uniform_real_distribution<double>(-4, 0.3)(random));
            std::array<double, 3> low, high;
            for (int k = 0; k < 3; ++k) {
                low[k] = std::uniform_real_distribution<double>(-60, 60)(random);
                high[k] = low[k] + size * std::uniform_real_distribution<double>(0, 1)(random);
            }
            const NoiseRange range = noiseRange(kind, low, high);
            tight += range.bend[0].high - range.bend[0].low < 1;
            std::array<double, 3> p, q;
            for (int k = 0; k < 3; ++k) {
                p[k] = std::uniform_real_distribution<double>(low[k], high[k])(random);
                q[k] = std::uniform_real_distribution<double>(low[k], high[k])(random);
            }
            const NoiseGradient from = noiseAt(kind, p), to = noiseAt(kind, q);
            constexpr int index[3][3] = {{0, 1, 2}, {1, 3, 4}, {2, 4, 5}};
            for (int i = 0; i < 3; ++i) {
                SlopeRange change{};
                for (int j = 0; j < 3; ++j) change = change + (q[j] - p[j]) * range.bend[index[i][j]];
                // Gradient noise rounds its places.
                constexpr double rounding = 1e-7;
                const double seen = to.gradient[i] - from.gradient[i];
                QVERIFY(change.low - rounding <= seen && seen <= change.high + rounding);
            }
        }
        QVERIFY2(tight > 1500, qPrintable(QString::number(tight)));
    }

    void aPointLeavesRoundingAlone() {
        for (const NoiseKind kind : {NoiseKind::lattice0, NoiseKind::gradient}) {
            const std::array<double, 3> p{3.3, -1.7, 12.4};
            const NoiseRange range = noiseRange(kind, p, p);
            QVERIFY(range.value.high - range.value.low < 1e-7 &&
                    range.steepness - lengthOf(noiseAt(kind, p)) < 1e-6);
        }
    }

    /// Halving a box quarters what its steepness bound is too high: the reason for Bernstein's form.
    void isTightToSecondOrder() {
        std::mt19937_64 random(seed + 1);
        double coarse = 0, fine = 0;
        for (int round = 0; round < 200; ++round) {
            std::array<double, 3> low;
            for (double& coordinate : low)
                coordinate = std::floor(std::uniform_real_distribution<double>(-30, 30)(random)) +
                             std::uniform_real_distribution<double>(0, 0.7)(random);
            for (const double size : {0.25, 0.0625}) {
                const std::array<double, 3> high{low[0] + size, low[1] + size, low[2] + size};
                double longest = 0;
                for (int i = 0; i <= 6; ++i)
                    for (int j = 0; j <= 6; ++j)
                        for (int k = 0; k <= 6; ++k)
                            longest = std::max(longest,
                                               lengthOf(noiseAt(NoiseKind::lattice0,
                                                                {low[0] + size * i / 6, low[1] + size * j / 6,
                                                                 low[2] + size * k / 6})));
                (size > 0.1 ? coarse : fine) +=
                    noiseRange(NoiseKind::lattice0, low, high).steepness - longest;
            }
        }
        QVERIFY2(fine * 8 < coarse, qPrintable(QString("%1 %2").arg(coarse).arg(fine)));
    }

    void manyCellsHaveTheBoundsThatHoldEverywhere() {
        QCOMPARE(noiseRange(NoiseKind::lattice0, {-9, -9, -9}, {9, 9, 9}).steepness,
                 latticeNoiseBounds.lipschitz);
    }
};

QTEST_APPLESS_MAIN(NoiseRangeTest)
#include "noise_range_test.moc"
