// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/render/camera/lens_sampling.h"

#include <QTest>
#include <cmath>
#include <glm/geometric.hpp>

#include "core/scene/camera_lens.h"

using namespace isoscope;

namespace {

FocalBlur blurOf(int samples, double variance = 1.0 / 128) {
    FocalBlur blur;
    blur.aperture = 1;
    blur.samples = samples;
    blur.variance = variance;
    return blur;
}

const std::vector<PixelIndex> twoPixels{{3, 5}, {4, 5}};

}  // namespace

class LensSamplingTest : public QObject {
    Q_OBJECT

  private slots:
    void raysMeetInThePlaneOfFocus() {
        Camera camera;
        camera.location = {1, 2, 3};
        camera.blur = blurOf(10);
        camera.blur.focalPoint = {1, 2, 8};
        const Ray middle = camera.ray(0.2, -0.3);
        const glm::dvec3 meeting = middle.at(5 / middle.direction.z);
        for (const glm::dvec2 place : {glm::dvec2(1, 0), glm::dvec2(-0.6, 0.8), glm::dvec2(0)}) {
            const Ray ray = throughLens(camera, middle, place);
            QVERIFY(glm::distance(ray.origin, camera.location + 0.25 * glm::dvec3(place, 0)) < 1e-12);
            QVERIFY(glm::distance(ray.at(5 / ray.direction.z), meeting) < 1e-12);
            QVERIFY(std::abs(glm::length(ray.direction) - 1) < 1e-12);
        }
    }

    void theFocusIsAsFarAsThePointEvenAside() {
        Camera camera;
        camera.blur = blurOf(10);
        camera.blur.focalPoint = {3, 0, 4};  // 5 away, measured on POV-Ray
        const Ray ray = throughLens(camera, camera.ray(0, 0), {1, 0});
        QVERIFY(glm::distance(ray.at(5 / ray.direction.z), glm::dvec3(0, 0, 5)) < 1e-12);
    }

    void withoutApertureOrFocusRaysStay() {
        Camera camera;
        const Ray ray = camera.ray(0.1, 0.1);
        QVERIFY(throughLens(camera, ray, {1, 0}).direction == ray.direction);
        camera.blur = blurOf(10);
        camera.blur.focalPoint = camera.location;
        QVERIFY(throughLens(camera, ray, {1, 0}).origin == ray.origin);
    }

    void evenPixelsNeedFewSamples() {
        std::size_t samples = 0;
        const auto grey = [&](auto places, auto lens, std::vector<glm::dvec4>& colors) {
            samples += places.size();
            if (lens.size() != places.size()) return false;
            colors.assign(places.size(), glm::dvec4(0.5, 0.5, 0.5, 0.25));
            return true;
        };
        std::vector<LinearColor> colors(2);
        std::vector<float> background(2);
        QVERIFY(LensSampling(blurOf(100)).draw(twoPixels, grey, colors, background));
        QCOMPARE(samples, std::size_t{16});
        QCOMPARE(colors[1][2], 0.5F);
        QCOMPARE(background[1], 0.25F);
    }

    void unevenPixelsGetAllTheirSamplesEvenlySpread() {
        std::size_t samples = 0;
        glm::dvec2 middle(0);
        const auto half = [&](auto places, auto lens, std::vector<glm::dvec4>& colors) {
            samples += places.size();
            colors.clear();
            for (std::size_t k = 0; k < places.size(); ++k) {
                QVERIFY2(glm::length(lens[k]) <= 1, "outside of the lens");
                QVERIFY2(places[k].y >= 5 && places[k].y < 6, "outside of the pixel");
                middle += lens[k];
                colors.emplace_back(glm::dvec3(places[k].x < 4 ? (lens[k].x < 0 ? 1.0 : 0.0) : 0.25), 0);
            }
        };
        const auto shade = [&](auto places, auto lens, std::vector<glm::dvec4>& colors) {
            half(places, lens, colors);
            return true;
        };
        std::vector<LinearColor> colors(2);
        QVERIFY(LensSampling(blurOf(200)).draw(twoPixels, shade, colors));
        QCOMPARE(samples, std::size_t{208});
        QVERIFY(std::abs(colors[0][0] - 0.5) < 0.02);
        QCOMPARE(colors[1][0], 0.25F);
        QVERIFY(glm::length(middle) / 208 < 0.02);
    }

    void aStopIsPassedOn() {
        std::vector<LinearColor> colors(2);
        const auto stopped = [](auto, auto, std::vector<glm::dvec4>&) { return false; };
        QVERIFY(!LensSampling(blurOf(20)).draw(twoPixels, stopped, colors));
    }
};

QTEST_APPLESS_MAIN(LensSamplingTest)
#include "lens_sampling_test.moc"
