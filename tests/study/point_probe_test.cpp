// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/view/point_probe.h"

#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <QTest>

#include "tests/support/study_scene.h"

using namespace isoscope;
using namespace isoscope::test;

namespace {

/// A ball of radius 1 about <0.5, 0, 0>, moved there.
const std::string movedBall =
    "isosurface { function { x*x + y*y + z*z } threshold 1 contained_by { sphere { 0, 1.2 } } max_gradient 3 "
    "translate x*0.5 pigment { rgb 1 } }\n";

bool close(double a, double b) { return std::abs(a - b) < 1e-6; }

}  // namespace

/// The values of functions at single points, and whether these are seen.
class PointProbeTest : public QObject {
    Q_OBJECT

  private slots:
    void aPlaceHasItsValueAndSlope() {
        const PointProbe probe(studyScene(movedBall).scene);
        const auto point = probe.at(0, {0.5, 0.25, -1});
        QVERIFY(point.has_value());
        QCOMPARE(point->value, 0.25 + 0.0625 + 1);
        QCOMPARE(point->slope, 2 * std::sqrt(0.25 + 0.0625 + 1));
        QCOMPARE(point->threshold, 1.0);
        QCOMPARE(point->maxGradient, 3.0);
        QVERIFY(point->inScene == glm::dvec3(1, 0.25, -1));
        QVERIFY(point->contained);
        QVERIFY(!probe.at(0, {0, 1.3, 0})->contained);
        QVERIFY(!probe.at(1, {0, 0, 0}).has_value());
        QVERIFY(!probe.at(0, {std::nan(""), 0, 0}).has_value());
        QVERIFY(!probe.at(0, {0, std::numeric_limits<double>::infinity(), 0}).has_value());
    }

    void undefinedAndInfinitelySteepAreTold() {
        const PointProbe probe(
            studyScene("isosurface { function { sqrt(x) + y } contained_by { box { -1, 1 } } }\n").scene);
        const auto undefined = probe.at(0, {-0.5, 0, 0});
        QVERIFY(undefined && std::isnan(undefined->value) && std::isnan(undefined->slope));
        const auto steep = probe.at(0, {0, 0.5, 0});
        QVERIFY(steep && steep->value == 0.5 && std::isinf(steep->slope));
    }

    void aRayShowsTheSurfaceThatItMeetsFirst() {
        const PointProbe probe(studyScene(movedBall).scene);
        const auto point = probe.seenAlong({{0.5, 0, -4}, {0, 0, 1}});
        QVERIFY(point.has_value());
        QVERIFY(close(point->inScene.z, -1) && close(point->value, 1) && close(point->slope, 2));
        QVERIFY(close(point->place.x, 0));
        QVERIFY(!probe.seenAlong({{0.5, 3, -4}, {0, 0, 1}}).has_value());
    }

    void ofTwoIsosurfacesTheOneThatIsSeenIsProbed() {
        const std::string two =
            movedBall + "isosurface { function { y + 1.1 } contained_by { box { -3, 3 } } }\n";
        const PointProbe probe(studyScene(two).scene);
        // Both containers hold both points.
        const auto ball = probe.seenAlong({{0.5, 0, -4}, {0, 0, 1}});
        QVERIFY(ball && ball->isosurface == 0 && close(ball->value, 1));
        const auto ground = probe.seenAlong({{1.5, 0, -1}, {0, -1, 0}});
        QVERIFY(ground && ground->isosurface == 1 && close(ground->place.y, -1.1) && close(ground->value, 0));
    }

    void whatHasNoFunctionIsNotProbed() {
        const PointProbe probe(studyScene(movedBall + "sphere { <0.5, 0, -3>, 0.2 }\n").scene);
        QVERIFY(!probe.seenAlong({{0.5, 0, -4}, {0, 0, 1}}).has_value());
        QVERIFY(!PointProbe(studyScene("sphere { 0, 1 }\n").scene).at(0, {0, 0, 0}).has_value());
    }

    void aPointBehindAnythingIsHidden() {
        const PointProbe probe(studyScene(movedBall).scene);
        const Ray ray{{0.5, 0, -4}, {0, 0, 1}};
        QVERIFY(!probe.hides(ray, {0.5, 0, -1.1}));
        // On the surface itself it is seen.
        QVERIFY(!probe.hides(ray, {0.5, 0, -1}));
        QVERIFY(probe.hides(ray, {0.5, 0, -0.9}));
        QVERIFY(probe.hides(ray, {0.5, 0, 2}));
        QVERIFY(!probe.hides({{0.5, 3, -4}, {0, 0, 1}}, {0.5, 3, 2}));
    }

    void theNearestPointOfARayIsTheFootOfThePerpendicular() {
        QCOMPARE(nearestOnRay({{1, 1, 1}, {0, 2, 0}}, {5, 5, 5}), 2.0);
        QCOMPARE(nearestOnRay({{1, 1, 1}, {0, 0, 0}}, {5, 5, 5}), 0.0);
    }

    void aStopEndsIt() {
        std::stop_source stop;
        stop.request_stop();
        const PointProbe probe(studyScene(movedBall).scene);
        QVERIFY(!probe.seenAlong({{0.5, 0, -4}, {0, 0, 1}}, stop.get_token()).has_value());
        QVERIFY(!probe.at(0, {0, 0, 0}, stop.get_token()).has_value());
    }
};

QTEST_APPLESS_MAIN(PointProbeTest)
#include "point_probe_test.moc"
