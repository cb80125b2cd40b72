// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/render/light/simple_shading.h"

#include <QTest>

#include "tests/support/scene_picture.h"

using namespace isoscope;

namespace {

/// Surfaces of several kinds that overlap, a bent sheet among them, and three lights.
const std::string plainScene =
    "global_settings { ambient_light <1, 0.5, 0.8> }"
    "camera { location <3, 2, -4> look_at 0 } background { rgb <0.1, 0.3, 1.4> }"
    "light_source { <-3, 5, -6> rgb <1, 0.9, 0.6> shadowless } light_source { <8, 1, -2> rgb 0.5 }"
    "light_source { <0.1, -9, 4> rgb <0, 0.2, 1> shadowless }"
    "isosurface { function { x*x + y*y + z*z - 1 } contained_by { sphere { 0, 1.2 } }"
    "  pigment { rgb <0.9, 0.7, 0.3> } finish { ambient 0.1 diffuse 0.8 phong 0.5 phong_size 40 } }"
    "isosurface { function { y + 0.3*sin(4*x) } contained_by { box { <-2, -0.8, -2>, <2, 1, 2> } } open"
    "  max_gradient 2 pigment { rgb <0.2, 0.7, 0.9> }"
    "  finish { specular 0.6 roughness 0.03 metallic 0.5 brilliance 1.7 diffuse 0.5, 0.3 } }"
    "sphere { <1.4, 0.4, -1.5>, 0.35 pigment { rgb 2 } finish { emission 0.3 irid { 0.3 thickness 0.4 } } }"
    "box { <-1.6, -1, -1.2>, <-1, 0.2, -0.6> double_illuminate pigment { rgb <0.9, 0.1, 0.1> } }";

std::shared_ptr<Scene> sceneOf(const std::string& text) {
    const ParseResult parsed = parseScene(text);
    if (!parsed.ok()) QTest::qFail(test::problems(parsed).c_str(), __FILE__, __LINE__);
    return std::make_shared<Scene>(*parsed.scene);
}

/// The same picture by the stage that knows everything: nothing bears the material.
std::shared_ptr<Scene> withPatternedMaterial(const std::shared_ptr<Scene>& scene) {
    const ParseResult other = parseScene("sphere { 0, 1 pigment { gradient x } }");
    auto more = std::make_shared<Scene>(*scene);
    more->materials.push_back(other.scene->materials.back());
    return more;
}

StageSet withoutShadows() {
    StageSet leftOut;
    leftOut.set(StageKind::shadows, true);
    return leftOut;
}

bool isPlain(const Scene& scene, const StageSet& leftOut = {}) {
    return SimpleShading::of(scene, makePlan(scene, leftOut)).has_value();
}

}  // namespace

class SimpleShadingTest : public QObject {
    Q_OBJECT

  private slots:
    void paintsAsDirectLightDoes() {
        const std::shared_ptr<Scene> scene = sceneOf(plainScene);
        for (const double gamma : {1.0, 2.2, srgbGamma}) {
            scene->settings.assumedGamma = gamma;
            const auto patterned = withPatternedMaterial(scene);
            QVERIFY(isPlain(*scene, withoutShadows()) && !isPlain(*patterned, withoutShadows()));
            for (const RootFinder finder : {RootFinder::certified, RootFinder::lipschitz}) {
                RenderRequest request = test::requestFor(scene, 147, 101);
                request.leftOut = withoutShadows();
                request.rootFinder = finder;
                RenderStatistics ours, theirs;
                const Image image = renderImage(request, 2, &ours);
                request.scene = patterned;
                const Image other = renderImage(request, 2, &theirs);
                QVERIFY(image.pixels == other.pixels);
                QVERIFY(ours.verdicts == theirs.verdicts);
                QCOMPARE(ours.rays, theirs.rays);
            }
        }
    }

    void whatItLeavesToOthers() {
        const std::string ball = "sphere { 0, 1 pigment { rgb 1 } }",
                          light = "light_source { 9 rgb 1 shadowless";
        QVERIFY(isPlain(*sceneOf(ball + light + " }")));
        QVERIFY(!isPlain(*sceneOf(ball + light + " spotlight point_at 0 }")));
        QVERIFY(!isPlain(*sceneOf(ball + light + " parallel point_at 0 }")));
        QVERIFY(!isPlain(*sceneOf(ball + light + " fade_distance 3 fade_power 2 }")));
        QVERIFY(!isPlain(*sceneOf(ball + light + " area_light x, y, 3, 3 area_illumination on }")));
        QVERIFY(!isPlain(*sceneOf(ball + "light_source { 9 rgb 1 } plane { y, -1 }")));
        QVERIFY(!isPlain(*sceneOf(ball + light + " } fog { distance 3 rgb 1 }")));
        QVERIFY(!isPlain(*sceneOf(ball + light + " } sphere { 3, 1 pigment { rgbt 0.5 } }")));
        QVERIFY(!isPlain(*sceneOf(ball + light + " } sphere { 3, 1 normal { bumps } }")));
        QVERIFY(!isPlain(*sceneOf(ball + light + " } sphere { 3, 1 finish { reflection 0.2 } }")));
        QVERIFY(!isPlain(
            *sceneOf("light_group { " + light + " } " + ball + " global_lights off }" + light + " }")));
    }

    /// Tiles that no ray can meet anything in are filled as a whole, and counted like the others.
    void emptyTilesCountAsDrawn() {
        const std::shared_ptr<Scene> scene = sceneOf(
            "camera { location -30*z } background { rgb <0.2, 0.4, 0.6> } light_source { -9*z rgb 1 "
            "shadowless }"
            "sphere { <4, 3, 0>, 1 pigment { rgb 1 } }");
        for (const RootFinder finder : {RootFinder::certified, RootFinder::lipschitz}) {
            RenderRequest request = test::requestFor(scene, 333, 222);
            request.rootFinder = finder;
            RenderStatistics statistics;
            const Image image = renderImage(request, 3, &statistics);
            std::size_t lit = 0;
            for (const LinearColor& pixel : image.pixels) lit += pixel != image.pixels[0];
            QCOMPARE(image.pixels[0], (LinearColor{0.2f, 0.4f, 0.6f}));
            QVERIFY(lit > 100 && lit < 2000);
            QCOMPARE(statistics.rays, std::uint64_t{333 * 222});
            const char* const hit = finder == RootFinder::certified ? "certified-hit" : "hit";
            const char* const miss = finder == RootFinder::certified ? "certified-miss" : "miss";
            QCOMPARE(statistics.verdicts[hit], std::uint64_t{lit});
            QCOMPARE(statistics.verdicts[miss], std::uint64_t{333 * 222} - lit);
        }
    }
};

QTEST_APPLESS_MAIN(SimpleShadingTest)
#include "simple_shading_test.moc"
