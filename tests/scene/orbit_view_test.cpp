// SPDX-License-Identifier: GPL-3.0-or-later
#include <QTest>
#include <cmath>
#include <glm/geometric.hpp>

#include "core/scene/orbit_view.h"

using namespace isoscope;

namespace {

Camera cameraAt(const glm::dvec3& location) {
    Camera camera;
    camera.location = location;
    return camera.lookingAt({0, 0, 0});
}

/// Where a point appears: x in picture widths to the right, y in heights up.
glm::dvec2 onScreen(const Camera& camera, const glm::dvec3& point) {
    const glm::dvec3 p = point - camera.location;
    const glm::dvec3 view = glm::normalize(camera.direction);
    const double scale =
        camera.kind == CameraKind::orthographic ? 1 : glm::length(camera.direction) / glm::dot(p, view);
    return {scale * glm::dot(p, camera.right) / glm::dot(camera.right, camera.right),
            scale * glm::dot(p, camera.up) / glm::dot(camera.up, camera.up)};
}

/// The point of the unit sphere around the origin that faces the camera.
glm::dvec3 front(const Camera& camera) { return glm::normalize(camera.location); }

}  // namespace

class OrbitViewTest : public QObject {
    Q_OBJECT

  private slots:
    void whatIsInFrontFollowsTheMouse() {
        for (bool mirror : {false, true}) {
            Camera camera = cameraAt({3, 2, -6});
            if (mirror) camera.right = -camera.right;
            const glm::dvec3 point = front(camera);
            OrbitView view(camera);
            view.orbit(10, 0);
            QVERIFY(onScreen(view.camera(), point).x > 0.01);
            view.reset();
            view.orbit(0, 10);
            QVERIFY(onScreen(view.camera(), point).y > 0.01);
            QVERIFY(std::abs(onScreen(view.camera(), point).x) < 1e-12);
        }
    }

    void turningKeepsDistancePivotAndAxes() {
        OrbitView view(cameraAt({3, 2, -6}));
        const double distance = glm::length(view.camera().location);
        for (int i = 0; i < 500; ++i) view.orbit(7.3, (i % 60 < 30) ? 4 : -4);
        const Camera& camera = view.camera();
        QVERIFY(std::abs(glm::length(camera.location) - distance) < 1e-9);
        QVERIFY(glm::length(onScreen(camera, {0, 0, 0})) < 1e-9);
        QVERIFY(std::abs(glm::dot(camera.right, camera.up)) < 1e-9);
        QVERIFY(std::abs(glm::length(camera.right) - 1.33) < 1e-9);
        QVERIFY(std::abs(camera.right.y) < 1e-9);  // the horizon stays level
    }

    void neverTipsOver() {
        OrbitView view(cameraAt({0, 0, -6}));
        for (int i = 0; i < 100; ++i) view.orbit(0, -5);
        QVERIFY(view.camera().up.y > 0);
        QVERIFY(view.camera().location.y > 5.99);
        for (int i = 0; i < 100; ++i) view.orbit(0, 5);
        QVERIFY(view.camera().up.y > 0);
        QVERIFY(view.camera().location.y < -5.99);
    }

    void canLeaveTheViewStraightDown() {
        OrbitView view(cameraAt({0, 5, 0}));
        const glm::dvec3 up = view.camera().up;
        view.orbit(0, 20);
        QVERIFY(std::abs(view.camera().location.y - 5 * std::cos(20 * M_PI / 180)) < 1e-9);
        QVERIFY(glm::dot(view.camera().up, up) > 0);
    }

    void panShiftsByPartsOfThePicture() {
        for (CameraKind kind : {CameraKind::perspective, CameraKind::orthographic}) {
            Camera camera = cameraAt({3, 2, -6});
            camera.kind = kind;
            OrbitView view(camera);
            view.pan(0.25, -0.125);
            const glm::dvec2 origin = onScreen(view.camera(), {0, 0, 0});
            QVERIFY(std::abs(origin.x - 0.25) < 1e-12);
            QVERIFY(std::abs(origin.y + 0.125) < 1e-12);
            QVERIFY(view.moved());
        }
    }

    void zoomMagnifiesThePlaneOfThePivot() {
        for (CameraKind kind : {CameraKind::perspective, CameraKind::orthographic}) {
            Camera camera = cameraAt({0, 0, -6});
            camera.kind = kind;
            OrbitView view(camera);
            view.zoom(2);
            const double before = onScreen(camera, {0.1, 0, 0}).x;
            QVERIFY(std::abs(onScreen(view.camera(), {0.1, 0, 0}).x - 2 * before) < 1e-12);
            for (int i = 0; i < 2000; ++i) view.zoom(2);
            for (int i = 0; i < 3000; ++i) view.zoom(0.5);
            QVERIFY(std::isfinite(view.camera().location.z));
            QVERIFY(view.camera().right.x > 0);
            view.reset();
            QVERIFY(!view.moved());
            QVERIFY(view.camera() == camera);
        }
    }

    void nonsenseChangesNothing() {
        OrbitView view(cameraAt({0, 1, -6}));
        const Camera before = view.camera();
        for (double bad : {std::nan(""), HUGE_VAL, -HUGE_VAL}) {
            view.orbit(bad, 0);
            view.orbit(0, bad);
            view.pan(bad, 0);
            view.zoom(bad);
        }
        view.zoom(0);
        view.zoom(-1);
        QVERIFY(view.camera() == before);
    }

    void turnsAboutAPointAheadWithoutLookAt() {
        Camera camera;  // no look_at: the default one lies behind this camera
        camera.location = {0, 0, 8};
        camera.direction = {0, 0, -1};
        camera.lookAt = {0, 0, 9};
        const OrbitView view(camera);
        QVERIFY(glm::length(view.pivot()) < 1e-12);
    }
};

QTEST_APPLESS_MAIN(OrbitViewTest)
#include "orbit_view_test.moc"
