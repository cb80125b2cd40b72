// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/view/ray_profile.h"

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
        QVERIFY(profile.povray.roots.empty());
        QCOMPARE(profile.certifiedRoots.empty(), false);
        QVERIFY(std::abs(profile.certifiedRoots.front().t - 4) < 1e-3);
        // The unit of t is that of the world, in which the function is half as steep.
        QVERIFY(std::abs(profile.maxGradient - 0.15) < 1e-12);
        // The interval that held the root was dismissed, at once.
        QCOMPARE(profile.povray.intervals.size(), std::size_t(1));
        QVERIFY(profile.wronglyPruned(profile.povray.intervals.front()));
    }

    void theRightSettingFindsWhatIsThere() {
        const RayProfile profile = sphereProfile("max_gradient 2.4");
        QCOMPARE(profile.povray.roots.size(), std::size_t(1));
        QVERIFY(std::abs(profile.povray.roots.front().t - profile.certifiedRoots.front().t) < 2e-3);
        QVERIFY(profile.povray.visited.size() >= 3);
        for (const ProfilePoint& point : profile.povray.visited) {
            const double z = (point.t - 6) / 2;
            QVERIFY(point.t >= profile.near - 1e-9 && point.t <= profile.far + 1e-9);
            QVERIFY(std::abs(point.value - (z * z - 1)) < 1e-9);
        }
    }

    void whatIsPrunedRightlyIsNotCalledWrong() {
        const RayProfile profile = sphereProfile("max_gradient 2.4");
        std::size_t pruned = 0;
        for (const SearchedInterval& interval : profile.povray.intervals) {
            pruned += interval.fate == IntervalFate::pruned;
            QVERIFY(!profile.wronglyPruned(interval));
        }
        QVERIFY(pruned >= 2);
        QCOMPARE(profile.povray.intervals.back().fate, IntervalFate::hit);
        // All roots are known, though the picture needs only the first.
        QCOMPARE(profile.certifiedRoots.size(), std::size_t(2));
    }

    void theEnclosuresHoldTheCurve() {
        const RayProfile profile = sphereProfile("max_gradient 2.4");
        QVERIFY(profile.enclosures.size() > 2);
        QCOMPARE(profile.enclosures.front().begin, profile.near);
        QCOMPARE(profile.enclosures.back().end, profile.far);
        for (const ProfilePoint& point : profile.curve)
            for (const RayEnclosure& piece : profile.enclosures) {
                if (point.t < piece.begin || point.t > piece.end) continue;
                const double share = (point.t - piece.begin) / (piece.end - piece.begin);
                QVERIFY(point.value >=
                        piece.lowAtBegin + share * (piece.lowAtEnd - piece.lowAtBegin) - 1e-12);
                QVERIFY(point.value <=
                        piece.highAtBegin + share * (piece.highAtEnd - piece.highAtBegin) + 1e-12);
                if (piece.sign() != 0) QVERIFY(piece.sign() * point.value > 0);
            }
        // No sign is claimed where a root is.
        for (const Root& root : profile.certifiedRoots)
            for (const RayEnclosure& piece : profile.enclosures)
                QVERIFY(piece.sign() == 0 || root.t <= piece.begin || root.t >= piece.end);
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
