// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/shapes/solids/poly.h"

#include <QTest>
#include <random>

#include "core/roots/polynomial/real_roots.h"

using namespace isoscope;

namespace {

/// x^4 + y^4 + z^4 = 1
Poly roundedCube() {
    std::vector<double> coefficients;
    for (int x = 4; x >= 0; --x)
        for (int y = 4 - x; y >= 0; --y)
            for (int z = 4 - x - y; z >= 0; --z) {
                const bool corner = x == 4 || y == 4 || z == 4;
                coefficients.push_back(corner ? 1 : x + y + z == 0 ? -1 : 0);
            }
    return Poly(4, coefficients);
}

NearestHit firstHit(const Poly& poly, const Ray& ray, double nearLimit) {
    TraceContext context;
    context.nearLimit = nearLimit;
    NearestHit hit;
    poly.nearest({&ray, 1}, context, {&hit, 1});
    return hit;
}

}  // namespace

class PolyTest : public QObject {
    Q_OBJECT

  private slots:
    void raysThatLeaveTheSurfaceNeedNoWideArithmetic_data() {
        QTest::addColumn<double>("nearLimit");
        QTest::newRow("shadows") << 1e-3;
        QTest::newRow("mirrors") << 1e-4;
    }
    void raysThatLeaveTheSurfaceNeedNoWideArithmetic() {
        QFETCH(double, nearLimit);
        const Poly poly = roundedCube();
        std::mt19937_64 random(31);
        std::normal_distribution<double> any;
        int through = 0, away = 0;
        const std::size_t before = realRootsFallbacks();
        for (int i = 0; i < 500; ++i) {
            const Ray ray{{any(random), any(random), -5},
                          glm::normalize(glm::dvec3(any(random), any(random), 9))};
            const NearestHit hit = firstHit(poly, ray, 0);
            if (!hit.found) continue;
            const glm::dvec3 aim = glm::normalize(glm::dvec3(any(random), any(random), any(random)));
            const NearestHit next = firstHit(poly, {hit.hit.point, aim}, nearLimit);
            // Convex: only rays into the solid meet it once more.
            const double rise = glm::dot(aim, hit.hit.normal);
            if (std::abs(rise) < 0.1) continue;
            QCOMPARE(next.found, rise < 0);
            ++(rise < 0 ? through : away);
        }
        QVERIFY(through > 50 && away > 50);
        QCOMPARE(realRootsFallbacks(), before);
    }
};

QTEST_APPLESS_MAIN(PolyTest)
#include "poly_test.moc"
