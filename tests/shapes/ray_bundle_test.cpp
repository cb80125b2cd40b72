// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/shapes/rays/ray_bundle.h"

#include <cmath>
#include <QTest>
#include <algorithm>
#include <random>

#include "core/scene/camera.h"
#include "core/shapes/rays/line_interval.h"
#include "tests/support/test_setting.h"

using namespace isoscope;

namespace {

const std::uint64_t seed = test::seedSetting(2718);

std::vector<Ray> tileRays(const Camera& camera, double u, double v) {
    std::vector<Ray> rays;
    for (int y = 0; y < 8; ++y)
        for (int x = 0; x < 8; ++x) rays.push_back(camera.ray(u + 0.005 * x, v + 0.005 * y));
    return rays;
}

struct Outcome {
    bool met;      ///< by a ray
    bool mayMeet;  ///< as the bundle says
};

/// attempt(rays, place, any, i) for many random tiles of rays; every other place stands near the rays, and
/// any() is a random number from -3 to 3.
template <class Attempt>
void tryTiles(Attempt attempt) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> distribution(-3, 3);
    const auto any = [&] { return distribution(random); };
    const auto vector = [&] { return glm::dvec3(any(), any(), any()); };
    int met = 0, passedOver = 0;
    for (int i = 0; i < 20000; ++i) {
        Camera camera;
        camera.location = vector();
        camera.kind = i % 2 ? CameraKind::perspective : CameraKind::orthographic;
        camera = camera.lookingAt(vector());
        const std::vector<Ray> rays = tileRays(camera, any() / 6, any() / 6);
        const glm::dvec3 place = i % 4 < 2 ? vector() : rays[random() % 64].at(3 + any()) + 0.2 * vector();
        const Outcome outcome = attempt(rays, place, any, i);
        QVERIFY2(outcome.mayMeet || !outcome.met, qPrintable(QString("seed %1, case %2").arg(seed).arg(i)));
        met += outcome.met;
        passedOver += !outcome.mayMeet;
    }
    QVERIFY(met > 500);
    QVERIFY(passedOver > 10000);
}

}  // namespace

class RayBundleTest : public QObject {
    Q_OBJECT

  private slots:
    void neverPassesOverABoxThatARayMeets() {
        tryTiles([](const std::vector<Ray>& rays, const glm::dvec3& place, auto& any, int i) {
            Bounds box{place, place + glm::dvec3(0.1 * any() + 0.3, 0.1 * any() + 0.3, 0.1 * any() + 0.3)};
            if (i % 7 == 0) box.high.y = INFINITY;
            const auto isMet = [&](const Ray& ray) { return !box.clip(ray).empty(); };
            return Outcome{std::any_of(rays.begin(), rays.end(), isMet), RayBundle(rays).mayMeet(box)};
        });
    }

    void neverPassesOverABallThatARayMeets() {
        tryTiles([](const std::vector<Ray>& rays, const glm::dvec3& center, auto& any, int) {
            const double radius = 0.1 * (any() + 3);
            const auto isMet = [&](const Ray& ray) {
                const RayInterval range = sphereRange(ray, center, radius);
                return !range.empty() && range.far >= 0;
            };
            return Outcome{std::any_of(rays.begin(), rays.end(), isMet),
                           RayBundle(rays).mayMeetBall(center, radius)};
        });
    }

    void followsATransform() {
        const Transform transform = Transform::scaling({1, 2, 3})
                                        .then(Transform::rotation({20, 40, 60}))
                                        .then(Transform::translation({0, 0, 9}));
        const std::vector<Ray> rays = tileRays(Camera(), 0, 0);
        const RayBundle bundle = RayBundle(rays).toObject(transform);
        // The object's origin is 9 in front of the camera, a little beside the first ray.
        QVERIFY(bundle.mayMeetBall(glm::dvec3(0), 0.1));
        QVERIFY(bundle.mayMeet({glm::dvec3(-0.1), glm::dvec3(0.1)}));
        const glm::dvec3 behind = transform.inverse().point({0, 0, -5});
        QVERIFY(!bundle.mayMeetBall(behind, 0.1));
        QVERIFY(!bundle.mayMeet({behind - 0.1, behind + 0.1}));
    }

    void passesOverWhatLiesBehindOrBeside() {
        const Camera camera;  // at the origin, looking along z
        const RayBundle bundle(tileRays(camera, 0, 0));
        QVERIFY(bundle.mayMeet({glm::dvec3(-1, -1, 4), glm::dvec3(1, 1, 5)}));
        QVERIFY(!bundle.mayMeet({glm::dvec3(-1, -1, -5), glm::dvec3(1, 1, -4)}));
        QVERIFY(!bundle.mayMeet({glm::dvec3(-3, -1, 4), glm::dvec3(-1, 1, 5)}));
        QVERIFY(bundle.mayMeet({glm::dvec3(-INFINITY), glm::dvec3(INFINITY)}));
    }

    void nonsenseIsNeverPassedOver() {
        std::vector<Ray> rays = tileRays(Camera(), 0, 0);
        rays[5].direction.x = std::nan("");
        QVERIFY(RayBundle(rays).mayMeet({glm::dvec3(-1, -1, -5), glm::dvec3(1, 1, -4)}));
        QVERIFY(RayBundle(rays).mayMeetBall({0, 0, -5}, 1));
        const RayBundle infinite({glm::dvec3(0), glm::dvec3(0)}, Bounds());
        QVERIFY(infinite.mayMeet({glm::dvec3(-1, -1, -5), glm::dvec3(1, 1, -4)}));
    }
};

QTEST_APPLESS_MAIN(RayBundleTest)
#include "ray_bundle_test.moc"
