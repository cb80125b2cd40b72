// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/render/camera/camera_rays.h"

#include <QTest>
#include <random>
#include "tests/support/test_setting.h"

using namespace isoscope;

namespace {

const std::uint64_t seed = test::seedSetting(31415);

std::vector<Camera> cameras() {
    Camera orthographic;
    orthographic.kind = CameraKind::orthographic;
    orthographic.location = {1, 2, 3};
    Camera degenerate;
    degenerate.direction = degenerate.right = degenerate.up = glm::dvec3(0);
    Camera endless;
    endless.right.x = INFINITY;
    Camera turned;
    turned.location = {3, -2, 5};
    std::vector<Camera> all{Camera(),
                            orthographic,
                            degenerate,
                            endless,
                            turned.lookingAt({0.1, 0.2, 0.3}),
                            orthographic.lookingAt({0, 0, 9})};
    for (const CameraKind kind :
         {CameraKind::fisheye, CameraKind::ultraWideAngle, CameraKind::omnimax, CameraKind::panoramic,
          CameraKind::spherical, CameraKind::movingUprightCylinder}) {
        turned.kind = kind;
        all.push_back(turned.lookingAt({0.1, 0.2, 0.3}));
    }
    return all;
}

std::vector<SampleBatch::PixelPosition> somePlaces(std::mt19937& random, int count) {
    std::uniform_real_distribution<double> x(300, 340), y(100, 140);
    std::vector<SampleBatch::PixelPosition> places;
    for (int k = 0; k < count; ++k) places.push_back({x(random), y(random)});
    return places;
}

}  // namespace

class CameraRaysTest : public QObject {
    Q_OBJECT

  private slots:
    void raysAreThoseOfTheCamera() {
        std::mt19937 random(seed);
        for (const Camera& camera : cameras()) {
            const CameraRays together(camera, 640, 480);
            for (const int count : {1, 7, 64, 100}) {
                const std::vector<SampleBatch::PixelPosition> places = somePlaces(random, count);
                RayBatch rays;
                rays.assign(std::vector<Ray>(3));
                together.append(places, 20, rays);
                QCOMPARE(rays.size(), places.size() + 3);
                for (std::size_t k = 0; k < places.size(); ++k) {
                    const Ray alone = camera.ray(places[k].x / 640 - 0.5, 0.5 - places[k].y / 480);
                    const Ray ray = rays.ray(k + 3);
                    QVERIFY(ray.direction == alone.direction);
                    QVERIFY(ray.origin == alone.origin);
                    QCOMPARE(ray.sample, static_cast<std::uint32_t>(20 + k));
                }
            }
        }
    }

    void raysThatSeeNothingCanBeDropped() {
        Camera fisheye;
        fisheye.kind = CameraKind::fisheye;
        const std::vector<SampleBatch::PixelPosition> places{{320, 240}, {1, 1}, {320, 230}, {639, 479}};
        const CameraRays together(fisheye, 640, 480);
        RayBatch rays;
        together.append(places, 7, rays);
        QCOMPARE(rays.size(), places.size());
        QVERIFY(rays.ray(1).direction == glm::dvec3(0));
        together.dropBlind(rays);
        QCOMPARE(rays.size(), std::size_t{2});
        QCOMPARE(rays.ray(1).sample, std::uint32_t{9});
    }

    void theBundleHoldsThemAll() {
        std::mt19937 random(seed);
        std::uniform_real_distribution<double> distance(0, 9), size(-0.01, 0.01);
        int passedOver = 0;
        for (const Camera& camera : cameras()) {
            const CameraRays together(camera, 640, 480);
            for (int round = 0; round < 500; ++round) {
                const std::vector<SampleBatch::PixelPosition> places = somePlaces(random, 64);
                RayBatch rays;
                together.append(places, 0, rays);
                const RayBundle bundle = together.bundle(places);
                const glm::dvec3 point = rays.ray(static_cast<std::size_t>(round) % 64).at(distance(random));
                QVERIFY2(bundle.mayMeet({point, point}), qPrintable(QString("seed %1").arg(seed)));
                QVERIFY(bundle.mayMeetBall(point, 0));
                passedOver += !bundle.mayMeetBall(point + glm::dvec3(size(random), 5, 0), 0.1);
            }
        }
        QVERIFY(passedOver > 1000);
    }
};

QTEST_APPLESS_MAIN(CameraRaysTest)
#include "camera_rays_test.moc"
