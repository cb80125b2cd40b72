// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/shapes/transform.h"

#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <QTest>
#include <random>

using namespace isoscope;

namespace {

bool close(const glm::dvec3& a, const glm::dvec3& b, double tolerance = 1e-12) {
    return glm::distance(a, b) <= tolerance;
}

}  // namespace

class TransformTest : public QObject {
    Q_OBJECT

  private slots:
    void axesTurnAsInPovray() {
        QVERIFY(close(Transform::rotation({90, 0, 0}).point({0, 1, 0}), {0, 0, 1}));
        QVERIFY(close(Transform::rotation({0, 90, 0}).point({0, 0, 1}), {1, 0, 0}));
        QVERIFY(close(Transform::rotation({0, 0, 90}).point({1, 0, 0}), {0, 1, 0}));
    }

    void composesInTheOrderOfTheText() {
        // POV-Ray 3.7: function { transform { rotate <10,20,30> scale <2,-1,0.5> translate <1,2,3> } } at
        // that point.
        const Transform map = Transform::rotation({10, 20, 30})
                                  .then(Transform::scaling({2, -1, 0.5}))
                                  .then(Transform::translation({1, 2, 3}));
        QVERIFY(close(map.point({0.3, -0.7, 1.1}), {2.938385137565, 2.457009848004, 3.400564527712}, 2e-12));
    }

    void matrixIsWrittenInRowsOfImages() {
        // matrix <1,0.5,0, 0,1,0.25, 0.3,0,1, -0.5,-0.5,-0.4>: each row is the image of an axis.
        const Transform map =
            Transform::matrix(glm::dmat4(1, 0.5, 0, 0, 0, 1, 0.25, 0, 0.3, 0, 1, 0, -0.5, -0.5, -0.4, 1));
        QVERIFY(close(map.point({0.3, -0.7, 1.1}), {0.13, -1.05, 0.525}));
    }

    void axisRotationAgreesWithTheAxes() {
        for (int axis = 0; axis < 3; ++axis) {
            glm::dvec3 unit(0), degrees(0);
            unit[axis] = 3;
            degrees[axis] = 37;
            const glm::dvec3 p(0.2, -1.3, 0.7);
            QVERIFY(close(Transform::axisRotation(unit, 37).point(p), Transform::rotation(degrees).point(p)));
        }
        QVERIFY(close(Transform::axisRotation({1, 1, 1}, 120).point({1, 0, 0}), {0, 1, 0}));
        QVERIFY(Transform::axisRotation({0, 0, 0}, 50).identity());
    }

    void zeroFactorsCountAsOne() {
        QVERIFY(close(Transform::scaling({0, 2, 0}).point({1, 1, 1}), {1, 2, 1}));
    }

    void singularMatricesAreRefused() {
        const Transform flat = Transform::matrix(glm::dmat4(1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1));
        QVERIFY(flat.singular());
        QVERIFY(flat.identity());
        QVERIFY(Transform::translation({1, 2, 3}).then(flat).singular());
        glm::dmat4 broken(1);
        broken[2][1] = std::numeric_limits<double>::quiet_NaN();
        QVERIFY(Transform::matrix(broken).singular());
    }

    void inverseUndoes() {
        std::mt19937 random(42);
        std::uniform_real_distribution<double> number(-3, 3);
        const auto vector = [&] { return glm::dvec3(number(random), number(random), number(random)); };
        for (int round = 0; round < 100; ++round) {
            const Transform map = Transform::rotation(60.0 * vector())
                                      .then(Transform::scaling(vector()))
                                      .then(Transform::axisRotation(vector(), 50 * number(random)))
                                      .then(Transform::translation(vector()));
            const glm::dvec3 p = vector();
            const double size = 1 + glm::length(map.point(p));
            QVERIFY(close(map.inverse().point(map.point(p)), p, 1e-9 * size));
            QVERIFY(close(glm::dvec3(map.inverse().forward() * map.forward() * glm::dvec4(p, 1)), p,
                          1e-9 * size));
        }
    }

    void normalsStayAcross() {
        const Transform map = Transform::scaling({1, 4, 0.5}).then(Transform::rotation({20, 30, 40}));
        const glm::dvec3 along(1, -1, 2), across(1, 3, 1);
        QCOMPARE(glm::dot(along, across), 0.0);
        QVERIFY(std::abs(glm::dot(map.direction(along), map.normal(across))) < 1e-12);
    }

    void rayParameterKeepsItsMeaning() {
        const Transform map = Transform::scaling({2, 3, 4}).then(Transform::translation({1, 1, 1}));
        const Ray ray{{1, 2, 3}, {0.3, 0.4, 0.5}};
        QVERIFY(close(map.point(map.toObject(ray).at(2.5)), ray.at(2.5)));
    }
};

QTEST_APPLESS_MAIN(TransformTest)
#include "transform_test.moc"
