// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/ray_profile.h"

#include <QTest>

#include "tests/support/study_scene.h"

using namespace isoscope;
using namespace isoscope::test;

namespace {

/// A sphere of radius 1 twice as large, 6 in front of the ray's origin: it lies between t = 4 and 8.
RayProfile sphereProfile(const std::string& settings, const glm::dvec3& origin = {0, 0, -6}) {
    const RenderRequest request =
        studyScene("isosurface { function { x*x+y*y+z*z-1 } contained_by { sphere { 0, 1.2 } } " + settings +
                   " scale 2 }\n");
    return profileOf(*request.scene, 0, {origin, {0, 0, 1}}, 101);
}

}  // namespace

class RayProfileTest : public QObject {
    Q_OBJECT

  private slots:
    void aHoleIsExplained() {
        const RayProfile profile = sphereProfile("max_gradient 0.3");
        QVERIFY(profile.meetsContainer);
        QVERIFY(std::abs(profile.near - 3.6) < 1e-12 && std::abs(profile.far - 8.4) < 1e-12);
        QVERIFY(profile.povrayRoots.empty());
        QCOMPARE(profile.certifiedRoots.empty(), false);
        QVERIFY(std::abs(profile.certifiedRoots.front().t - 4) < 1e-3);
        // The unit of t is that of the world, in which the function is half as steep.
        QVERIFY(std::abs(profile.maxGradient - 0.15) < 1e-12);
    }

    void theRightSettingFindsWhatIsThere() {
        const RayProfile profile = sphereProfile("max_gradient 2.4");
        QCOMPARE(profile.povrayRoots.size(), std::size_t(1));
        QVERIFY(std::abs(profile.povrayRoots.front().t - profile.certifiedRoots.front().t) < 2e-3);
        QVERIFY(profile.visited.size() >= 3);
        for (const ProfilePoint& point : profile.visited) {
            const double z = (point.t - 6) / 2;
            QVERIFY(point.t >= profile.near - 1e-9 && point.t <= profile.far + 1e-9);
            QVERIFY(std::abs(point.value - (z * z - 1)) < 1e-9);
        }
    }

    void theCurveRunsFromWallToWall() {
        const RayProfile profile = sphereProfile("max_gradient 2.4");
        QCOMPARE(profile.curve.size(), std::size_t(101));
        QCOMPARE(profile.curve.front().t, profile.near);
        QCOMPARE(profile.curve.back().t, profile.far);
        QVERIFY(std::abs(profile.curve[50].value + 1) < 1e-9);
        QVERIFY(profile.curve.front().value > 0.4 && profile.curve.back().value > 0.4);
    }

    void aRayThatMissesSaysSo() {
        QVERIFY(!sphereProfile("", {5, 0, -6}).meetsContainer);
        QVERIFY(!sphereProfile("", {0, 0, 9}).meetsContainer);
        QVERIFY(!profileOf(Scene{}, 0, {{0, 0, 0}, {0, 0, 1}}).meetsContainer);
    }
};

QTEST_APPLESS_MAIN(RayProfileTest)
#include "ray_profile_test.moc"
