// SPDX-License-Identifier: GPL-3.0-or-later
#include <glm/geometric.hpp>
#include <limits>
#include <QTest>
#include <random>

#include "core/shapes/solids/box.h"
#include "core/shapes/solids/plane.h"
#include "core/shapes/solids/quadric.h"
#include "core/shapes/solids/sphere.h"

using namespace isoscope;

namespace {

constexpr double notANumber = std::numeric_limits<double>::quiet_NaN();
constexpr double infinity = std::numeric_limits<double>::infinity();

HitList hitsOf(const Shape& shape, const Ray& ray, RayInterval interval = {}) {
    TraceContext context;
    HitList hits;
    shape.intersect(ray, interval, context, hits);
    return hits;
}

}  // namespace

class PrimitivesTest : public QObject {
    Q_OBJECT

  private slots:
    void parameterIsInUnitsOfTheDirection() {
        const HitList hits = hitsOf(Sphere({0, 0, 0}, 1), {{0, 0, -5}, {0, 0, 2}});
        QCOMPARE(hits.size(), std::size_t(2));
        QCOMPARE(hits[0].t, 2.0);
        QCOMPARE(hits[1].t, 3.0);
        QCOMPARE(hits[0].normal, glm::dvec3(0, 0, -1));
        QCOMPARE(hits[1].normal, glm::dvec3(0, 0, 1));
    }

    void negativeRadiusCountsAsPositive() {
        QCOMPARE(hitsOf(Sphere({0, 0, 0}, -1), {{0, 0, -5}, {0, 0, 1}}).size(), std::size_t(2));
        QVERIFY(hitsOf(Sphere({0, 0, 0}, 0), {{0, 0, -5}, {0, 0, 1}}).empty());
    }

    void farOriginsKeepTheirDigits() {
        const HitList hits = hitsOf(Sphere({0, 0, 0}, 1), {{1e7, 0.5, 0}, {-1, 0, 0}});
        QVERIFY(std::abs(hits[0].t - (1e7 - std::sqrt(0.75))) < 1e-8);
    }

    void boxSortsItsCorners() {
        const Box box({2, -1, 3}, {-0.5, 0.25, 1});
        QCOMPARE(box.low(), glm::dvec3(-0.5, -1, 1));
        QCOMPARE(box.high(), glm::dvec3(2, 0.25, 3));
        const HitList hits = hitsOf(box, {{0, 0, 0}, {0, 0, 1}});
        QCOMPARE(hits[0].t, 1.0);
        QCOMPARE(hits[0].normal, glm::dvec3(0, 0, -1));
        QCOMPARE(hits[1].normal, glm::dvec3(0, 0, 1));
    }

    void boxFromInsideShowsTheExit() {
        const HitList hits = hitsOf(Box({-1, -1, -1}, {1, 1, 1}), {{0, 0, 0}, {0, -2, 0}});
        QCOMPARE(hits.size(), std::size_t(1));
        QCOMPARE(hits[0].t, 0.5);
        QCOMPARE(hits[0].normal, glm::dvec3(0, -1, 0));
    }

    void planeNormalNeedNotHaveUnitLength() {
        const Plane plane({0, 2, 0}, 4);
        QCOMPARE(hitsOf(plane, {{0, 0, 0}, {0, 1, 0}})[0].t, 4.0);
        TraceContext context;
        QVERIFY(plane.contains({0, 3.9, 0}, context));
        QVERIFY(!plane.contains({0, 4.1, 0}, context));
        QCOMPARE(plane.bounds().high.y, 4.0);
        QCOMPARE(Plane({-3, 0, 0}, 2).bounds().low.x, -2.0);
        QVERIFY(hitsOf(plane, {{0, 0, 0}, {1, 0, 0}}).empty());
    }

    void planeEndsAtTheHorizon() {
        const Plane plane({0, 1, 0}, 0);
        QCOMPARE(hitsOf(plane, {{0, 1, 0}, {1, -1e-6, 0}}).size(), std::size_t(1));
        QVERIFY(hitsOf(plane, {{0, 1, 0}, {1, -0.9e-7, 0}}).empty());
    }

    void planeWithoutANormalIsEmpty() {
        const Plane plane({0, 0, 0}, 4);
        TraceContext context;
        QVERIFY(hitsOf(plane, {{0, 0, 0}, {0, 1, 0}}).empty());
        QVERIFY(!plane.contains({0, 0, 0}, context));
    }

    void intervalLimitsTheHits() {
        const Sphere sphere({0, 0, 0}, 1);
        QCOMPARE(hitsOf(sphere, {{0, 0, -5}, {0, 0, 1}}, {4.5, 10}).size(), std::size_t(1));
        QCOMPARE(hitsOf(sphere, {{0, 0, -5}, {0, 0, 1}}, {4, 6}).size(), std::size_t(2));
        QVERIFY(hitsOf(sphere, {{0, 0, -5}, {0, 0, 1}}, {4.5, 5}).empty());
    }

    void brokenRaysMeetNothing() {
        for (const double bad : {notANumber, infinity, -infinity}) {
            const std::array<Ray, 3> rays{Ray{{bad, 0, 0}, {0, 0, 1}}, Ray{{0, 0, 0}, {0, bad, 1}},
                                          Ray{{0, 0, 0}, {bad, bad, bad}}};
            for (const Ray& ray : rays) {
                QVERIFY(hitsOf(Sphere({0, 0, 0}, 1), ray).empty());
                QVERIFY(hitsOf(Box({-1, -1, -1}, {1, 1, 1}), ray).empty());
                for (const Hit& hit : hitsOf(Plane({1, 2, 3}, 1), ray)) QVERIFY(std::isfinite(hit.t));
            }
        }
        QVERIFY(hitsOf(Sphere({0, 0, 0}, 1), {{0, 0, 0}, {0, 0, 0}}).empty());
        QVERIFY(hitsOf(Box({-1, -1, -1}, {1, 1, 1}), {{0, 0, 0}, {0, 0, 0}}).empty());
        QVERIFY(hitsOf(Sphere({notANumber, 0, 0}, 1), {{0, 0, -5}, {0, 0, 1}}).empty());
        QVERIFY(hitsOf(Box({notANumber, -1, -1}, {1, 1, 1}), {{0, 0, -5}, {0, 0, 1}}).empty());
    }

    void quadricsLieWithinTheirBounds() {
        const unsigned seed = std::random_device{}();
        qInfo("seed %u", seed);
        std::mt19937 random(seed);
        std::uniform_int_distribution<int> small(-2, 2);
        std::uniform_real_distribution<double> number(-3, 3);
        const auto vector = [&](auto& numbers) {
            return glm::dvec3(numbers(random), numbers(random), numbers(random));
        };
        int inside = 0, cutAway = 0;
        for (int k = 0; k < 2000; ++k) {
            const Quadric quadric(vector(small), glm::dvec3(k % 10 == 0 ? 1 : 0), vector(small),
                                  small(random));
            Bounds room;
            for (int axis = 0; axis < 3; ++axis) {
                if (small(random) > 0) room.low[axis] = number(random);
                if (small(random) > 0) room.high[axis] = number(random);
            }
            const Bounds box = quadric.boundsWithin(room);
            for (int axis = 0; axis < 3; ++axis)
                QVERIFY(!std::isnan(box.low[axis]) && !std::isnan(box.high[axis]));
            TraceContext context;
            for (int n = 0; n < 50; ++n) {
                const glm::dvec3 point = vector(number);
                if (!room.contains(point)) continue;
                const bool solid = quadric.contains(point, context);
                inside += solid;
                cutAway += !box.contains(point);
                QVERIFY(!solid || box.contains(point));
            }
        }
        QVERIFY(inside > 1000);
        QVERIFY(cutAway > 1000);
    }

    /// Its least value along an axis without numbers was asked for.
    void aQuadricWithinNothingIsNowhere() {
        const Quadric quadric(glm::dvec3(1), glm::dvec3(0), glm::dvec3(0), -1);
        const Bounds nothing{{0, 0, 2}, {1, 1, 1}}, box = quadric.boundsWithin(nothing);
        QCOMPARE(box.low, nothing.low);
        QCOMPARE(box.high, nothing.high);
    }
};

QTEST_APPLESS_MAIN(PrimitivesTest)
#include "primitives_test.moc"
