// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/section/section_plane.h"

#include <cmath>
#include <glm/geometric.hpp>
#include <QTest>
#include <random>

using namespace isoscope;

namespace {

constexpr unsigned seed = 31;
const Container box = ContainerBox{{-1, -2, -3}, {2, 3, 4}};
const Container ball = ContainerSphere{{1, 2, 3}, 2};

bool close(const glm::dvec3& a, const glm::dvec3& b) { return glm::distance(a, b) < 1e-12; }

}  // namespace

class SectionPlaneTest : public QObject {
    Q_OBJECT

  private slots:
    void initTestCase() { qInfo("seed %u", seed); }

    void acrossAnAxisItHasTheCoordinatesOfTheFunction() {
        QVERIFY(close(SectionPlane::across(0, 0.5).at(3, 2), {0.5, 2, 3}));
        QVERIFY(close(SectionPlane::across(1, 0.5).at(3, 2), {3, 0.5, 2}));
        QVERIFY(close(SectionPlane::across(2, 0.5).at(3, 2), {3, 2, 0.5}));
        QCOMPARE(SectionPlane::across(7, 0).axis(), 2);
    }

    void aFreePlaneHasARightAngledFrameOfUnitVectors() {
        std::mt19937 random(seed);
        std::uniform_real_distribution<double> number(-1, 1);
        for (int i = 0; i < 200; ++i) {
            const double heading = 180 * number(random), tilt = 90 * number(random), away = number(random);
            const glm::dvec3 center(number(random), number(random), number(random));
            const SectionPlane p = SectionPlane::turned(center, heading, tilt, away);
            QVERIFY(p.isFree());
            for (const glm::dvec3& v : {p.right(), p.up(), p.normal()})
                QVERIFY(std::abs(glm::length(v) - 1) < 1e-12);
            QVERIFY(std::abs(glm::dot(p.right(), p.up())) < 1e-12);
            QVERIFY(close(glm::cross(p.right(), p.up()), p.normal()));
            QVERIFY(close(p.at(0, 0), center + away * p.normal()));
            const PlaneAngles back = anglesOf(3.0 * p.normal(), 0);
            QVERIFY(std::abs(back.heading - heading) < 1e-6 && std::abs(back.tilt - tilt) < 1e-6);
        }
    }

    void straightUpTheHeadingIsKept() {
        QCOMPARE(anglesOf({0, 2, 0}, 33).heading, 33.0);
        QCOMPARE(anglesOf({0, 2, 0}, 33).tilt, 90.0);
        QCOMPARE(anglesOf({0, 0, 0}, 33).heading, 33.0);
    }

    void theRectangleHoldsAllOfTheSection() {
        std::mt19937 random(seed);
        std::uniform_real_distribution<double> number(-1, 1);
        for (int i = 0; i < 300; ++i)
            for (const Container& container : {box, ball}) {
                const Bounds bounds = containerBounds(container);
                SectionPlane plane =
                    SectionPlane::turned(0.5 * (bounds.low + bounds.high), 180 * number(random),
                                         90 * number(random), 2 * number(random));
                const SectionTravel travel = travelOf(plane, container);
                const SectionRectangle r = rectangleOf(plane, container);
                const auto outline = sectionOutline(plane, container);
                QCOMPARE(outline.empty(), plane.position() < travel.low || plane.position() > travel.high);
                for (const glm::dvec2& corner : outline) {
                    QVERIFY(corner.x >= r.left - 1e-9 && corner.x <= r.right + 1e-9);
                    QVERIFY(corner.y >= r.bottom - 1e-9 && corner.y <= r.top + 1e-9);
                    const glm::dvec3 p = plane.at(corner.x, corner.y);
                    const bool onWall = std::holds_alternative<ContainerSphere>(container)
                                            ? std::abs(glm::distance(p, {1, 2, 3}) - 2) < 1e-9
                                            : bounds.low.x - p.x < 1e-9 && bounds.low.y - p.y < 1e-9 &&
                                                  bounds.low.z - p.z < 1e-9 && p.x - bounds.high.x < 1e-9 &&
                                                  p.y - bounds.high.y < 1e-9 && p.z - bounds.high.z < 1e-9;
                    QVERIFY(onWall);
                }
            }
    }

    void aDiagonalPlaneCutsAHexagonOutOfACube() {
        const Container cube = ContainerBox{glm::dvec3(-1), glm::dvec3(1)};
        const PlaneAngles angles = anglesOf({1, 1, 1}, 0);
        const auto outline =
            sectionOutline(SectionPlane::turned({0, 0, 0}, angles.heading, angles.tilt, 0), cube);
        QCOMPARE(outline.size(), std::size_t(6));
        for (const glm::dvec2& corner : outline)
            QVERIFY(std::abs(glm::length(corner) - std::sqrt(2.0)) < 1e-9);
    }

    void onAWallTheWholeWallIsCut() {
        QCOMPARE(sectionOutline(SectionPlane::across(2, 4), box).size(), std::size_t(4));
        QCOMPARE(sectionOutline(SectionPlane::across(0, -1), box).size(), std::size_t(4));
        QVERIFY(sectionOutline(SectionPlane::across(2, 4.1), box).empty());
    }

    void theMiddleIsTheFootOfTheContainersMiddle() {
        QVERIFY(close(SectionPlane::across(2, 1).middle(box), {0.5, 0.5, 1}));
        QVERIFY(close(SectionPlane::turned({0.5, 0.5, 0.5}, 90, 0, 0.25).middle(box), {0.75, 0.5, 0.5}));
    }
};

QTEST_APPLESS_MAIN(SectionPlaneTest)
#include "section_plane_test.moc"
