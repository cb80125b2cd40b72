// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/render/render_image.h"

#include <climits>
#include <cmath>
#include <QTest>

#include "core/render/picture.h"
#include "core/shapes/solids/sphere.h"
#include "tests/support/gated_shape.h"
#include "tests/support/instruction_sets.h"
#include "tests/support/lighting_case.h"
#include "tests/support/scene_picture.h"

using namespace isoscope;

namespace {

test::LightingCase litCase() {
    test::LightingCase item;
    item.box = true;
    item.lights.emplace_back().location = {3, 5, -4};
    return item;
}

RenderRequest requestFor(const std::shared_ptr<const Scene>& scene, int width = 100, int height = 75) {
    return test::requestFor(scene, width, height);
}

}  // namespace

class RenderImageTest : public QObject {
    Q_OBJECT

  private slots:
    void threadsDoNotChangeThePicture() {
        const RenderRequest request = requestFor(test::sceneOf(litCase()));
        const Image one = renderImage(request, 1);
        QCOMPARE(one.pixels.size(), std::size_t{7500});
        for (int threads : {2, 3, 8}) QVERIFY(renderImage(request, threads).pixels == one.pixels);
    }

    /// Tiles that the picture cuts, in every way: the middle of three by three pixels has the same ray.
    void cutTilesAreWhereTheyBelong() {
        const auto scene = test::sceneOf(litCase());
        for (const auto& [width, height] : {std::pair{68, 132}, {64, 36}, {70, 37}, {3, 65}, {130, 2}}) {
            RenderRequest request = requestFor(scene, width, height);
            request.rootFinder = RootFinder::certified;
            const Image image = renderImage(request, 2);
            request.width *= 3, request.height *= 3;
            const Image large = renderImage(request, 2);
            for (int y = 0; y < height; ++y)
                for (int x = 0; x < width; ++x) {
                    const auto at = static_cast<std::size_t>(y * width + x);
                    const auto there = static_cast<std::size_t>((3 * y + 1) * 3 * width + 3 * x + 1);
                    for (std::size_t c = 0; c < 3; ++c)
                        QVERIFY(std::abs(image.pixels[at][c] - large.pixels[there][c]) < 1e-5f);
                }
        }
    }

    /// Rays, hits, verdicts, light and pixels go by vectors of any width.
    void instructionSetsAgree() {
        RenderRequest request = test::requestFor(
            parseScene("camera { location <3, 2, -4> look_at 0 }"
                       "light_source { <-3, 5, -6> rgb 1 shadowless }"
                       "isosurface { function { x*x + y*y + z*z - 1 } contained_by { sphere { 0, 1.2 } } "
                       "pigment { rgb <0.9, 0.7, 0.3> } finish { phong 0.5 } }"),
            150, 90);
        request.rootFinder = RootFinder::certified;
        RenderStatistics statistics;
        const Image usual = renderImage(request, 2, &statistics);
        QVERIFY(statistics.verdicts["certified-hit"] > 1000);
        for (const auto& [target, name] : test::instructionSets()) {
            const test::ForcedInstructionSet forced(target);
            RenderStatistics others;
            const Image image = renderImage(request, 1, &others);
            QVERIFY2(others.verdicts == statistics.verdicts, name);
            for (std::size_t i = 0; i < image.pixels.size(); ++i)
                for (std::size_t c = 0; c < 3; ++c)
                    QVERIFY2(std::abs(image.pixels[i][c] - usual.pixels[i][c]) < 1e-5f, name);
        }
    }

    /// Far from everything no stage but the background runs; beside an object all of them do.
    void theBackgroundIsTheSameFarFromEverything() {
        for (const double gamma : {1.0, 2.2, srgbGamma}) {
            const auto scene = std::make_shared<Scene>(*test::sceneOf(litCase()));
            scene->objects.resize(1);
            scene->objects[0].shape = std::make_shared<Sphere>(glm::dvec3(0), 1);
            scene->background = {0.3, 1.5, -1, 0, 0};
            scene->settings.assumedGamma = gamma;
            RenderRequest request = requestFor(scene, 320, 200);
            request.camera = {};
            request.camera.location = {0, 0, -30};
            const Image image = renderImage(request, 2);
            const auto pixel = [&](int x, int y) {
                return image.pixels[static_cast<std::size_t>(y * image.width + x)];
            };
            int middle = 160;
            while (middle < 320 && pixel(middle, 100) != pixel(0, 0)) ++middle;
            // The ball has an edge, and it is near the middle.
            QVERIFY(middle > 162 && middle < 190);
            QCOMPARE(pixel(middle, 100), pixel(319, 199));
            QCOMPARE(pixel(0, 0)[1], 1.0f);
            QCOMPARE(pixel(0, 0)[2], 0.0f);
        }
    }

    void countsWhatItDid() {
        RenderStatistics statistics;
        renderImage(requestFor(test::sceneOf(litCase())), 2, &statistics);
        QCOMPARE(test::find(statistics, StageKind::primaryRays)->rays, std::uint64_t{7500});
        QCOMPARE(statistics.verdicts["hit"] + statistics.verdicts["miss"], std::uint64_t{7500});
        QVERIFY(statistics.verdicts["miss"] > 500);
        const std::uint64_t shadowRays = test::find(statistics, StageKind::shadows)->rays;
        QVERIFY(shadowRays > 1000);
        QVERIFY(shadowRays < statistics.verdicts["hit"]);  // none from surfaces that face away
        QCOMPARE(statistics.rays, 7500 + shadowRays);
        QVERIFY(statistics.cpuSeconds > 0);
        QCOMPARE(test::find(statistics, StageKind::background)->rays, std::uint64_t{0});
    }

    void aStageLeftOutCostsNothing() {
        auto scene = std::make_shared<Scene>(*test::sceneOf(litCase()));
        RenderRequest request = requestFor(scene);
        request.leftOut.set(StageKind::shadows, true);
        RenderStatistics statistics;
        const Image without = renderImage(request, 2, &statistics);
        QVERIFY(test::find(statistics, StageKind::shadows) == nullptr);
        QCOMPARE(statistics.rays, std::uint64_t{7500});
        // As if the scene had not called for it, but for the highlights that shadowless lights do not make.
        for (SceneObject& object : scene->objects) object.castsShadow = false;
        QVERIFY(without.pixels == renderImage(requestFor(scene)).pixels);
    }

    void noShadowRaysWithoutCause() {
        const auto shape = std::make_shared<test::GatedShape>();
        auto scene = std::make_shared<Scene>(*test::sceneOf(litCase()));
        scene->objects.front().shape = shape;
        renderImage(requestFor(scene));
        QVERIFY(shape->shadowCalls > 0);
        shape->shadowCalls = 0;
        auto shadowless = std::make_shared<Scene>(*scene);
        shadowless->lights[0].shadowless = true;
        RenderStatistics statistics;
        renderImage(requestFor(shadowless), 2, &statistics);
        QCOMPARE(shape->shadowCalls.load(), 0);
        QVERIFY(test::find(statistics, StageKind::shadows) == nullptr);
        auto dark = std::make_shared<Scene>(*scene);
        dark->lights.clear();
        renderImage(requestFor(dark));
        QCOMPARE(shape->shadowCalls.load(), 0);
    }

    void anInvisibleObjectStillThrowsItsShadow() {
        auto scene = std::make_shared<Scene>(*test::sceneOf(litCase()));
        RenderStatistics with, without;
        scene->objects[2].visible = false;
        renderImage(requestFor(scene), 1, &with);
        const Image hidden = renderImage(requestFor(scene));
        scene = std::make_shared<Scene>(*scene);
        scene->objects[2].castsShadow = false;
        QVERIFY(renderImage(requestFor(scene)).pixels != hidden.pixels);
    }

    void aStoppedPictureIsBlack() {
        std::stop_source stop;
        stop.request_stop();
        const Image image = renderImage(requestFor(test::sceneOf(litCase())), 2, nullptr, stop.get_token());
        QCOMPARE(image.pixels.size(), std::size_t{7500});
        for (const auto& pixel : image.pixels) QCOMPARE(pixel[0] + pixel[1] + pixel[2], 0.0f);
    }

    void refusesWhatCannotBeDrawn() {
        const auto scene = test::sceneOf(litCase());
        for (auto [width, height] :
             {std::pair{0, 0}, {0, 4}, {-1, 5}, {200'000, 200'000}, {INT_MAX, INT_MAX}})
            QVERIFY(renderImage(requestFor(scene, width, height)).pixels.empty());
        RenderRequest nothing;
        nothing.width = nothing.height = 4;
        QVERIFY(renderImage(nothing).pixels.empty());
    }

    void antialiasingSoftensEdgesOnly() {
        RenderRequest request = requestFor(test::sceneOf(litCase()));
        const Image hard = renderImage(request);
        request.antialias = true;
        RenderStatistics statistics;
        const Image soft = renderImage(request, 2, &statistics);
        QCOMPARE(test::find(statistics, StageKind::primaryRays)->rays, std::uint64_t{9 * 7500});
        const std::size_t sky = 3;  // top row: nothing but background
        QCOMPARE(encodePixel(soft.pixels[sky]), encodePixel(hard.pixels[sky]));
        QVERIFY(soft.pixels != hard.pixels);
    }

    void nanAndInfinityInTheSceneDrawSomething() {
        auto scene = std::make_shared<Scene>(*test::sceneOf(litCase()));
        const double bad = std::nan("");
        scene->lights[0].color = {bad, HUGE_VAL, -1};
        scene->materials[0].finish.phongSize = bad;
        scene->background.red = bad;
        scene->settings.assumedGamma = bad;
        const Image image = renderImage(requestFor(scene));
        for (const auto& pixel : image.pixels)
            for (float channel : pixel) QVERIFY(channel >= 0 && channel <= 1);
    }

    /// A camera on the wall of a room saw nothing but that wall.
    void camerasLookPastWhatTheyTouch() {
        const auto middle = [](const std::string& object, RootFinder finder) {
            const ParseResult parsed =
                parseScene("camera { location 0 look_at z } background { rgb <0, 1, 0> }" + object +
                           "pigment { gradient z color_map { [0.5 rgb x] [0.5 rgb z] } scale 10 } finish { "
                           "emission 1 } }");
            RenderRequest request = requestFor(parsed.scene, 101, 75);
            request.rootFinder = finder;
            const Image image = renderImage(request, 1);
            return encodePixel(image.pixels[37 * 101 + 50]);
        };
        for (const RootFinder finder : {RootFinder::lipschitz, RootFinder::certified}) {
            QCOMPARE(middle("box { <-9, -9, 0>, <9, 9, 7>", finder), 0xff0000ff);
            QCOMPARE(middle("box { <-9, -9, 0.00009>, <9, 9, 7>", finder), 0xff0000ff);
            QCOMPARE(middle("box { <-9, -9, 0.00011>, <9, 9, 7>", finder), 0xffff0000);
            QCOMPARE(middle("plane { -z, 0", finder), 0xff00ff00);
            QCOMPARE(
                middle("isosurface { function { z * (z - 6) } contained_by { box { -9, 9 } } max_gradient 20",
                       finder),
                0xff0000ff);
        }
    }

    void aSceneWithoutObjectsIsBackground() {
        auto scene = std::make_shared<Scene>();
        scene->background = {0.25, 0.5, 1};
        const Image image = renderImage(requestFor(scene, 3, 2));
        for (const auto& pixel : image.pixels) QCOMPARE(encodePixel(pixel), 0xff89bcffu);
    }
};

QTEST_APPLESS_MAIN(RenderImageTest)
#include "render_image_test.moc"
