// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/numeric/noise_gradient.h"

#include <bit>
#include <cmath>
#include <QTest>
#include <random>

#include "core/numeric/noise.h"
#include "tests/support/test_setting.h"

using namespace isoscope;

namespace {

const std::uint64_t seed = test::seedSetting(77);

bool same(double a, double b) { return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b); }

std::array<double, 3> point(std::mt19937_64& random) {
    std::uniform_real_distribution<double> coordinate(-30, 30);
    return {coordinate(random), coordinate(random), coordinate(random)};
}

/// Central difference of f along `axis`.
template <class Field>
double difference(Field f, std::array<double, 3> p, int axis) {
    constexpr double h = 1e-4;
    auto q = p;
    p[axis] -= h;
    q[axis] += h;
    return (f(q) - f(p)) / (q[axis] - p[axis]);
}

}  // namespace

class NoiseGradientTest : public QObject {
    Q_OBJECT

  private slots:
    void initTestCase() { qInfo("seed %llu", static_cast<unsigned long long>(seed)); }

    void theValueIsTheSameToTheLastBit() {
        std::mt19937_64 random(seed);
        for (int round = 0; round < 20000; ++round) {
            const auto [x, y, z] = point(random);
            for (const int generator : {0, 1, 2, 3})
                QVERIFY(same(noiseWithGradient(generator, x, y, z).value, noise(generator, x, y, z)));
            const auto vector = vectorNoise(x, y, z);
            const auto derived = vectorNoiseWithGradient(x, y, z);
            for (int k = 0; k < 3; ++k) QVERIFY(same(derived[k].value, vector[k]));
        }
    }

    void theGradientAgreesWithDifferences() {
        std::mt19937_64 random(seed);
        int compared = 0;
        for (int round = 0; round < 20000; ++round) {
            const auto p = point(random);
            for (const int generator : {1, 2, 3}) {
                const auto f = [&](const std::array<double, 3>& q) {
                    return noise(generator, q[0], q[1], q[2]);
                };
                const NoiseGradient got = noiseWithGradient(generator, p[0], p[1], p[2]);
                // Next to the clipping values the difference sees both sides.
                if (got.value < 1e-3 || got.value > 1 - 1e-3) continue;
                for (int axis = 0; axis < 3; ++axis)
                    QVERIFY(std::abs(got.gradient[axis] - difference(f, p, axis)) < 2e-4);
                ++compared;
            }
            for (int k = 0; k < 3; ++k) {
                const auto f = [&](const std::array<double, 3>& q) {
                    return vectorNoise(q[0], q[1], q[2])[k];
                };
                const NoiseGradient got = vectorNoiseWithGradient(p[0], p[1], p[2])[k];
                for (int axis = 0; axis < 3; ++axis)
                    QVERIFY(std::abs(got.gradient[axis] - difference(f, p, axis)) < 5e-4);
            }
        }
        QVERIFY(compared > 50000);
    }

    void clippedNoiseIsFlat() {
        std::mt19937_64 random(seed);
        int clipped = 0;
        for (int round = 0; round < 20000; ++round) {
            const auto [x, y, z] = point(random);
            const NoiseGradient got = noiseWithGradient(1, x, y, z);
            if (got.value > 0 && got.value < 1) continue;
            ++clipped;
            for (const double slope : got.gradient) QCOMPARE(slope, 0.0);
        }
        QVERIFY(clipped > 100);
    }
};

QTEST_APPLESS_MAIN(NoiseGradientTest)
#include "noise_gradient_test.moc"
