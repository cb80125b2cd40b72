// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/shapes/bounds.h"

#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <numbers>
#include <QTest>

#include "core/shapes/transform.h"

using namespace isoscope;

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
const Bounds unit{{-1, -1, -1}, {1, 1, 1}};

}  // namespace

class BoundsTest : public QObject {
    Q_OBJECT

  private slots:
    void clipsToPositiveParameters() {
        const RayInterval through = unit.clip({{0, 0, -3}, {0, 0, 2}});
        QCOMPARE(through.near, 1.0);
        QCOMPARE(through.far, 2.0);
        QCOMPARE(unit.clip({{0, 0, 0}, {1, 0, 0}}).near, 0.0);
        QVERIFY(unit.clip({{0, 0, 3}, {0, 0, 1}}).empty());
        QVERIFY(unit.clip({{0, 2, -3}, {0, 0, 1}}).empty());
        QVERIFY(!unit.clip({{0, 1, -3}, {0, 0, 1}}).empty());
    }

    void infiniteBoxesClipHalfSpaces() {
        QCOMPARE(Bounds().clip({{5, 5, 5}, {1, 0, 0}}).far, infinity);
        Bounds half;
        half.high.y = 1;
        QCOMPARE(half.clip({{0, 3, 0}, {0, -1, 0}}).near, 2.0);
        QVERIFY(half.clip({{0, 3, 0}, {0, 1, 0}}).empty());
        QVERIFY(half.clip({{0, 3, 0}, {1, 0, 0}}).empty());
        QVERIFY(!half.finite());
    }

    void brokenRaysAndEmptyBoxesAreMissed() {
        const double notANumber = std::numeric_limits<double>::quiet_NaN();
        QVERIFY(unit.clip({{notANumber, 0, 0}, {1, 0, 0}}).empty());
        QVERIFY(unit.clip({{0, 0, 0}, {notANumber, 0, 0}}).empty());
        QVERIFY(Bounds().clip({{infinity, 0, 0}, {-1, 0, 0}}).empty());
        const Bounds empty{{1, -1, -1}, {-1, 1, 1}};
        QVERIFY(empty.clip({{-5, 0, 0}, {1, 0, 0}}).empty());
    }

    void unitesAndIntersects() {
        const Bounds other{{0, -2, 0}, {3, 0.5, 0.5}};
        QCOMPARE(unite(unit, other).low, glm::dvec3(-1, -2, -1));
        QCOMPARE(unite(unit, other).high, glm::dvec3(3, 1, 1));
        QCOMPARE(intersect(unit, other).low, glm::dvec3(0, -1, 0));
        QCOMPARE(intersect(unit, other).high, glm::dvec3(1, 0.5, 0.5));
        const Bounds empty{{1, 1, 1}, {-1, -1, -1}};
        QCOMPARE(unite(empty, unit).low, unit.low);
        QCOMPARE(unite(unit, empty).high, unit.high);
    }

    void transformHoldsTheTurnedBox() {
        const Bounds turned = transform(unit, Transform::rotation({0, 0, 45}).forward());
        QVERIFY(qFuzzyCompare(turned.high.x, std::sqrt(2.0)));
        QVERIFY(qFuzzyCompare(turned.low.y, -std::sqrt(2.0)));
        QCOMPARE(turned.high.z, 1.0);
        Bounds half;
        half.high.x = 1;
        QCOMPARE(transform(half, Transform::scaling({2, 2, 2}).forward()).high.x, infinity);
    }

    void theImageOfAnEndlessBoxIsBoundedWhereItCanBe() {
        const Bounds half{{-1, -infinity, 2}, {1, 0, 3}};
        const Bounds moved =
            image(half, Transform::scaling({2, -1, 1}).then(Transform::translation({1, 0, 0})).forward());
        QCOMPARE(moved.low, glm::dvec3(-1, 0, 2));
        QCOMPARE(moved.high, glm::dvec3(3, infinity, 3));
        const Bounds turned = image(half, Transform::rotation({0, 0, 30}).forward());
        QCOMPARE(turned.low.x, -std::cos(std::numbers::pi / 6));
        QCOMPARE(turned.high.x, infinity);
        QCOMPARE(turned.low.y, -infinity);
        QCOMPARE(turned.low.z, 2.0);
        // A finite one is as with corners.
        const Bounds box{{-1, 2, -3}, {4, 5, 6}};
        const glm::dmat4 turn = Transform::rotation({20, 30, 40}).forward();
        QVERIFY(glm::distance(image(box, turn).low, transform(box, turn).low) < 1e-12);
        QVERIFY(glm::distance(image(box, turn).high, transform(box, turn).high) < 1e-12);
    }
};

QTEST_APPLESS_MAIN(BoundsTest)
#include "bounds_test.moc"
