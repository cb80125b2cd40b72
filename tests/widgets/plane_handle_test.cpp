// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/viewport/plane_handle.h"

#include <cmath>
#include <glm/geometric.hpp>
#include <QImage>
#include <QLineF>
#include <QPainter>
#include <QSignalSpy>
#include <QTest>

using namespace isoscope;

namespace {

const Container cube = ContainerBox{glm::dvec3(-1), glm::dvec3(1)};

/// Looks along z from the front and a little from the side.
ViewProjection fromFront(double side = 0) {
    Camera camera;
    camera.location = {side, 0, -5};
    return {camera.lookingAt({0, 0, 0}), QSizeF(400, 300)};
}

QPointF only(const std::optional<QPointF>& pixel) { return pixel.value_or(QPointF(-1, -1)); }

}  // namespace

class PlaneHandleTest : public QObject {
    Q_OBJECT

  private slots:
    void projectionAndRaysBelongTogether() {
        for (const CameraKind kind : {CameraKind::perspective, CameraKind::orthographic}) {
            Camera camera;
            camera.kind = kind;
            camera.location = {1, 2, -5};
            camera = camera.lookingAt({0.3, 0, 0});
            const ViewProjection view(camera, QSizeF(400, 300));
            for (const QPointF pixel : {QPointF(10, 20), QPointF(200, 150), QPointF(390, 290)}) {
                const Ray ray = view.rayAt(pixel);
                const auto back = view.pixelOf(ray.origin + 3.0 * ray.direction);
                QVERIFY(back && QLineF(*back, pixel).length() < 1e-9);
            }
            if (kind == CameraKind::perspective) {
                QVERIFY(!view.pixelOf({1, 2, -6}));
            }
        }
    }

    void theKnobInTheMiddleMovesThePlane() {
        PlaneHandle handle;
        const ViewProjection view = fromFront();
        handle.setPlane(SectionPlane::across(0, 0.25), cube, Transform());
        QCOMPARE(handle.gripAt({200, 150}, view), PlaneHandle::Grip::none);  // not shown yet
        handle.setShown(true);
        const QPointF knob = only(handle.movePixel(view));
        QCOMPARE(handle.gripAt(knob, view), PlaneHandle::Grip::move);
        QSignalSpy moved(&handle, &PlaneHandle::moved), turned(&handle, &PlaneHandle::turned);
        handle.press(knob, view);
        const QPointF wanted = *view.pixelOf({0.5, 0, 0});
        handle.drag(wanted, view);
        QCOMPARE(moved.count(), 1);
        QVERIFY2(std::abs(moved[0][0].toDouble() - 0.5) < 0.02, qPrintable(moved[0][0].toString()));
        // Not out of the container.
        handle.drag(wanted + QPointF(1000, 0), view);
        QCOMPARE(moved[1][0].toDouble(), 1.0);
        QCOMPARE(turned.count(), 0);
        handle.release();
        handle.drag(wanted, view);
        QCOMPARE(moved.count(), 2);
    }

    void aPlaneThatFacesTheCameraMovesToo() {
        PlaneHandle handle;
        handle.setShown(true);
        const ViewProjection view = fromFront();
        handle.setPlane(SectionPlane::across(2, 0), cube, Transform());
        const QPointF knob = only(handle.movePixel(view));
        QSignalSpy moved(&handle, &PlaneHandle::moved);
        handle.press(knob, view);
        handle.drag(knob + QPointF(0, 20), view);
        QCOMPARE(moved.count(), 1);
        QVERIFY(std::abs(moved[0][0].toDouble()) > 0.05 && std::abs(moved[0][0].toDouble()) <= 1);
    }

    void theBallTurnsThePlane() {
        PlaneHandle handle;
        handle.setShown(true);
        const ViewProjection view = fromFront();
        handle.setPlane(SectionPlane::turned({0, 0, 0}, 90, 0, 0), cube, Transform());
        const QPointF ball = only(handle.turnPixel(view));
        QCOMPARE(handle.gripAt(ball, view), PlaneHandle::Grip::turn);
        QSignalSpy turned(&handle, &PlaneHandle::turned);
        handle.press(ball, view);
        const QPointF middle = only(handle.movePixel(view));
        handle.drag(middle - QPointF(0, 500), view);  // far above: straight up
        QCOMPARE(turned.count(), 1);
        QVERIFY(turned[0][1].toDouble() > 0.9);
        handle.drag(ball, view);
        const glm::dvec3 n(turned[1][0].toDouble(), turned[1][1].toDouble(), turned[1][2].toDouble());
        QVERIFY(std::abs(glm::length(n) - 1) < 1e-9);
        QVERIFY2(n.x > 0.98, qPrintable(QString::number(n.x)));
    }

    void transformationsOfTheObjectAreFollowed() {
        PlaneHandle handle;
        handle.setShown(true);
        const ViewProjection view = fromFront();
        const Transform place = Transform::scaling({0.5, 0.5, 0.5}).then(Transform::translation({0, 0.5, 0}));
        handle.setPlane(SectionPlane::across(0, 0), cube, place);
        QVERIFY(QLineF(only(handle.movePixel(view)), *view.pixelOf({0, 0.5, 0})).length() < 1e-9);
        QSignalSpy moved(&handle, &PlaneHandle::moved);
        handle.press(only(handle.movePixel(view)), view);
        handle.drag(*view.pixelOf({0.25, 0.5, 0}), view);
        QVERIFY2(std::abs(moved[0][0].toDouble() - 0.5) < 0.02, qPrintable(moved[0][0].toString()));
    }

    void itIsPaintedOnlyWhileShown() {
        PlaneHandle handle;
        const ViewProjection view = fromFront(1);
        handle.setPlane(SectionPlane::across(0, 0), cube, Transform());
        const auto painted = [&] {
            QImage image(400, 300, QImage::Format_RGB32);
            image.fill(Qt::black);
            QPainter painter(&image);
            handle.paint(painter, view);
            painter.end();
            const QPointF knob = view.pixelOf({0, 0, 0}).value_or(QPointF());
            return image.pixelColor(knob.toPoint());
        };
        QCOMPARE(painted(), QColor(Qt::black));
        handle.setShown(true);
        QCOMPARE(painted(), QColor(0xff, 0xe0, 0x60));
        handle.clear();
        QCOMPARE(painted(), QColor(Qt::black));
        QVERIFY(!handle.movePixel(view));
    }
};

QTEST_MAIN(PlaneHandleTest)
#include "plane_handle_test.moc"
