// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/render/light/light_grid.h"

#include <QTest>
#include <glm/geometric.hpp>

using namespace isoscope;

namespace {

LightSource areaAt(const glm::dvec3& location, int columns, int rows) {
    LightSource light;
    light.location = location;
    light.area = LightArea{{4, 0, 0}, {0, 0, 4}, columns, rows};
    return light;
}

bool near(const glm::dvec3& a, const glm::dvec3& b, double tolerance = 1e-12) {
    return glm::distance(a, b) <= tolerance;
}

}  // namespace

/// The places are those that POV-Ray's lights showed through a pinhole.
class LightGridTest : public QObject {
    Q_OBJECT

  private slots:
    void lightsStandOnAGridAroundTheLocation() {
        const LightSource light = areaAt({1, 10, 0}, 5, 3);
        const LightGrid grid(light, glm::dvec3(0));
        QVERIFY(near(grid.place(0, 0), {-1, 10, -2}));
        QVERIFY(near(grid.place(4, 2), {3, 10, 2}));
        QVERIFY(near(grid.place(2, 1), {1, 10, 0}));
        QVERIFY(near(grid.place(1, 0), {0, 10, -2}));
    }

    void oneLightIsInTheMiddle() {
        const LightSource light = areaAt({1, 10, 0}, 1, 5);
        QVERIFY(near(LightGrid(light, glm::dvec3(0)).place(0, 0), {1, 10, -2}));
    }

    void circularGridsAreDiscs() {
        LightSource light = areaAt({0, 10, 0}, 5, 5);
        light.area->circular = true;
        const LightGrid grid(light, glm::dvec3(0));
        QVERIFY(near(grid.place(4, 2), {2, 10, 0}));
        QVERIFY(near(grid.place(4, 3), {1.79, 10, 0.89}, 0.01));
        QVERIFY(near(grid.place(4, 4), {1.414, 10, 1.414}, 0.01));
        QVERIFY(near(grid.place(2, 2), {0, 10, 0}));
    }

    void orientedGridsFaceThePoint() {
        LightSource light = areaAt({0, 10, 0}, 3, 3);
        light.area->edge = {2, 0, 0};
        light.area->otherEdge = {0, 2, 0};
        light.area->orient = true;
        const glm::dvec3 point(5, 0, 3);
        const LightGrid grid(light, point);
        for (int column = 0; column < 3; ++column)
            for (int row = 0; row < 3; ++row) {
                const glm::dvec3 offset = grid.place(column, row) - light.location;
                QVERIFY(std::abs(glm::dot(offset, point - light.location)) < 1e-9);
                QVERIFY(glm::length(offset) < 1 + 1e-9);
            }
        const glm::dvec3 end = grid.place(2, 1) - light.location;
        QVERIFY(near(end, {0.894, 0.447, 0}, 0.03) || near(end, {-0.894, -0.447, 0}, 0.03));
    }

    void jitterStaysInItsStepAndDependsOnThePointAlone() {
        LightSource light = areaAt({0, 10, 0}, 5, 5);
        light.area->jitter = true;
        const glm::dvec3 point(0.1, 0.2, 0.3);
        const LightGrid grid(light, point), again(light, point), other(light, {0.1, 0.2, 0.4});
        for (int column = 0; column < 5; ++column) {
            const glm::dvec3 place = grid.place(column, 2);
            QVERIFY(std::abs(place.x - (column - 2)) <= 0.5);
            QVERIFY(std::abs(place.z) <= 0.5);
            QVERIFY(place == again.place(column, 2));
            QVERIFY(place != other.place(column, 2));
        }
    }
};

QTEST_APPLESS_MAIN(LightGridTest)
#include "light_grid_test.moc"
