// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/numeric/noise_bounds.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <QTest>
#include <random>
#include <vector>

#include "core/numeric/noise.h"
#include "core/numeric/noise_gradient.h"

using namespace isoscope;

namespace {

/// S(t) and its first three derivatives.
double blend(int order, double t) {
    switch (order) {
        case 0:
            return t * t * (3 - 2 * t);
        case 1:
            return 6 * t * (1 - t);
        case 2:
            return 6 - 12 * t;
        default:
            return -12;
    }
}

/// Weight of a corner (one bit an axis), differentiated `order[axis]` times along each axis.
double weight(int corner, const std::array<double, 3>& f, std::array<int, 3> order) {
    double product = 1;
    for (int axis = 0; axis < 3; ++axis) {
        const bool upper = corner >> axis & 1;
        const double value = blend(order[axis], f[axis]);
        product *= upper ? value : (order[axis] == 0 ? 1 - value : -value);
    }
    return product;
}

/// A derivative of W (constant + e . r) is linear in the corner's coefficients: this is the vector they are
/// multiplied with. The first component belongs to the constant, the others to e.
std::array<double, 4> functional(int corner, const std::array<double, 3>& f, std::array<int, 3> order) {
    std::array<double, 4> v;
    v[0] = weight(corner, f, order);
    for (int axis = 0; axis < 3; ++axis) {
        const double r = f[axis] - (corner >> axis & 1);
        v[axis + 1] = v[0] * r;
        if (order[axis] > 0) {
            std::array<int, 3> lower = order;
            --lower[axis];
            v[axis + 1] += order[axis] * weight(corner, f, lower);
        }
    }
    return v;
}

/// The coefficients (half of the first) that a corner of lattice noise can have, for all three components.
const std::vector<std::array<double, 4>>& latticeEntries() {
    static const std::vector<std::array<double, 4>> entries = [] {
        std::vector<std::array<double, 4>> all;
        const auto& v = latticeValues();
        for (int n = 0; n < 256 + 8; ++n) all.push_back({v[n] / 2, v[n + 1], v[n + 2], v[n + 3]});
        return all;
    }();
    return entries;
}

/// The largest value that the sum over the corners can have when every corner takes its entry at will.
double latticeLargest(const std::array<double, 3>& f, std::array<int, 3> order) {
    double highest = 0, lowest = 0;
    for (int corner = 0; corner < 8; ++corner) {
        const auto v = functional(corner, f, order);
        double high = -INFINITY, low = INFINITY;
        for (const auto& e : latticeEntries()) {
            const double value = e[0] * v[0] + e[1] * v[1] + e[2] * v[2] + e[3] * v[3];
            high = std::max(high, value);
            low = std::min(low, value);
        }
        highest += high;
        lowest += low;
    }
    return std::max(highest, -lowest);
}

/// Gradient noise: no constant, and e is any unit vector.
double gradientLargest(const std::array<double, 3>& f, std::array<int, 3> order) {
    double sum = 0;
    for (int corner = 0; corner < 8; ++corner) {
        const auto v = functional(corner, f, order);
        sum += std::hypot(v[1], v[2], v[3]);
    }
    return sum * (1 + 1e-9);
}

/// A bound on how fast `largest` changes along `axis` near f (within `reach` on each axis): the functionals'
/// own derivatives with all coefficients at most 1, each factor at its worst.
double steepness(const std::array<double, 3>& f, double reach, std::array<int, 3> order, int axis) {
    ++order[axis];
    const auto worst = [&](int k, int n) {
        // Largest |d^n S| over [f - reach, f + reach]; of S itself 1.
        const double low = std::max(0.0, f[k] - reach), high = std::min(1.0, f[k] + reach);
        if (n == 0) return 1.0;
        if (n == 1) return low < 0.5 && high > 0.5 ? 1.5 : std::max(blend(1, low), blend(1, high));
        return n == 2 ? std::max(std::abs(blend(2, low)), std::abs(blend(2, high))) : n == 3 ? 12.0 : 0.0;
    };
    // Sum over the corners: the weights add up to 1 along axes without derivative, to twice the slope along
    // others.
    const auto product = [&](const std::array<int, 3>& n) {
        double value = 1;
        for (int k = 0; k < 3; ++k) value *= n[k] == 0 ? 1 : 2 * worst(k, n[k]);
        return value;
    };
    double sum = product(order) * 3.5;
    for (int k = 0; k < 3; ++k) {
        if (order[k] == 0) continue;
        std::array<int, 3> lower = order;
        --lower[k];
        sum += order[k] * product(lower);
    }
    return sum;
}

/// Proves largest <= bound over the unit cube by branch and bound; the number of boxes looked at, or 0 for a
/// failure.
template <class Largest>
std::uint64_t prove(Largest largest, std::array<int, 3> order, double bound) {
    struct Box {
        std::array<double, 3> center;
        double reach;
    };
    std::vector<Box> open{{{0.5, 0.5, 0.5}, 0.5}};
    std::uint64_t boxes = 0;
    while (!open.empty()) {
        const Box box = open.back();
        open.pop_back();
        ++boxes;
        const double value = largest(box.center, order);
        if (value > bound) return 0;
        double slack = 0;
        for (int axis = 0; axis < 3; ++axis)
            slack += steepness(box.center, box.reach, order, axis) * box.reach;
        if (value + slack <= bound) continue;
        if (box.reach < 1e-4) return 0;
        for (int child = 0; child < 8; ++child) {
            Box part{box.center, box.reach / 2};
            for (int axis = 0; axis < 3; ++axis)
                part.center[axis] += (child >> axis & 1 ? 0.5 : -0.5) * box.reach;
            open.push_back(part);
        }
    }
    return boxes;
}

constexpr std::array<int, 3> plain{0, 0, 0}, slopeX{1, 0, 0}, slopeY{0, 1, 0}, slopeZ{0, 0, 1},
    bendX{2, 0, 0}, bendY{0, 2, 0}, bendZ{0, 0, 2}, twistXY{1, 1, 0}, twistXZ{1, 0, 1}, twistYZ{0, 1, 1};

}  // namespace

class NoiseBoundsTest : public QObject {
    Q_OBJECT

  private slots:
    void latticeNoiseIsBounded() {
        const NoiseBounds& b = latticeNoiseBounds;
        QVERIFY(prove(latticeLargest, plain, b.value) > 0);
        for (const auto& order : {slopeX, slopeY, slopeZ}) QVERIFY(prove(latticeLargest, order, b.slope) > 0);
        for (const auto& order : {bendX, bendY, bendZ}) QVERIFY(prove(latticeLargest, order, b.bend) > 0);
        for (const auto& order : {twistXY, twistXZ, twistYZ})
            QVERIFY(prove(latticeLargest, order, b.twist) > 0);
    }

    void gradientNoiseIsBounded() {
        // The three axes are alike.
        const NoiseBounds& b = gradientNoiseBounds;
        QVERIFY(prove(gradientLargest, plain, b.value) > 0);
        QVERIFY(prove(gradientLargest, slopeX, b.slope) > 0);
        QVERIFY(prove(gradientLargest, bendX, b.bend) > 0);
        QVERIFY(prove(gradientLargest, twistXY, b.twist) > 0);
    }

    void aBoundThatIsTooSmallIsRefused() {
        QCOMPARE(prove(latticeLargest, slopeX, 3.5), std::uint64_t(0));
        QCOMPARE(prove(gradientLargest, bendX, 11.0), std::uint64_t(0));
    }

    void theFunctionalsAreThoseOfTheNoise() {
        // Slopes of the noise itself never leave the proven bounds, and come near the bound of the worst
        // combination.
        std::mt19937_64 random(5);
        std::uniform_real_distribution<double> coordinate(-500, 500);
        double steepest = 0, steepestGradient = 0;
        for (int round = 0; round < 100000; ++round) {
            const double x = coordinate(random), y = coordinate(random), z = coordinate(random);
            const NoiseGradient lattice = latticeNoiseWithGradient(x, y, z);
            const NoiseGradient gradient = gradientNoiseWithGradient(x, y, z);
            QVERIFY(std::abs(lattice.value) <= latticeNoiseBounds.value);
            QVERIFY(std::abs(gradient.value) <= gradientNoiseBounds.value);
            for (int axis = 0; axis < 3; ++axis) {
                steepest = std::max(steepest, std::abs(lattice.gradient[axis]));
                steepestGradient = std::max(steepestGradient, std::abs(gradient.gradient[axis]));
            }
        }
        QVERIFY(steepest <= latticeNoiseBounds.slope && steepest > 0.4 * latticeNoiseBounds.slope);
        QVERIFY(steepestGradient <= gradientNoiseBounds.slope &&
                steepestGradient > 0.4 * gradientNoiseBounds.slope);
    }
};

QTEST_APPLESS_MAIN(NoiseBoundsTest)
#include "noise_bounds_test.moc"
