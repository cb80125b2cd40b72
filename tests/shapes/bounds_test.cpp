// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/shapes/bounds.h"

#include <limits>
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
};

QTEST_APPLESS_MAIN(BoundsTest)
#include "bounds_test.moc"
