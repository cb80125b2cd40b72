// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/numeric/noise_bounds.h"

#include <cmath>
#include <QTest>
#include <random>

#include "core/numeric/noise.h"
#include "core/numeric/noise_gradient.h"
#include "tests/support/noise_bound_proof.h"

using namespace isoscope;
using test::NoiseBoundProof;

namespace {

/// The choices behind component k of the vector noise; k = 0 is plain noise.
std::vector<std::array<double, 4>> latticeChoices(int k) {
    const double* v = latticeValues().data() + 4 * k;
    std::vector<std::array<double, 4>> choices;
    for (int n = 0; n < 256; ++n) choices.push_back({v[n] / 2, v[n + 1], v[n + 2], v[n + 3]});
    return choices;
}

NoiseBoundProof proofOf(int k) {
    return k < 3 ? NoiseBoundProof(latticeChoices(k)) : NoiseBoundProof::ofUnitSlopes();
}

const NoiseBounds& boundsOf(int k) { return k < 3 ? latticeNoiseBounds : gradientNoiseBounds; }

/// All directions on demand: some minutes, for which QTEST_FUNCTION_TIMEOUT has to be raised.
bool isFull() { return qEnvironmentVariableIsSet("ISOSCOPE_FULL_PROOFS"); }

}  // namespace

class NoiseBoundsTest : public QObject {
    Q_OBJECT

    void addNoises() {
        QTest::addColumn<int>("k");
        for (int k = 0; k < 3; ++k) QTest::addRow("L_%d", k) << k;
        QTest::newRow("K") << 3;
    }

  private slots:
    void rangeIsProven_data() { addNoises(); }
    void rangeIsProven() {
        QFETCH(int, k);
        NoiseBoundProof proof = proofOf(k);
        QVERIFY(proof.holds(0, {1, 0, 0}, 1, boundsOf(k).high));
        QVERIFY(proof.holds(0, {1, 0, 0}, -1, -boundsOf(k).low));
        QVERIFY(boundsOf(k).value >= boundsOf(k).high && boundsOf(k).value >= -boundsOf(k).low);
    }

    void partialDerivativesAreProven_data() { addNoises(); }
    void partialDerivativesAreProven() {
        QFETCH(int, k);
        NoiseBoundProof proof = proofOf(k);
        for (const NoiseBoundProof::Vector axis : {NoiseBoundProof::Vector{1, 0, 0}, {0, 1, 0}, {0, 0, 1}})
            for (const int sign : {-1, 1}) QVERIFY(proof.holds(1, axis, sign, boundsOf(k).slope));
    }

    void secondDerivativesAreProven_data() { addNoises(); }
    void secondDerivativesAreProven() {
        QFETCH(int, k);
        NoiseBoundProof proof = proofOf(k);
        for (int i = 0; i < 3; ++i)
            for (int j = i; j < 3; ++j)
                for (const int sign : {-1, 1})
                    QVERIFY(proof.holdsForAxes(i, j, sign, i == j ? boundsOf(k).bend : boundsOf(k).twist));
        qInfo("%ld boxes", proof.boxCount());
    }

    void gradientIsProven_data() { addNoises(); }
    void gradientIsProven() {
        QFETCH(int, k);
        NoiseBoundProof proof = proofOf(k);
        QVERIFY(proof.holdsForAllDirections(1, boundsOf(k).lipschitz, isFull() ? 1 : 23));
        qInfo("%ld boxes", proof.boxCount());
    }

    void curvatureIsProven_data() { addNoises(); }
    void curvatureIsProven() {
        QFETCH(int, k);
        NoiseBoundProof proof = proofOf(k);
        QVERIFY(proof.holdsForAllDirections(2, boundsOf(k).curvature, isFull() ? 1 : 61));
        qInfo("%ld boxes", proof.boxCount());
    }

    void thirdDerivativeIsProven() {
        for (int k = 0; k < 3; ++k) {
            NoiseBoundProof proof = proofOf(k);
            QVERIFY(proof.holdsForAllDirections(3, latticeThirdDerivative, isFull() ? 1 : 151));
            qInfo("%ld boxes", proof.boxCount());
        }
        QVERIFY(!proofOf(0).holdsForAllDirections(3, 50, 61));
    }

    void curvatureInAPlaneIsProven() {
        for (int k = 0; k < 3; ++k) {
            NoiseBoundProof proof = proofOf(k);
            QVERIFY(proof.holdsInPlane(latticePlaneCurvature));
            qInfo("%ld boxes", proof.boxCount());
        }
        QVERIFY(!proofOf(0).holdsInPlane(16.3));
    }

    /// The proof machine itself: what does not hold is not proven.
    void falseBoundsAreRefused() {
        NoiseBoundProof lattice(latticeChoices(0));
        QVERIFY(!lattice.holds(0, {1, 0, 0}, 1, 1.3));
        QVERIFY(!lattice.holds(1, {0, 0, 1}, 1, 3.5));
        QVERIFY(!lattice.holds(2, {1, 0, 0}, -1, 18));
        QVERIFY(!lattice.holdsForAxes(0, 1, 1, 8));
        QVERIFY(!NoiseBoundProof::ofUnitSlopes().holds(0, {1, 0, 0}, 1, 0.86));
    }

    void randomPointsStayWithin() {
        constexpr unsigned seed = 99;
        qInfo("seed %u", seed);
        std::mt19937 random(seed);
        std::uniform_real_distribution<double> coordinate(-2000, 2000);
        double steepest[2] = {0, 0};
        for (int i = 0; i < 20000; ++i) {
            const double x = coordinate(random), y = coordinate(random), z = coordinate(random);
            for (int generator = 0; generator < 4; ++generator) {
                const NoiseBounds bounds = unclippedNoiseBounds(generator);
                const NoiseGradient noise = noiseWithGradient(generator, x, y, z);
                const auto [gx, gy, gz] = noise.gradient;
                QVERIFY(std::hypot(gx, gy, gz) <= bounds.lipschitz);
                QVERIFY(std::abs(gx) <= bounds.slope);
                // Before the clipping: a value strictly between is the unclipped one.
                if (noise.value > 0 && noise.value < 1)
                    QVERIFY(noise.value >= bounds.low && noise.value <= bounds.high);
            }
            // The raw noises, and that their bounds are of the right size.
            for (const bool isLattice : {true, false}) {
                const NoiseBounds& bounds = isLattice ? latticeNoiseBounds : gradientNoiseBounds;
                const NoiseGradient raw =
                    isLattice ? latticeNoiseWithGradient(x, y, z) : gradientNoiseWithGradient(x, y, z);
                QVERIFY(raw.value >= bounds.low && raw.value <= bounds.high);
                for (const double slope : raw.gradient) {
                    QVERIFY(std::abs(slope) <= bounds.slope);
                    steepest[isLattice] = std::max(steepest[isLattice], std::abs(slope) / bounds.slope);
                }
            }
            // The gradient itself does not change faster than the curvature allows.
            const auto here = noiseWithGradient(2, x, y, z),
                       there = noiseWithGradient(2, x + 0.05, y - 0.03, z + 0.02);
            if (here.value <= 0 || here.value >= 1 || there.value <= 0 || there.value >= 1) continue;
            double change = 0;
            for (int axis = 0; axis < 3; ++axis)
                change = std::hypot(change, here.gradient[axis] - there.gradient[axis]);
            QVERIFY(change <= unclippedNoiseBounds(2).curvature * std::hypot(0.05, 0.03, 0.02) * (1 + 1e-9));
        }
        QVERIFY(steepest[0] > 0.4 && steepest[1] > 0.4);
    }
};

QTEST_APPLESS_MAIN(NoiseBoundsTest)
#include "noise_bounds_test.moc"
