// SPDX-License-Identifier: GPL-3.0-or-later
#include <glm/geometric.hpp>

#include "test_folders.h"
#include "tests/support/scene_picture.h"

using namespace isoscope;
using test::costOf, test::find, test::requestFor;

namespace {

constexpr double wantedShare = 0.99;

QDir folder() { return QDir(ISOSCOPE_TEST_DATA "/effects"); }

/// A ball over a floor in the light of an area of 9 x 9.
std::string ballUnder(const std::string& area) {
    return "camera { location <0, 3, -6> look_at 0 } sphere { y, 0.5 pigment { rgb 1 } } plane { y, 0 "
           "pigment { rgb 1 } }"
           "light_source { <3, 8, -3>, 1 " +
           area + " }";
}

}  // namespace

class EffectPicturesTest : public QObject {
    Q_OBJECT

  private slots:
    void looksAsInPovray_data() { test::addScenes(folder()); }

    void looksAsInPovray() {
        if (!test::hasPovray()) QSKIP(test::povrayIsMissing);
        QFETCH(QString, name);
        const test::PictureDifference difference =
            test::differenceFromPovray(folder().filePath(name), "effect_" + name.chopped(4));
        if (name.startsWith("random_"))
            QVERIFY(difference.mean < 4);
        else
            QVERIFY(difference.shareWithin8 >= wantedShare);
    }

    void lightsThatArePointsHaveNoAreaToAsk() {
        const RenderStatistics cost = costOf(ballUnder(""));
        QVERIFY(!find(cost, StageKind::areaLights));
        QVERIFY(find(cost, StageKind::shadows)->rays > 0);
        QVERIFY(!find(costOf(ballUnder("area_light x, z, 9, 9 shadowless")), StageKind::areaLights));
    }

    /// The disc was asked once for all lights of the area, from its middle, and had a hard edge.
    void projectedAreasAskForEachOfTheirLights() {
        const std::string disc = " shadowless projected_through { disc { <0.5, 2, -0.5>, y, 9 } }";
        const std::uint64_t points = find(costOf(ballUnder(disc)), StageKind::projection)->rays;
        QVERIFY(points > 1000);
        const RenderStatistics cost = costOf(ballUnder("area_light x, z, 3, 3" + disc));
        QCOMPARE(find(cost, StageKind::projection)->rays, 9 * points);
        QVERIFY(!find(cost, StageKind::shadows));
    }

    void everyLightOfAnAreaIsAskedOnce() {
        const std::uint64_t points = find(costOf(ballUnder("")), StageKind::shadows)->rays;
        const RenderStatistics cost = costOf(ballUnder("area_light x, z, 9, 9"));
        QCOMPARE(find(cost, StageKind::areaLights)->rays, 81 * points);
        QCOMPARE(find(cost, StageKind::areaLights)->reason,
                 std::string("light_source at line 1 has 81 lights"));
        // Those rays are not counted twice.
        QCOMPARE(find(cost, StageKind::shadows)->rays, std::uint64_t{0});
    }

    void layersOfATextureAskOnce() {
        const auto rays = [](const std::string& texture) {
            return find(
                       costOf(
                           "camera { location -4*z look_at 0 } light_source { -9*z, 1 area_light x, y, 3, 3 }"
                           "sphere { 0, 1 " +
                           texture + " }"),
                       StageKind::areaLights)
                ->rays;
        };
        const std::string veil =
            "texture { pigment { granite color_map { [0 rgbt <1, 0, 0, 0.5>] [1 rgbt <0, 1, 0, 0.6>] } } }";
        QCOMPARE(rays("pigment { rgb 1 } texture { pigment { rgb 1 } } " + veil), rays("pigment { rgb 1 }"));
    }

    void adaptiveAreasAreAskedWhereThePenumbraIs() {
        const std::uint64_t points = find(costOf(ballUnder("")), StageKind::shadows)->rays;
        const std::uint64_t rays =
            find(costOf(ballUnder("area_light x, z, 9, 9 adaptive 0")), StageKind::areaLights)->rays;
        QVERIFY(rays >= 4 * points);
        // Hardly more than the corners for most of the floor.
        QVERIFY(rays < 6 * points);
    }

    void softShadowsDoNotDependOnTheThreads() {
        const ParseResult parsed = parseScene(ballUnder("area_light x, z, 5, 5 jitter"));
        const RenderRequest request = requestFor(parsed);
        QVERIFY(renderImage(request, 1).pixels == renderImage(request, 3).pixels);
    }

    void blurIsDrawnOnlyWithAnAperture() {
        const std::string ball = " location -5*z } sphere { 0, 1 pigment { rgb 1 } } light_source { -9, 1 }";
        const RenderStatistics sharp = costOf("camera { blur_samples 20 focal_point 0" + ball);
        QVERIFY(!find(sharp, StageKind::focalBlur));
        const RenderStatistics blurred = costOf("camera { blur_samples 20 focal_point 0 aperture 0.5" + ball);
        QVERIFY(find(blurred, StageKind::focalBlur));
        const auto pixels = static_cast<std::uint64_t>(160 * 120);
        const std::uint64_t more = find(blurred, StageKind::focalBlur)->rays;
        QCOMPARE(find(blurred, StageKind::primaryRays)->rays, pixels);
        // Eight rays tell that the background is even; the ball asks for more.
        QVERIFY(more > 7 * pixels);
        QVERIFY(more < 15 * pixels);
    }

    void leftOutBlurIsSharp() {
        const std::string ball = " location -5*z } sphere { 0, 1 pigment { rgb 1 } } light_source { -9, 1 }";
        RenderRequest blurred =
            requestFor(parseScene("camera { blur_samples 20 focal_point 0 aperture 0.5" + ball));
        blurred.leftOut.set(StageKind::focalBlur, true);
        const RenderRequest sharp = requestFor(parseScene("camera { focal_point 0" + ball));
        QVERIFY(renderImage(blurred, 1).pixels == renderImage(sharp, 1).pixels);
    }

    void randomEffectsDoNotDependOnTheThreads() {
        const ParseResult parsed = parseScene(
            "camera { location -5*z blur_samples 20 focal_point 0 aperture 0.5 }"
            "sphere { 0, 1 pigment { rgb 1 } finish { crand 0.3 } } light_source { -9, 1 }");
        QVERIFY(renderImage(requestFor(parsed), 1).pixels == renderImage(requestFor(parsed), 3).pixels);
    }

    void grainTakesAwayFromTheDiffuseLight() {
        const std::string ball =
            "camera { location -5*z } light_source { -9*z, 1 } sphere { 0, 1 pigment { rgb 1 }";
        QVERIFY(!find(costOf(ball + "}"), StageKind::grain));
        const ParseResult plain = parseScene(ball + "}"),
                          grainy = parseScene(ball + "finish { crand 0.2 } }");
        const Image before = renderImage(requestFor(plain), 1), after = renderImage(requestFor(grainy), 1);
        int darker = 0;
        for (std::size_t i = 0; i < before.pixels.size(); ++i) {
            const float loss = before.pixels[i][0] - after.pixels[i][0];
            QVERIFY(loss > -1e-6F && loss < 0.2F + 1e-6F);
            darker += loss > 0.05F;
        }
        QVERIFY(darker > 500);
    }

    /// Grain stopped where a surface returns nothing; POV-Ray's goes on, off the light of its own.
    void grainTakesAwayMoreThanTheDiffuseLight() {
        const Image image = renderImage(
            requestFor(
                parseScene("camera { location -5*z angle 2 } light_source { -9*z, 1 }"
                           "sphere { 0, 1 pigment { rgb 1 } finish { ambient 0.5 diffuse 0.1 crand 0.4 } }")),
            1);
        double sum = 0;
        for (const auto& pixel : image.pixels) {
            QVERIFY(pixel[0] > 0.19F && pixel[0] < 0.61F);
            sum += pixel[0];
        }
        const double mean = sum / static_cast<double>(image.pixels.size());
        QVERIFY2(std::abs(mean - 0.4) < 0.01, qPrintable(QString::number(mean)));
    }

    void lightsOfAGroupReachItsObjectsOnly() {
        const std::string view = "camera { orthographic location -5*z look_at 0 right 4*x up 3*y }";
        const std::string ball = "sphere { 0, 1 pigment { rgb 1 } finish { ambient 0 diffuse 1 } }";
        const auto middle = [&](const std::string& text) {
            const ParseResult parsed = parseScene(view + text);
            return renderImage(requestFor(parsed), 1).pixels[60 * 160 + 80];
        };
        const std::string red = "light_source { -9*z, rgb x }", blue = "light_source { -9*z, rgb z }";
        const auto dark = [](float value) { return value < 1e-6F; };
        auto pixel = middle(red + "light_group { " + blue + ball + "}");
        QVERIFY(dark(pixel[0]) && pixel[2] > 0.9F);
        pixel = middle(red + "light_group { " + blue + ball + " global_lights }");
        QVERIFY(pixel[0] > 0.9F && pixel[2] > 0.9F);
        pixel = middle(red + ball + "light_group { " + blue + "sphere { 3, 0.1 } }");
        QVERIFY(pixel[0] > 0.9F && dark(pixel[2]));
        // Not even those of the group around it.
        pixel = middle("light_group { " + red + "light_group { " + blue + ball + "} }");
        QVERIFY(dark(pixel[0]) && pixel[2] > 0.9F);
    }

    void scenesWithoutThemPayForNoneOfTheLesserEffects() {
        const RenderStatistics plain = costOf(
            "camera { location -5*z } sphere { 0, 1 pigment { rgb 1 } }"
            "light_source { -9, 1 }");
        for (const StageKind kind : {StageKind::rainbow, StageKind::projection, StageKind::cameraNormal})
            QVERIFY(!find(plain, kind));
    }

    void lesserEffectsTellTheirLines() {
        const RenderStatistics cost = costOf(
            "camera { location -5*z normal { bumps 0.1 } } sphere { 0, 1 pigment { rgb 1 } }\n"
            "light_source { -9, 1 projected_through { sphere { -3, 1 } } }\n"
            "rainbow { direction z angle 30 width 5 distance 10 color_map { [0 rgb 1] [1 rgb x] } }");
        QCOMPARE(find(cost, StageKind::projection)->reason,
                 std::string("light_source at line 2 is projected through an object"));
        QVERIFY(find(cost, StageKind::projection)->rays > 100);
        QCOMPARE(find(cost, StageKind::rainbow)->reason, std::string("rainbow at line 3; 1 rainbow in all"));
        QVERIFY(find(cost, StageKind::rainbow)->evaluations > 100);
        QCOMPARE(find(cost, StageKind::cameraNormal)->reason,
                 std::string("the camera has a normal that bends its rays"));
    }

    void lesserEffectsCanBeLeftOut() {
        const std::string scene = " } sphere { 0, 1 pigment { rgb 1 } } light_source { -9, 1 }";
        const std::string bow =
            "rainbow { direction z angle 30 width 5 distance 10 color_map { [0 rgb 1] [1 rgb x] } }";
        RenderRequest without =
            requestFor(parseScene("camera { location -5*z normal { bumps 0.5 scale 0.1 }" + scene + bow));
        const RenderRequest plain = requestFor(parseScene("camera { location -5*z" + scene));
        QVERIFY(renderImage(without, 1).pixels != renderImage(plain, 1).pixels);
        without.leftOut.set(StageKind::cameraNormal, true);
        without.leftOut.set(StageKind::rainbow, true);
        QVERIFY(renderImage(without, 1).pixels == renderImage(plain, 1).pixels);
    }

    void mistakesInARainbowAreTold() {
        const auto message = [](const std::string& text) {
            const ParseResult parsed = parseScene("sphere { 0, 1 } rainbow {" + text + "}");
            return parsed.diagnostics.empty() ? std::string() : parsed.diagnostics.front().message;
        };
        QCOMPARE(message("width 1 distance 1"), std::string("A rainbow needs a `color_map`."));
        QCOMPARE(message("distance 1 color_map { [0 rgb 1] }"), std::string("A rainbow needs a `width`."));
        QCOMPARE(message("width 1 color_map { [0 rgb 1] }"), std::string("A rainbow needs a `distance`."));
        QCOMPARE(message("foo"), std::string("`foo` is not understood in `rainbow`."));
    }

    void whatALightLooksLikeCastsNoShadow() {
        const ParseResult parsed =
            parseScene("light_source { y, 1 looks_like { sphere { 0, 0.1 } } translate x }");
        QVERIFY(parsed.ok());
        QCOMPARE(parsed.scene->objects.size(), std::size_t{1});
        QVERIFY(!parsed.scene->objects[0].castsShadow);
        // The same, declared.
        for (const char* use : {"object { Lamp translate x }", "light_source { Lamp translate x }"}) {
            const ParseResult declared = parseScene(
                std::string("#declare Lamp = light_source { y, 1 looks_like { sphere { 0, 0.1 } } }\n") +
                use);
            QVERIFY2(declared.ok(), test::problems(declared).c_str());
            QCOMPARE(declared.scene->lights.size(), std::size_t{1});
            QVERIFY(declared.scene->lights[0].location == glm::dvec3(1, 1, 0));
            QCOMPARE(declared.scene->objects.size(), std::size_t{1});
            const Bounds moved = declared.scene->objects[0].shape->bounds();
            QVERIFY(glm::distance(0.5 * (moved.low + moved.high), glm::dvec3(1, 1, 0)) < 1e-12);
            QVERIFY(!declared.scene->objects[0].castsShadow);
        }
        const Bounds bounds = parsed.scene->objects[0].shape->bounds();
        QVERIFY(glm::distance(0.5 * (bounds.low + bounds.high), glm::dvec3(1, 1, 0)) < 1e-12);
    }

    void onlyRoundPicturesHaveASurround() {
        const std::string ball = " sphere { 5*z, 1 } background { rgb <1, 0, 0> }";
        QVERIFY(!find(costOf("camera { spherical }" + ball), StageKind::surround));
        QVERIFY(!find(costOf(ball), StageKind::surround));
        QVERIFY(find(costOf("camera { omnimax }" + ball), StageKind::surround));

        const ParseResult parsed = parseScene("camera { fisheye }" + ball);
        const Image image = renderImage(requestFor(parsed), 1);
        QCOMPARE(encodePixel(image.pixels.front()), 0xff000000);
        const std::size_t aside = 60 * 160 + 40;
        QCOMPARE(encodePixel(image.pixels[aside]), 0xffff0000);
    }
};

QTEST_APPLESS_MAIN(EffectPicturesTest)
#include "effect_pictures_test.moc"
