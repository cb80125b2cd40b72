// SPDX-License-Identifier: GPL-3.0-or-later
#include <QTest>
#include <cmath>
#include <glm/geometric.hpp>
#include <sstream>

#include "core/scene/camera_statement.h"
#include "tests/support/csv_table.h"

using namespace isoscope;
using isoscope::test::dataFile;

namespace {

std::optional<glm::dvec3> vectorField(const test::CsvTable& table, std::size_t row,
                                      const std::string& column) {
    const std::string& text = table.field(row, column);
    if (text.empty()) return std::nullopt;
    std::istringstream in(text);
    glm::dvec3 v(0);
    in >> v.x >> v.y >> v.z;
    return v;
}

CameraStatement statement(const test::CsvTable& table, std::size_t row) {
    CameraStatement camera;
    camera.location = vectorField(table, row, "location");
    camera.direction = vectorField(table, row, "direction");
    camera.right = vectorField(table, row, "right");
    camera.up = vectorField(table, row, "up");
    camera.sky = vectorField(table, row, "sky");
    camera.lookAt = vectorField(table, row, "look_at");
    if (!table.field(row, "angle").empty()) camera.angle = table.number(row, "angle");
    if (const auto turn = vectorField(table, row, "rotate")) camera.transform = Transform::rotation(*turn);
    return camera;
}

/// Where the ray through (u, v) meets the plane z = 5.
glm::dvec3 onPlane(const Camera& camera, double u, double v) {
    const Ray ray = camera.ray(u, v);
    return ray.at((5 - ray.origin.z) / ray.direction.z);
}

struct OrthographicCase {
    const char* name;
    CameraStatement camera;
    glm::dvec2 leftTop, rightTop;  ///< centres of the corner pixels of a 4 x 3 picture, on the plane z = 5
};

CameraStatement orthographic(const glm::dvec3& location) {
    CameraStatement camera;
    camera.kind = CameraKind::orthographic;
    camera.location = location;
    return camera;
}

/// Measured with POV-Ray 3.7.0.10: the colour of a plane told where each ray had met it.
std::vector<OrthographicCase> orthographicCases() {
    std::vector<OrthographicCase> cases;
    const auto add = [&](const char* name, CameraStatement camera, glm::dvec2 left, glm::dvec2 right) {
        cases.push_back({name, camera, left, right});
    };
    CameraStatement c = orthographic({0, 0, -5});
    add("alone", c, {-2.993, 2.0}, {2.993, 2.0});
    c.lookAt = glm::dvec3(0);
    add("look_at", c, {-2.494, 1.667}, {2.494, 1.667});
    c.direction = glm::dvec3(0, 0, 2);
    add("direction", c, {-1.247, 0.834}, {1.247, 0.834});
    c = orthographic({0, 0, -5});
    c.lookAt = glm::dvec3(0);
    c.right = glm::dvec3(2, 0, 0);
    add("right only", c, {-0.75, 0.333}, {0.75, 0.333});
    c.right.reset();
    c.up = glm::dvec3(0, 2, 0);
    add("up only", c, {-0.498, 0.666}, {0.498, 0.666});
    c = orthographic({0, 0, -5});
    c.angle = 40;
    c.lookAt = glm::dvec3(0, 0, -1);
    add("angle", c, {-1.092, 0.73}, {1.092, 0.73});
    c.right = glm::dvec3(2, 0, 0);
    c.up = glm::dvec3(0, 2, 0);
    c.direction = glm::dvec3(0, 0, 3);
    add("angle and sizes", c, {-1.092, 0.971}, {1.092, 0.971});
    c.lookAt.reset();
    add("angle without look_at", c, {-1.638, 1.456}, {1.638, 1.456});
    c = orthographic({-3, 2, -6});
    c.lookAt = glm::dvec3(1, 0, 1);
    c.transform = Transform::rotation({0, 10, 0});
    add("turned", c, {-0.747, 2.355}, {10.031, 0.646});
    return cases;
}

struct CurvedCase {
    CameraKind kind;
    double angle;
    double u, v;
    glm::dvec3 direction;
};

/// Measured with POV-Ray 3.7.0.10: the colour of the sky told the direction. `right 4/3*x`.
const std::vector<CurvedCase> curvedCases{
    {CameraKind::fisheye, 120, -0.1875, 5.0 / 12, {-0.438, 0.730, 0.525}},
    {CameraKind::fisheye, 90, -0.1875, 5.0 / 12, {-0.356, 0.593, 0.723}},
    {CameraKind::ultraWideAngle, 120, -0.4375, 5.0 / 12, {-0.714, 0.548, 0.435}},
    {CameraKind::omnimax, 90, -0.1875, 5.0 / 12, {-0.406, 0.908, 0.105}},
    {CameraKind::omnimax, 90, 0.4375, -1.0 / 12, {0.977, 0.098, 0.189}},
    {CameraKind::panoramic, 90, -0.4375, 5.0 / 12, {-0.330, 0.943, 0.049}},
    {CameraKind::uprightCylinder, 120, -0.4375, 5.0 / 12, {-0.732, 0.385, 0.562}},
    {CameraKind::lyingCylinder, 120, -0.4375, 5.0 / 12, {-0.504, 0.662, 0.555}},
    {CameraKind::movingUprightCylinder, 120, -0.4375, 5.0 / 12, {-0.793, 0, 0.609}},
    {CameraKind::movingLyingCylinder, 120, -0.4375, 5.0 / 12, {0, 0.766, 0.643}},
};

}  // namespace

class CameraTest : public QObject {
    Q_OBJECT

  private slots:
    void raysAgreeWithPovray() {
        const test::CsvTable table(dataFile("scene/camera_rays.csv"));
        QVERIFY(table.rowCount() > 60);
        for (std::size_t row = 0; row < table.rowCount(); ++row) {
            const Ray ray =
                statement(table, row).camera().ray(table.number(row, "u"), table.number(row, "v"));
            const glm::dvec3 wanted(table.number(row, "dx"), table.number(row, "dy"),
                                    table.number(row, "dz"));
            // POV-Ray answered in 16-bit colours of the range [-1, 1].
            QVERIFY2(glm::length(ray.direction - wanted) < 6e-5, table.field(row, "text").c_str());
        }
    }

    void orthographicSizesAgreeWithPovray() {
        for (const OrthographicCase& item : orthographicCases()) {
            const Camera camera = item.camera.camera();
            const glm::dvec2 left(onPlane(camera, -0.375, 1.0 / 3));
            const glm::dvec2 right(onPlane(camera, 0.375, 1.0 / 3));
            QVERIFY2(glm::distance(left, item.leftTop) < 0.003, item.name);
            QVERIFY2(glm::distance(right, item.rightTop) < 0.003, item.name);
        }
    }

    void curvedPicturesAgreeWithPovray() {
        for (const CurvedCase& item : curvedCases) {
            CameraStatement statement;
            statement.kind = item.kind;
            statement.angle = item.angle;
            statement.right = glm::dvec3(4.0 / 3, 0, 0);
            const Ray ray = statement.camera().ray(item.u, item.v);
            QVERIFY2(glm::distance(ray.direction, item.direction) < 1e-3,
                     qPrintable(QString("kind %1").arg(static_cast<int>(item.kind))));
        }
    }

    void viewpointsOfMovingCylindersMove() {
        Camera camera;
        camera.kind = CameraKind::movingUprightCylinder;
        QVERIFY(camera.ray(0.3, 0.25).origin == glm::dvec3(0, 0.25, 0));
        camera.kind = CameraKind::movingLyingCylinder;
        QVERIFY(camera.ray(0.25, 0.3).origin == glm::dvec3(0.3325, 0, 0));
    }

    void sphericalAnglesHaveDefaults() {
        CameraStatement statement;
        statement.kind = CameraKind::spherical;
        QCOMPARE(statement.camera().angle, 360.0);
        QCOMPARE(statement.camera().verticalAngle, 180.0);
        statement.angle = 200;
        QCOMPARE(statement.camera().verticalAngle, 100.0);
        statement.verticalAngle = 30;
        QCOMPARE(statement.camera().verticalAngle, 30.0);
    }

    void roundPicturesEnd() {
        Camera camera;
        for (const CameraKind kind : {CameraKind::fisheye, CameraKind::omnimax}) {
            camera.kind = kind;
            QVERIFY(camera.ray(0.49, 0.49).direction == glm::dvec3(0));
            QVERIFY(std::abs(glm::length(camera.ray(0.1, 0.1).direction) - 1) < 1e-15);
            camera.right = camera.up = camera.direction = glm::dvec3(0);
            QVERIFY(!std::isnan(camera.ray(0.1, 0.2).direction.x));
            camera = Camera();
        }
    }

    void angleSetsTheWidth() {
        const Camera camera = Camera().withAngle(90);
        const glm::dvec3 edge = camera.ray(0.5, 0).direction;
        QVERIFY(std::abs(edge.x - edge.z) < 1e-15);
    }

    void anglesOutOfRangeChangeNothing() {
        for (double degrees : {0.0, -5.0, 180.0, 360.0, std::nan(""), HUGE_VAL})
            QVERIFY(Camera().withAngle(degrees) == Camera());
    }

    /// objects/prism3a.pov among the scenes that come with POV-Ray.
    void axesInOnePlaneAreMirrored() {
        Camera camera;
        camera.location = {0, 3.3, 0};
        camera.up = camera.sky = {0, 0, 1};
        QVERIFY(glm::distance(camera.lookingAt({0, 0, 0}).right, glm::dvec3(-1.33, 0, 0)) < 1e-12);
    }

    void lookingAtItsOwnPlaceChangesNothing() {
        QVERIFY(Camera().lookingAt({0, 0, 0}) == Camera());
        QVERIFY(Camera().lookingAt({std::nan(""), 0, 0}) == Camera());
    }

    void degenerateCamerasGiveNoNan() {
        Camera camera;
        camera.direction = camera.right = camera.up = glm::dvec3(0);
        QCOMPARE(glm::length(camera.ray(0.3, 0.2).direction), 0.0);
        QVERIFY(!std::isnan(camera.lookingAt({1, 2, 3}).direction.x));
        camera.kind = CameraKind::orthographic;
        QVERIFY(!std::isnan(camera.withAngle(40).right.x));
    }
};

QTEST_APPLESS_MAIN(CameraTest)
#include "camera_test.moc"
