// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/roots/povray_hits.h"

#include <QTest>
#include <cmath>
#include <random>
#include <vector>

#include "core/roots/line_columns.h"

using namespace isoscope;

namespace {

/// As docs/povray/solver.md says it, of one line.
double plainHit(double near, double far, double tolerance, double root) {
    while (far - near >= tolerance) {
        const double middle = (near + far) / 2;
        if (!(near < middle && middle < far)) return root;
        (root <= middle ? far : near) = middle;
    }
    return far;
}

struct Lines {
    std::vector<double> root, near, far;

    std::vector<double> hits(double tolerance) const {
        Lines copy = *this;
        // Behind the last line stands what would be halved for ever.
        copy.root.resize(root.size() + LineColumns::padding, 0);
        copy.near.resize(root.size() + LineColumns::padding, -1e300);
        copy.far.resize(root.size() + LineColumns::padding, 1e300);
        endPovrayHalvings(root.size(), tolerance, copy.root.data(), copy.near.data(), copy.far.data());
        copy.far.resize(root.size());
        return copy.far;
    }
};

double hitOf(double root, double near, double far, double tolerance) {
    return Lines{{root}, {near}, {far}}.hits(tolerance)[0];
}

}  // namespace

class PovrayHitsTest : public QObject {
    Q_OBJECT

  private slots:
    void manyLinesEndWhereEachDoes();
    void aPlaceBehindTheRootWithinTheTolerance();
    void linesThatCannotBeHalvedKeepTheirRoot();
};

void PovrayHitsTest::manyLinesEndWhereEachDoes() {
    constexpr unsigned seed = 41;
    qInfo("seed %u", seed);
    std::mt19937_64 random(seed);
    std::uniform_real_distribution<double> unit(0, 1);
    for (std::size_t count = 0; count < 80; ++count) {
        const double tolerance = std::pow(10, -12 * unit(random));
        Lines lines;
        for (std::size_t k = 0; k < count; ++k) {
            lines.near.push_back(10 * unit(random) - 5);
            lines.far.push_back(lines.near[k] + std::pow(10, 2 - 6 * unit(random)));
            lines.root.push_back(std::lerp(lines.near[k], lines.far[k], unit(random)));
        }
        const std::vector<double> hits = lines.hits(tolerance);
        for (std::size_t k = 0; k < count; ++k)
            QCOMPARE(hits[k], plainHit(lines.near[k], lines.far[k], tolerance, lines.root[k]));
    }
}

void PovrayHitsTest::aPlaceBehindTheRootWithinTheTolerance() {
    // Halved to [0.28125, 0.3125]: narrower than 0.04.
    QCOMPARE(hitOf(0.3, 0, 1, 0.04), 0.3125);
    // A root in the middle belongs to the nearer half.
    QCOMPARE(hitOf(0.5, 0, 1, 0.6), 0.5);
    // Nothing to be halved.
    QCOMPARE(hitOf(0.3, 0, 1, 2), 1.0);
    // As wide as the tolerance is still halved.
    QCOMPARE(hitOf(0.3, 0, 1, 1), 0.5);
}

void PovrayHitsTest::linesThatCannotBeHalvedKeepTheirRoot() {
    const double next = std::nextafter(1e6, 2e6);
    QCOMPARE(hitOf(1e6, 1e6, next, 1e-12), 1e6);
    QCOMPARE(hitOf(7, 7, 7, 0), 7.0);
    QCOMPARE(hitOf(0.3, 0, 1, 0), 0.3);
    const double infinite = std::numeric_limits<double>::infinity();
    QCOMPARE(hitOf(3, 0, infinite, 1e-3), 3.0);
}

QTEST_APPLESS_MAIN(PovrayHitsTest)
#include "povray_hits_test.moc"
