// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/numeric/noise_range.h"

#include <QTest>
#include <random>
#include <thread>

#include "core/numeric/noise_bounds.h"
#include "core/numeric/noise_gradient.h"
#include "tests/support/instruction_sets.h"
#include "tests/support/test_setting.h"

using namespace isoscope;

namespace {

const std::uint64_t seed = test::seedSetting(20260);

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

    static void addInstructionSets() {
        QTest::addColumn<qint64>("target");
        for (const auto& [target, name] : test::instructionSets()) QTest::newRow(name) << qint64{target};
    }

  private slots:
    void initTestCase() { qInfo("seed %llu", static_cast<unsigned long long>(seed)); }

    /// What is kept of the last box answers for that box alone: boxes that differ in one end only, by turns,
    /// against those that a thread asks about first.
    void boxesBeforeChangeNothing() {
        std::mt19937_64 random(seed);
        std::array<double, 3> low{0.2, 0.3, 0.4}, high{0.7, 1.2, 0.9};
        for (int round = 0; round < 200; ++round) {
            (random() % 2 == 0 ? low : high)[random() % 3] +=
                std::uniform_real_distribution<double>(-0.01, 0.01)(random);
            const NoiseKind kind = static_cast<NoiseKind>(random() % 4);
            NoiseRange first;
            std::thread([&] { first = noiseRange(kind, low, high); }).join();
            const NoiseRange range = noiseRange(kind, low, high);
            QCOMPARE(range.value.low, first.value.low);
            QCOMPARE(range.value.high, first.value.high);
            QCOMPARE(range.steepness, first.steepness);
            for (std::size_t k = 0; k < 6; ++k) QCOMPARE(range.bend[k].high, first.bend[k].high);
        }
    }

    void holdsTheNoiseAndItsGradient_data() { addInstructionSets(); }
    void holdsTheNoiseAndItsGradient() {
        QFETCH(qint64, target);
        const test::ForcedInstructionSet forced(target);
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
    void gradientsChangeByTheirSecondDerivatives_data() { addInstructionSets(); }
    void gradientsChangeByTheirSecondDerivatives() {
        QFETCH(qint64, target);
        const test::ForcedInstructionSet forced(target);
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

    /// At a point every range is the number itself, but for rounding, on both sides of lattice planes and of
    /// 0; the second derivatives are those that differences of the gradient have.
    void aPointLeavesRoundingAlone() {
        constexpr std::array<std::array<std::size_t, 2>, 6> axes{
            {{0, 0}, {0, 1}, {0, 2}, {1, 1}, {1, 2}, {2, 2}}};
        std::mt19937_64 random(seed + 3);
        for (int round = 0; round < 400; ++round) {
            const NoiseKind kind = static_cast<NoiseKind>(round % 4);
            std::array<double, 3> p;
            for (double& at : p)
                at = std::floor(std::uniform_real_distribution<double>(-60, 60)(random)) +
                     std::uniform_real_distribution<double>(0.05, 0.95)(random);
            const NoiseRange range = noiseRange(kind, p, p);
            const NoiseGradient noise = noiseAt(kind, p);
            // Gradient noise is enclosed around its place, which it rounds.
            const double rounding = kind == NoiseKind::gradient ? 1e-6 : 1e-9;
            const auto isNear = [&](const SlopeRange& found, double wanted, double error) {
                return std::abs(found.low - wanted) < error && std::abs(found.high - wanted) < error;
            };
            QVERIFY(isNear(range.value, noise.value, rounding));
            QVERIFY(std::abs(range.steepness - lengthOf(noise)) < rounding);
            for (std::size_t k = 0; k < 3; ++k) QVERIFY(isNear(range.slope[k], noise.gradient[k], rounding));
            for (std::size_t b = 0; b < 6; ++b) {
                constexpr double way = 1e-4;
                std::array<double, 3> before = p, behind = p;
                before[axes[b][1]] -= way;
                behind[axes[b][1]] += way;
                const double bend = (noiseAt(kind, behind).gradient[axes[b][0]] -
                                     noiseAt(kind, before).gradient[axes[b][0]]) /
                                    (2 * way);
                QVERIFY2(isNear(range.bend[b], bend, 2e-3), qPrintable(QString("%1: %2").arg(b).arg(bend)));
            }
        }
    }

    /// A range over a box is no wider than its length along the axes makes it.
    void rangesAreAsNarrowAsTheirBoxes_data() { addInstructionSets(); }
    void rangesAreAsNarrowAsTheirBoxes() {
        QFETCH(qint64, target);
        const test::ForcedInstructionSet forced(target);
        std::mt19937_64 random(seed + 4);
        for (int round = 0; round < 400; ++round) {
            const NoiseKind kind = static_cast<NoiseKind>(round % 4);
            const NoiseBounds& bounds =
                kind == NoiseKind::gradient ? gradientNoiseBounds : latticeNoiseBounds;
            std::array<double, 3> low, high;
            double length = 0;
            for (std::size_t k = 0; k < 3; ++k) {
                // Every other one across a plane of the lattice.
                low[k] = std::floor(std::uniform_real_distribution<double>(-60, 60)(random)) +
                         (round % 8 < 4 ? 0.4 : 0.998);
                high[k] = low[k] + 0.004;
                length += high[k] - low[k];
            }
            const NoiseRange range = noiseRange(kind, low, high);
            QVERIFY(range.value.high - range.value.low <= bounds.slope * length + 1e-6);
            for (const SlopeRange& slope : range.slope)
                QVERIFY(slope.high - slope.low <= bounds.bend * length + 1e-6);
            QVERIFY(range.steepness - lengthOf(noiseAt(kind, low)) <= bounds.curvature * length + 1e-6);
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
