// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/render/light/secondary_rays.h"

#include "core/render/light/secondary_ray_queue.h"
#include "core/render/picture.h"
#include "test_folders.h"
#include "tests/support/scene_picture.h"

using namespace isoscope;
using test::requestFor;

namespace {

constexpr double wantedShare = 0.99;

QDir folder() { return QDir(ISOSCOPE_TEST_DATA "/light"); }

RenderStatistics costOf(const std::string& text, const StageSet& leftOut = {}) {
    return test::costOf(text, leftOut, 64, 48);
}

/// Rays of a stage; -1 when it did not run.
long long raysOf(const RenderStatistics& statistics, StageKind kind) {
    const StageReport* stage = test::find(statistics, kind);
    return stage ? static_cast<long long>(stage->rays) : -1;
}

/// The colour in the middle of a picture of one pixel, before it is encoded.
LinearColor colorOf(const std::string& text) {
    const ParseResult parsed = parseScene(
        "#version 3.7; camera { orthographic location -10*z look_at 0 "
        "right 2*x up 2*y }\n" +
        text);
    return renderImage(requestFor(parsed, 1, 1)).pixels.at(0);
}

bool close(const LinearColor& color, double red, double green, double blue) {
    const double wanted[] = {red, green, blue};
    for (std::size_t c = 0; c < 3; ++c)
        if (!(std::abs(static_cast<double>(color[c]) - wanted[c]) < 1e-5)) return false;
    return true;
}

const std::string view = "camera { location -6*z look_at 0 } light_source { <3, 5, -4>, 1 } ";

}  // namespace

class SecondaryRaysTest : public QObject {
    Q_OBJECT

  private slots:
    void looksAsInPovray_data() { test::addScenes(folder()); }

    void looksAsInPovray() {
        if (!test::hasPovray()) QSKIP(test::povrayIsMissing);
        QFETCH(QString, name);
        const test::PictureDifference difference =
            test::differenceFromPovray(folder().filePath(name), "light_" + name.chopped(4));
        QVERIFY(difference.shareWithin8 >= wantedShare);
    }

    void certifiedMirrorsLookAsInPovray() {
        if (!test::hasPovray()) QSKIP(test::povrayIsMissing);
        const test::PictureDifference difference = test::differenceFromPovray(
            folder().filePath("mirror_sphere.pov"), "light_mirror_sphere_certified", RootFinder::certified);
        QVERIFY(difference.shareWithin8 >= wantedShare);
    }

    void effectsThatAreNotCalledForSendNoRay() {
        const RenderStatistics plain =
            costOf(view + "sphere { 0, 1 pigment { rgb 1 } interior { ior 1.5 } }");
        for (const StageKind kind : {StageKind::reflection, StageKind::transparency, StageKind::refraction,
                                     StageKind::clearShadows, StageKind::fog})
            QCOMPARE(raysOf(plain, kind), -1);
    }

    void mirrorsSendOneRayForEachPlaceThatIsSeen() {
        const RenderStatistics cost =
            costOf(view + "sphere { 0, 1 pigment { rgb 1 } finish { reflection 0.5 } }");
        QCOMPARE(raysOf(cost, StageKind::reflection), static_cast<long long>(cost.verdicts.at("hit")));
        QCOMPARE(raysOf(cost, StageKind::transparency), -1);
    }

    void clearBallsAreLeftWhereTheyAreEntered() {
        const RenderStatistics cost = costOf(view + "sphere { 0, 1 pigment { rgbt 1 } no_shadow }");
        QCOMPARE(raysOf(cost, StageKind::transparency), 2 * static_cast<long long>(cost.verdicts.at("hit")));
        QCOMPARE(raysOf(cost, StageKind::refraction), 0LL - 1);
        QCOMPARE(raysOf(cost, StageKind::clearShadows), -1);
        const RenderStatistics glass =
            costOf(view + "sphere { 0, 1 pigment { rgbt 1 } interior { ior 1.5 } no_shadow }");
        QCOMPARE(raysOf(glass, StageKind::refraction), 2 * static_cast<long long>(glass.verdicts.at("hit")));
        QCOMPARE(raysOf(glass, StageKind::transparency), 0LL);
    }

    void shadowlessLightsSendNoShadowRays() {
        const RenderStatistics cost = costOf(
            "camera { location -6*z look_at 0 } light_source { <3, 5, -4>, 1 shadowless }"
            "sphere { 0, 1 pigment { rgbt 0.5 } } plane { y, -1 pigment { rgb 1 } finish { reflection 0.3 } "
            "}");
        QCOMPARE(raysOf(cost, StageKind::shadows), -1);
        QCOMPARE(raysOf(cost, StageKind::clearShadows), -1);
        QVERIFY(raysOf(cost, StageKind::reflection) > 0);
    }

    void opaqueObjectsAreInNoTestForClearShadows() {
        // The glass throws no shadow, so that its stage is not needed.
        const RenderStatistics cost = costOf(view +
                                             "sphere { 0, 1 pigment { rgbt 0.5 } no_shadow } plane { y, "
                                             "-1 pigment { rgb 1 } }");
        QCOMPARE(raysOf(cost, StageKind::clearShadows), -1);
        QVERIFY(raysOf(cost, StageKind::shadows) > 0);
    }

    void effectsAddUp() {
        const std::string mirror = "sphere { -x*1.5, 1 pigment { rgb 1 } finish { reflection 0.5 } } ";
        const std::string glass = "sphere { x*1.5, 1 pigment { rgbt 1 } no_reflection no_shadow } ";
        const RenderStatistics both = costOf(view + mirror + glass);
        QCOMPARE(raysOf(both, StageKind::reflection), raysOf(costOf(view + mirror), StageKind::reflection));
        QCOMPARE(raysOf(both, StageKind::transparency),
                 raysOf(costOf(view + glass), StageKind::transparency));
    }

    void effectsCanBeLeftOut() {
        const std::string scene =
            view +
            "sphere { 0, 1 pigment { rgbt 0.5 } finish { reflection 0.3 } interior { ior "
            "1.5 } } fog { distance 30 rgb 1 }";
        for (const StageKind kind : {StageKind::reflection, StageKind::transparency, StageKind::refraction,
                                     StageKind::clearShadows, StageKind::fog}) {
            QVERIFY(raysOf(costOf(scene), kind) >= 0);
            StageSet leftOut;
            leftOut.set(kind, true);
            QCOMPARE(raysOf(costOf(scene, leftOut), kind), -1);
        }
    }

    void raysEndAtTheTraceLevel() {
        // Two mirrors that face each other, each shining by itself.
        const auto seen = [](int level) {
            return colorOf("global_settings { assumed_gamma 1 max_trace_level " + std::to_string(level) +
                           " }\n#default { pigment { rgb 0.1 } finish { ambient 0 emission 1 diffuse 0 "
                           "reflection 1 } } plane { -z, 0 rotate x } plane { z, -20 no_image }")[0];
        };
        for (int level = 1; level <= 6; ++level)
            QVERIFY2(std::abs(static_cast<double>(seen(level)) - 0.1 * level) < 1e-5,
                     qPrintable(QString::number(level)));
        // Rays that go straight on do not count.
        std::string panes = "global_settings { assumed_gamma 1 max_trace_level 2 } background { rgb 1 }";
        for (int k = 0; k < 20; ++k)
            panes +=
                "plane { z, " + std::to_string(k) + " pigment { rgbt 0.9 } finish { ambient 0 diffuse 0 } }";
        const double left = 0.9 * std::pow(0.9, 19);
        QVERIFY(close(colorOf(panes), left, left, left));
    }

    void weakRaysAreNotSent() {
        const auto seen = [](const std::string& amount) {
            return colorOf(
                "global_settings { assumed_gamma 1 adc_bailout 0.1 } background { rgb 1 } plane { -z, 0 "
                "pigment { rgb 0 } finish { ambient 0 diffuse 0 reflection " +
                amount + " } }");
        };
        QVERIFY(close(seen("0.09"), 0, 0, 0));
        QVERIFY(close(seen("0.11"), 0.11, 0.11, 0.11));
        QVERIFY(close(seen("rgb <0.11, 0.02, 0.01>"), 0.11, 0.02, 0.01));
    }

    void endlessMirrorsTakeLittleMemoryAndCanBeStopped() {
        // Every hit sends two rays that never get weaker: 2^19 of them for each pixel if they are not
        // stopped.
        const ParseResult parsed = parseScene(
            "#version 3.7; global_settings { max_trace_level 20 adc_bailout 0 }"
            "#default { pigment { rgbt 1 } finish { reflection 1 } } camera { location 0.3 look_at z }"
            "union { sphere { 0, 1 } sphere { 0, 2 } sphere { 0, 3 } interior { ior 1.1 } }");
        QVERIFY2(parsed.ok(), test::problems(parsed).c_str());
        std::stop_source source;
        int asked = 0;
        const Picture picture(requestFor(parsed, 32, 32));
        TileScratch work = picture.makeWork();
        picture.begin(work, RayOrder::neighbours, source.get_token());
        for (int y = 0; y < 32; ++y)
            for (int x = 0; x < 32; ++x) work.pixels.push_back({x, y});
        std::size_t most = 0;
        QVERIFY(!picture.draw(false, work, [&] {
            most = std::max(most, work.laterRays.size());
            return ++asked > 200;
        }));
        QCOMPARE(asked, 201);
        QVERIFY(most > TileScratch::largestBatch);
        QVERIFY2(most <= 40 * TileScratch::largestBatch, qPrintable(QString::number(most)));
        QVERIFY(work.laterRays.empty());
    }

    void explodingRaysAreCutShortAndSaidSo() {
        // At each of 256 levels every glass sends two rays that never get weaker.
        const ParseResult parsed = parseScene(
            "#version 3.7; global_settings { max_trace_level 256 adc_bailout 0 }"
            "#default { pigment { rgbt 1 } finish { reflection 1 } } camera { location -2*z look_at 0 }"
            "sphere { -x, 0.8 interior { ior 1.5 } } sphere { x, 0.8 interior { ior 1.5 } }"
            "sphere { 0, 4 pigment { rgb 0 } }");
        QVERIFY2(parsed.ok(), test::problems(parsed).c_str());
        constexpr int width = 40, height = 2;
        RenderStatistics cost;
        const Image image = renderImage(requestFor(parsed, width, height), 1, &cost);
        const auto later = static_cast<std::uint64_t>(raysOf(cost, StageKind::reflection) +
                                                      raysOf(cost, StageKind::refraction));
        QVERIFY2(cost.cutSamples > 0, qPrintable(QString::number(later)));
        QVERIFY(later >= cost.cutSamples * SecondaryRayQueue::rayLimit);
        QVERIFY(later <= std::uint64_t{SecondaryRayQueue::rayLimit} * width * height);
        QVERIFY(
            cutWarning(cost).starts_with(std::to_string(cost.cutSamples) + " samples of the picture send "));
        // Which rays are cut does not depend on the threads: the picture has two tiles.
        RenderStatistics again;
        QVERIFY(renderImage(requestFor(parsed, width, height), 2, &again).pixels == image.pixels);
        QCOMPARE(again.cutSamples, cost.cutSamples);
    }

    /// Memory that is touched for the first time costs a small picture a fifth of its time.
    void smallPicturesHaveSmallBatches() {
        const ParseResult parsed = parseScene("#version 3.7; sphere { 0, 1 }");
        const auto batchRays = [&](int width, int height) {
            return Picture(requestFor(parsed, width, height)).makeWork().batchRays;
        };
        QCOMPARE(batchRays(1, 1), std::size_t(256));
        QCOMPARE(batchRays(160, 120), std::size_t(256));
        QCOMPARE(batchRays(240, 180), std::size_t(512));
        QCOMPARE(batchRays(640, 480), TileScratch::largestBatch);
    }

    void fewRaysWaitHoweverDeepTheyGo() {
        const ParseResult parsed = parseScene(
            "#version 3.7; global_settings { max_trace_level 256 adc_bailout 0 }"
            "#default { pigment { rgbt 1 } finish { reflection 1 } } camera { location 0.3 look_at z }"
            "union { sphere { 0, 1 } sphere { 0, 2 } sphere { 0, 3 } interior { ior 1.1 } }");
        QVERIFY2(parsed.ok(), test::problems(parsed).c_str());
        const Picture picture(requestFor(parsed, 32, 32));
        TileScratch work = picture.makeWork();
        work.batchRays = TileScratch::largestBatch;
        picture.begin(work, RayOrder::neighbours, {});
        for (int y = 0; y < 32; ++y)
            for (int x = 0; x < 32; ++x) work.pixels.push_back({x, y});
        int asked = 0;
        std::size_t most = 0;
        QVERIFY(!picture.draw(false, work, [&] {
            most = std::max(most, work.laterRays.size());
            return ++asked > 3000;
        }));
        QVERIFY2(most > SecondaryRays::waitingRays / 2, qPrintable(QString::number(most)));
        QVERIFY2(most < SecondaryRays::waitingRays + 2 * 256 * SecondaryRays::smallestBatch,
                 qPrintable(QString::number(most)));
    }

    void fullTreesOfRaysAreNotCut() {
        // Two rays at each of 14 levels: as many as a sample may send at most, but one.
        const auto cost = [](int level) {
            return test::costOf(
                "#version 3.7; global_settings { max_trace_level " + std::to_string(level) +
                    " adc_bailout 0 } camera { orthographic location 0 look_at z right 1e-3*x up 1e-3*y }"
                    "#default { pigment { rgbt 1 } finish { reflection 1 } } "
                    "sphere { 0, 1 interior { ior 1.1 } } sphere { 0, 2 interior { ior 1.2 } } "
                    "sphere { 0, 3 pigment { rgb 0 } }",
                {}, 2, 2);
        };
        QCOMPARE(cost(12).cutSamples, std::uint64_t{0});
        QVERIFY(cutWarning(cost(12)).empty());
        QCOMPARE(cost(40).cutSamples, std::uint64_t{4});
    }

    void mirrorsWithAnExponentAreCutToo() {
        const RenderStatistics cost = test::costOf(
            "#version 3.7; global_settings { max_trace_level 256 adc_bailout 0 } "
            "camera { location -2*z look_at 0 }"
            "#default { pigment { rgbt 1 } finish { reflection 1 reflection_exponent 2 } } "
            "sphere { -x, 0.8 interior { ior 1.5 } } sphere { x, 0.8 interior { ior 1.5 } } "
            "sphere { 0, 4 pigment { rgb 0 } }",
            {}, 4, 3);
        QVERIFY(cost.cutSamples > 0);
        QVERIFY(raysOf(cost, StageKind::reflection) <= 12LL * SecondaryRayQueue::rayLimit);
    }

    /// Of an isosurface with max_trace 1 in a CSG: the ray within begins on the surface, and meets the other
    /// side.
    void whatMayBeMetOnceIsLeftOnItsOtherSide() {
        const ParseResult parsed = parseScene(
            "#version 3.7; #include \"functions.inc\" global_settings { assumed_gamma 1 } background { rgb 1 "
            "} "
            "camera { location <1, 2, -5> look_at 0 angle 30 } intersection { isosurface { function { "
            "f_sphere(x, y, z, 1) } contained_by { box { -1.1, 1.1 } } max_gradient 2 } box { -0.9, 0.9 } "
            "pigment { rgb 0.5 filter 1 } finish { ambient 0 diffuse 0 } }");
        RenderRequest request = requestFor(parsed, 64, 48);
        request.rootFinder = RootFinder::certified;
        int within = 0;
        for (const LinearColor& color : renderImage(request).pixels) {
            within += color[0] == 0.25F ? 1 : 0;
            QVERIFY2(color[0] == 0.25F || color[0] == 1, qPrintable(QString::number(color[0])));
        }
        QVERIFY(within > 900);
    }

    void glassMirrorsAllLightBeyondTheAngle() {
        // The camera is in glass; the surface is turned by 60 degrees.
        const auto seen = [](const std::string& finish, const std::string& pigment, int angle) {
            return colorOf(
                "global_settings { assumed_gamma 1 } background { rgb 0.5 } plane { z, 0 pigment { " +
                pigment + " } finish { ambient 0 diffuse 0 " + finish + " } interior { ior 1.5 } rotate x*" +
                std::to_string(angle) +
                " } plane { z, 5 inverse no_reflection pigment { rgb 0.25 } finish { ambient 0 "
                "diffuse 0 emission 1 } }");
        };
        QVERIFY(close(seen("", "rgbt 1", 41), 0.25, 0.25, 0.25));
        QVERIFY(close(seen("", "rgbt 1", 42), 0.5, 0.5, 0.5));
        QVERIFY(close(seen("reflection 0.4", "rgbt 1", 30), 0.45, 0.45, 0.45));
        // All of it, whatever the finish and the pigment say.
        QVERIFY(close(seen("reflection 0.4", "rgbft <0.9, 0.5, 0.1, 0.2, 0.1>", 60), 0.5, 0.5, 0.5));
    }

    /// A material may hold the texture of the inside.
    void insidesAreSeenFromWithin() {
        const std::string rest = " finish { ambient 0 diffuse 0 emission 1 } } ";
        const auto seen = [&](const std::string& shape) {
            return colorOf("global_settings { assumed_gamma 1 } sphere { 0, " + shape +
                           " material { texture { pigment { rgb <1, 0, 0> }" + rest +
                           "interior_texture { pigment { rgb <0, 1, 0> }" + rest + "} }");
        };
        QVERIFY(close(seen("2"), 1, 0, 0));
        QVERIFY(close(seen("20"), 0, 1, 0));
    }

    /// What a union says of double_illuminate, its parts say, too.
    void aUnionIsLitFromBothSidesWithAllItsParts() {
        const auto lit = [](const std::string& flag) {
            return colorOf(
                "global_settings { assumed_gamma 1 } light_source { z*100 rgb 1 parallel point_at 0 } union "
                "{ "
                "disc { 0, z, 5 pigment { rgb 1 } finish { ambient 0 diffuse 1 } no_shadow } disc { 20*x, z, "
                "1 } " +
                flag + " }");
        };
        QVERIFY(close(lit(""), 0, 0, 0));
        QVERIFY(close(lit("double_illuminate"), 1, 1, 1));
    }

    void fadingWithoutAPowerDimsNoShadow() {
        const auto lit = [](const std::string& interior) {
            return colorOf(
                "global_settings { assumed_gamma 1 } light_source { -z*100 rgb 1 parallel point_at 0 } "
                "plane { -z, 0 pigment { rgb 1 } finish { ambient 0 diffuse 1 } } box { <-9, -9, -5>, "
                "<9, 9, -4> no_image pigment { rgbt 1 } interior { " +
                interior + " } }");
        };
        QVERIFY(close(lit("fade_distance 1 fade_power 1"), 0.5, 0.5, 0.5));
        QVERIFY(close(lit("fade_distance 1"), 1, 1, 1));
        QVERIFY(close(lit("fade_distance 1 fade_power 1000 fade_color rgb <0.9, 0.5, 0.1>"), std::exp(-0.1),
                      std::exp(-0.5), std::exp(-0.9)));
    }

    void bothCapsOfAPrismCanBeEntered() {
        // Their normals point the same way, so that these do not tell where the light comes from.
        const auto lit = [](const std::string& rotation) {
            return colorOf(
                "global_settings { assumed_gamma 1 } light_source { -z*100 rgb 1 parallel point_at 0 } "
                "plane { -z, 0 pigment { rgb 1 } finish { ambient 0 diffuse 1 } } prism { 0, 1, 5, "
                "<-9, -9>, <9, -9>, <9, 9>, <-9, 9>, <-9, -9> rotate x*" +
                rotation +
                " translate -4*z no_image pigment { rgbt 1 } interior { fade_distance 1 fade_power 1 "
                "} }");
        };
        QVERIFY(close(lit("90"), 0.5, 0.5, 0.5));
        QVERIFY(close(lit("-90"), 0.5, 0.5, 0.5));
    }

    void bumpyMirrorsDoNotShowWhatIsBehindThem() {
        const ParseResult parsed = parseScene(
            "#version 3.7; camera { location <0, 6, -15> look_at 10*y } plane { y, 10 pigment { rgb 0 } "
            "normal { "
            "bumps 0.5 } finish { reflection 1 } } plane { y, 20 pigment { rgb x } finish { emission 1 } }");
        const Image image = renderImage(requestFor(parsed, 64, 48));
        for (const LinearColor& color : image.pixels) QCOMPARE(color[0], 0.0F);
    }

    void fogEndsAtWhatIsNotHollow() {
        const std::string wall =
            "global_settings { assumed_gamma 1 } fog { distance 10 color rgb 1 } plane { -z, 0 "
            "hollow pigment { rgb 0 } finish { ambient 0 diffuse 0 } } ";
        const std::string box =
            "box { <-9, -9, -6>, <9, 9, -4> pigment { rgbt 1 } finish { ambient 0 diffuse 0 } ";
        const auto fog = [](double way) { return 1 - std::exp(-way / 10); };
        QVERIFY(close(colorOf(wall), fog(10), fog(10), fog(10)));
        QVERIFY(close(colorOf(wall + box + "hollow }"), fog(10), fog(10), fog(10)));
        QVERIFY(close(colorOf(wall + box + "}"), fog(8), fog(8), fog(8)));
        QVERIFY(close(colorOf(wall + "sphere { 0, 1000 pigment { rgb 0 } }"), 0, 0, 0));
        QVERIFY(
            close(colorOf(wall + "sphere { 0, 1000 hollow pigment { rgb 0 } }"), fog(10), fog(10), fog(10)));
    }

    void strangeNumbersMakePicturesAllTheSame() {
        for (const char* text :
             {"sphere { 0, 1 pigment { rgbt 1 } interior { ior 0 } }",
              "sphere { 0, 1 pigment { rgbt 1 } interior { ior -1 } }",
              "sphere { 0, 1 pigment { rgbt 1 } interior { ior 1e300 fade_distance 1e-300 fade_power 5 } }",
              "sphere { 0, 1 pigment { rgbt 1e300 } finish { reflection { -1, 1e300 falloff -4 } } }",
              "sphere { 0, 1 finish { reflection 0.5 reflection_exponent -2 } }",
              "fog { fog_type 2 distance 1e-300 fog_alt 0 up 0 rgb 1 } sphere { 0, 1 }",
              "fog { distance -1 rgb 1 } sphere { 0, 1 }",
              "fog { distance 3 turbulence 1e300 rgb 1 } sphere { 0, 1 }"}) {
            const RenderStatistics cost = costOf(view + text);
            QCOMPARE(raysOf(cost, StageKind::primaryRays), 64LL * 48);
        }
    }
};

QTEST_APPLESS_MAIN(SecondaryRaysTest)
#include "secondary_rays_test.moc"
