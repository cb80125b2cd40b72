// SPDX-License-Identifier: GPL-3.0-or-later
#include "test_folders.h"
#include "tests/support/scene_picture.h"

using namespace isoscope;
using test::costOf, test::find, test::requestFor;

namespace {

constexpr double wantedShare = 0.99;

QDir folder() { return QDir(ISOSCOPE_TEST_DATA "/texture"); }

}  // namespace

class TexturePicturesTest : public QObject {
    Q_OBJECT

    /// Both pictures, of a camera that looks at the origin.
    template <class Agree>
    void compare(const QString& scene, Agree agree) {
        if (!test::hasPovray()) QSKIP(test::povrayIsMissing);
        const std::string text =
            "#version 3.7; global_settings { assumed_gamma 1 }"
            "camera { location -3*z look_at 0 }" +
            scene.toStdString();
        const ParseResult parsed = parseScene(text);
        QVERIFY2(parsed.ok(), test::problems(parsed).c_str());
        QVERIFY(agree(test::comparePictures(renderImage(requestFor(parsed)), test::povrayPicture(text, {}))));
    }

    /// To the last step of every pixel.
    void compareWhole(const QString& scene) {
        compare(scene, [](const test::PictureDifference& found) { return found.largest <= 1; });
    }

  private slots:
    void looksAsInPovray_data() { test::addScenes(folder()); }

    void looksAsInPovray() {
        if (!test::hasPovray()) QSKIP(test::povrayIsMissing);
        QFETCH(QString, name);
        const test::PictureDifference difference =
            test::differenceFromPovray(folder().filePath(name), "texture_" + name.chopped(4));
        QVERIFY(difference.shareWithin8 >= wantedShare);
    }

    /// It was 1 - filter - transmit for all versions.
    void oldVersionsShowMoreOfWhatFilters_data() {
        QTest::addColumn<QString>("texture");
        QTest::newRow("plain") << "pigment { rgbf <0.8, 0.4, 0.2, 0.6> }";
        QTest::newRow("both") << "pigment { rgbft <0.8, 0.4, 0.2, 0.5, 0.3> }";
        QTest::newRow("map")
            << "pigment { gradient y color_map { [0 rgbf <0.8, 0.4, 0.2, 1>] [1 rgbf 0.9] } }";
        QTest::newRow("layers") << "texture { pigment { rgb <0, 0, 1> } }"
                                   "texture { pigment { rgbf <0.8, 0.4, 0.2, 0.5> } }";
        QTest::newRow("clear layers") << "texture { pigment { rgbf <0.1, 0.2, 0.9, 0.7> } }"
                                         "texture { pigment { rgbf <0.8, 0.4, 0.2, 0.5> } }";
    }
    void oldVersionsShowMoreOfWhatFilters() {
        if (!test::hasPovray()) QSKIP(test::povrayIsMissing);
        QFETCH(QString, texture);
        const auto scene = [&](const char* version) {
            return std::string("#version ") + version +
                   "; global_settings { assumed_gamma 1 } camera { location -3*z look_at 0 }"
                   "light_source { <-9, 9, -9>, 1 } plane { -y, 2 pigment { rgb 1 } } background { rgb 0.3 }"
                   "sphere { 0, 1 " +
                   texture.toStdString() + " }";
        };
        const auto ours = [&](const char* version) {
            return renderImage(requestFor(parseScene(scene(version))));
        };
        const Image theirs = test::povrayPicture(scene("3.6"), {});
        test::keepPictures("filter_" + QString(QTest::currentDataTag()).replace(' ', '_'), ours("3.6"),
                           theirs);
        QVERIFY(test::comparePictures(ours("3.6"), theirs).shareWithin8 >= wantedShare);
        // What is tested makes a difference.
        QVERIFY(test::comparePictures(ours("3.7"), theirs).shareWithin8 < 0.9);
    }

    /// They were as dark as the pigment is clear.
    void highlightsOfClearMetalsAreWhole_data() {
        QTest::addColumn<QString>("texture");
        const QString metal = "finish { ambient 0 diffuse 0 specular 0.5 roughness 0.2 metallic }",
                      clear = "pigment { rgbf <0.5, 0.2, 0.9, 0.7> }" + metal,
                      green = "pigment { rgbt <0.2, 0.9, 0.3, 0.5> }" + metal;
        QTest::newRow("plain") << "texture { " + clear + " }";
        QTest::newRow("patterned")
            << "texture { pigment { checker rgbt <0.5, 0.2, 0.9, 0.4>, rgbf <0.2, 1, 0.5, 0.6> scale 0.2 }" +
                   metal + " }";
        QTest::newRow("layers") << "texture { " + clear + " } texture { " + green + " }";
        QTest::newRow("map") << "texture { gradient x texture_map { [0 " + clear + "] [1 " + green + "] } }";
        QTest::newRow("phong") << "texture { pigment { rgbf <0.5, 0.2, 0.9, 0.7> } finish { phong 0.8 "
                                  "phong_size 5 metallic 0.6 } }";
    }
    void highlightsOfClearMetalsAreWhole() {
        if (!test::hasPovray()) QSKIP(test::povrayIsMissing);
        QFETCH(QString, texture);
        const std::string text =
            "#version 3.7; global_settings { assumed_gamma 1 } camera { location -4*z look_at 0 }"
            "light_source { <-20, 30, -40>, 1 } background { rgb 0.2 } box { -1, 1 rotate <20, 30, 0> " +
            texture.toStdString() + " }";
        const ParseResult parsed = parseScene(text);
        QVERIFY2(parsed.ok(), test::problems(parsed).c_str());
        QVERIFY(test::comparePictures(renderImage(requestFor(parsed)), test::povrayPicture(text, {}))
                    .shareWithin8 >= wantedShare);
    }

    /// It was as bright as without `transmit`.
    void backgroundsAreDarkerByWhatTheyTransmit_data() {
        QTest::addColumn<QString>("scene");
        const QString clear = "background { rgbft <0.3, 0.2, 0.1, 0.5, 0.25> }";
        QTest::newRow("alone") << clear;
        QTest::newRow("wholly clear") << "background { rgbt <0.3, 0.2, 0.1, 1> }";
        QTest::newRow("behind a sky") << clear + "sky_sphere { pigment { rgbft <1, 0.8, 0.5, 0.4, 0.3> } }";
        QTest::newRow("in a mirror")
            << clear + "plane { z, 1 pigment { rgb 1 } finish { ambient 0 diffuse 0 reflection 0.5 } }";
        QTest::newRow("through glass")
            << clear + "plane { z, 1 pigment { rgbt <1, 1, 1, 0.6> } finish { ambient 0 diffuse 0 } }";
    }
    void backgroundsAreDarkerByWhatTheyTransmit() {
        QFETCH(QString, scene);
        compareWhole(scene);
    }

    /// Only the union's own texture was. Those of the parts move with it, before they are laid.
    /// What such surfaces return was 0, and so the mirrored light and what shines through came whole.
    void negativeColoursTakeLightAway_data() {
        QTest::addColumn<QString>("texture");
        QTest::newRow("mirror") << "pigment { rgb <1, 0.5, -1> } finish { ambient 0 reflection 0.3 }";
        QTest::newRow("clear") << "pigment { rgbt <1, 0.5, -0.2, 0.5> }";
        QTest::newRow("pattern") << "pigment { gradient y color_map { [0 rgb <1, 0.5, -1>] [1 rgb -x] } } "
                                    "finish { reflection 0.3 phong 1 metallic }";
        QTest::newRow("film") << "pigment { rgb 1 } finish { ambient 0.1 irid { 20 thickness 1 } }";
        QTest::newRow("negative diffuse")
            << "pigment { rgb <1, 0.5, -1> } finish { diffuse -0.5 reflection 0.3 }";
        QTest::newRow("more than clear") << "pigment { rgbt <1, 0.5, 0.2, 1.5> }";
    }
    void negativeColoursTakeLightAway() {
        QFETCH(QString, texture);
        compareWhole("background { rgb <0.2, 0.3, 0.4> } light_source { <-2, 3, -4>, 1 } sphere { 0, 1 " +
                     texture + " }");
    }

    void texturesOfPartsAreLaidOnTheirSurfaces_data() {
        QTest::addColumn<QString>("object");
        const QString cone = "cone { -0.7*x, 0.3, 0.8*x, 0.4 texture { T } %1 }",
                      ball = "sphere { 0.6*y, 0.4 }";
        const auto row = [](const QString& object) { QTest::newRow(qPrintable(object)) << object; };
        row("union { " + cone.arg("") + ball + " uv_mapping texture { T } }");
        row("union { " + cone.arg("rotate 20") + ball +
            " translate 0.1 uv_mapping texture { T } rotate 30 }");
        row("difference { " + cone.arg("scale 1.2") + ball + " uv_mapping texture { T } rotate 40*y }");
        row("union { union { " + cone.arg("") + ball + " uv_mapping translate 0.1 } rotate 10 scale 0.9 }");
        row("#declare U = union { " + cone.arg("") + ball + " } object { U uv_mapping texture { T } }");
        row("union { cone { -0.7*x, 0.3, 0.8*x, 0.4 uv_mapping texture { T rotate 20*z } } " + ball +
            " uv_mapping texture { T } rotate 30 }");
    }
    void texturesOfPartsAreLaidOnTheirSurfaces() {
        QFETCH(QString, object);
        // But for single pixels of their edges.
        compare(
            "light_source { <-20, 30, -40>, 1 } #declare T = texture { pigment { bozo scale 0.15 color_map { "
            "[0 rgb 1] [1 rgb x] } } }" +
                object,
            [](const test::PictureDifference& found) { return found.shareWithin8 > 0.999; });
    }

    /// Slopes were 0.5 where there is no surface.
    void skiesHaveNoSlope_data() {
        QTest::addColumn<QString>("pigment");
        const QString colors = " color_map { [0 rgb <0.2, 0, 0.1>] [1 rgb 1] }";
        const QString altitude = "slope { y altitude z }" + colors;
        for (const QString& pigment : {"slope <1, 2, 3>" + colors, "aoi turbulence 1" + colors, altitude,
                                       "gradient y pigment_map { [0 slope y] [1 aoi" + colors + "] }"})
            QTest::newRow(qPrintable(pigment)) << pigment;
    }
    void skiesHaveNoSlope() {
        QFETCH(QString, pigment);
        compareWhole(
            "sphere { 0, 1 pigment { rgb 0 } finish { ambient 0 diffuse 0 reflection 1 } }"
            "sky_sphere { pigment { " +
            pigment + " } }");
    }

    /// They were left out.
    void cutsShowTheTexturesOfTheirInside_data() {
        QTest::addColumn<QString>("object");
        QTest::addColumn<bool>("shows");
        const QString red = "pigment { rgb <1, 0.1, 0.1> }", wood = "pigment { wood scale 0.2 }",
                      cutter = "box { -4, <4, 4, 0> }";
        const auto row = [](const char* name, const QString& object, bool shows = true) {
            QTest::newRow(name) << object << shows;
        };
        row("one texture", "difference { box { -1, 1 " + red + " } " + cutter + " cutaway_textures }");
        row("patterns", "difference { sphere { 0, 1 " + wood + " } " + cutter +
                            " cutaway_textures rotate 20*y translate 0.1 }");
        row("intersection",
            "intersection { sphere { 0, 1 " + wood + " rotate 30 } plane { -z, 0 } cutaway_textures }");
        row("two at once", "difference { union { box { -1, 1 " + red + " } sphere { 0, 0.7 " + wood +
                               " } } " + cutter + " cutaway_textures }");
        row("a part without", "difference { union { box { -1, 1 " + red + " } box { -0.5, 0.5 } } " + cutter +
                                  " cutaway_textures }");
        row("cutter of two", "difference { sphere { 0, 1 " + wood + " } union { " + cutter +
                                 " sphere { y, 0.5 } } cutaway_textures }");
        row("nested", "difference { difference { box { -1, 1 " + red + " } sphere { 1, 1 " + wood + " } } " +
                          cutter + " cutaway_textures }");
        row("inverse", "intersection { box { -1, 1 " + red + " } plane { -z, 0 } sphere { 9, 1 inverse " +
                           wood + " } cutaway_textures }");
        row("in a bounded union", "union { difference { box { -1, 1 " + red + " } " + cutter +
                                      " cutaway_textures } sphere { 2*x, 1 } bounded_by { box { -9, 9 } } }");
        row("textured whole", "difference { sphere { 0, 1 } " + cutter + " cutaway_textures " + wood + " }",
            false);
        row("textured cutter",
            "difference { sphere { 0, 1 " + red + " } box { -4, <4, 4, 0> " + wood + " } cutaway_textures }",
            false);
    }
    void cutsShowTheTexturesOfTheirInside() {
        if (!test::hasPovray()) QSKIP(test::povrayIsMissing);
        QFETCH(QString, object);
        QFETCH(bool, shows);
        const QString scene =
            "#version 3.7; global_settings { assumed_gamma 1 } camera { location <1, 1, -3.5> look_at 0 }"
            "light_source { <-9, 9, -9>, 1 } #default { pigment { rgb <1, 1, 0> } }" +
            object;
        const ParseResult parsed = parseScene(scene.toStdString());
        QVERIFY2(parsed.diagnostics.empty(), test::problems(parsed).c_str());
        const Image ours = renderImage(requestFor(parsed)),
                    theirs = test::povrayPicture(scene.toStdString(), {});
        test::keepPictures("cutaway_" + QString(QTest::currentDataTag()).replace(' ', '_'), ours, theirs);
        QVERIFY(test::comparePictures(ours, theirs).shareWithin8 >= wantedShare);
        const std::string without = QString(scene).remove("cutaway_textures").toStdString();
        const double same =
            test::comparePictures(ours, renderImage(requestFor(parseScene(without)))).shareWithin8;
        QCOMPARE(same < 0.99, shows);
    }

    /// POV-Ray draws them black, but for a few points.
    void cutsWithinCutawaysHaveTheDefaultTexture() {
        const auto picture = [](const std::string& words) {
            return renderImage(requestFor(
                parseScene("camera { location <1, 1, -3.5> look_at 0 } light_source { <-9, 9, -9>, 1 }"
                           "#default { pigment { rgb <1, 1, 0> } } difference { difference { box { -1, 1 "
                           "pigment { rgb x } }"
                           "box { -4, <4, 4, 0> } } sphere { 9, 1 } " +
                           words + " }")));
        };
        QVERIFY(picture("cutaway_textures").pixels == picture("").pixels);
        const ParseResult part = parseScene(
            "merge { sphere { 3, 1 } difference { box { -1, 1 pigment { rgb x } } sphere { 1, 1 } "
            "cutaway_textures } }");
        QVERIFY2(
            test::problems(part).find("`cutaway_textures` of a part is not simulated") != std::string::npos,
            test::problems(part).c_str());
    }

    void constantPigmentsCostNothing() {
        const RenderStatistics plain = costOf("sphere { 0, 1 pigment { rgb 0.5 } } light_source { -9, 1 }");
        QVERIFY(!find(plain, StageKind::textures));
        // A map that says the same everywhere is a constant too.
        const RenderStatistics same = costOf(
            "sphere { 0, 1 pigment { wood color_map { [0 rgb 1] [1 rgb 1] } } } light_source { -9, 1 }");
        QVERIFY(!find(same, StageKind::textures));
        QCOMPARE(same.evaluations, plain.evaluations);
    }

    void patternsAreLookedUpWhereTheyAreSeen() {
        const RenderStatistics cost = costOf(
            "camera { orthographic location -5*z look_at 0 right 4*x up 4*y }"
            "sphere { -x, 0.8 pigment { granite } } sphere { x, 0.8 pigment { rgb 1 } } light_source { -9, 1 "
            "}");
        const StageReport* stage = find(cost, StageKind::textures);
        QVERIFY(stage);
        QCOMPARE(stage->reason, std::string("materials with 1 pattern"));
        // The spheres look the same: half of the hits are on the first.
        QVERIFY(cost.verdicts.at("hit") > 1000);
        QCOMPARE(2 * stage->evaluations, cost.verdicts.at("hit"));
    }

    void withoutTexturesPatternsAreEvenlyGreyAndSmooth() {
        const auto pictureOf = [](const std::string& texture, bool textures) {
            const ParseResult scene = parseScene(
                "camera { location -3*z look_at 0 } light_source { -9, 1 } sphere { 0, 1 " + texture + " }");
            RenderRequest request = requestFor(scene);
            request.leftOut.set(StageKind::textures, !textures);
            return renderImage(request).pixels;
        };
        const auto grey = pictureOf("pigment { rgb 0.7 } finish { phong 1 }", true);
        QVERIFY(pictureOf("pigment { granite } normal { bumps } finish { phong 1 }", false) == grey);
        QVERIFY(pictureOf("pigment { granite } normal { bumps } finish { phong 1 }", true) != grey);
        QVERIFY(pictureOf("pigment { rgb 0.7 } finish { phong 1 }", false) == grey);
    }

    void partsOfTexturesAreNotCountedAsPixels() {
        const RenderStatistics cost = costOf(
            "camera { location -3*z look_at 0 } light_source { -9, 1 }"
            "sphere { 0, 1 texture { pigment { rgb 1 } } texture { pigment { granite color_map {"
            "[0 rgb 0] [1 rgbt 1] } } } }");
        QVERIFY(find(cost, StageKind::textures));
        QCOMPARE(cost.verdicts.at("hit") + cost.verdicts.at("miss"), std::uint64_t(160 * 120));
    }

    void imagesAreFoundWithoutTheirEnding() {
        ParseOptions options;
        options.file = folder().filePath("scene.pov").toStdString();
        for (const char* image : {"png \"image\"", "\"image\"", "png \"image.png\""}) {
            const ParseResult scene =
                parseScene("sphere { 0, 1 pigment { image_map { " + std::string(image) + " } } }", options);
            QVERIFY2(scene.ok(), test::problems(scene).c_str());
        }
        QVERIFY(!parseScene("sphere { 0, 1 pigment { image_map { gif \"image\" } } }", options).ok());
    }

    void imagesThatAreMissingAreNamed() {
        const ParseResult scene =
            parseScene("sphere { 0, 1 pigment { image_map { png \"no such file.png\" } } }");
        QVERIFY(!scene.ok());
        QCOMPARE(scene.diagnostics.front().id, std::string("no-file"));
        QCOMPARE(scene.diagnostics.front().message, std::string("There is no file `no such file.png`."));
    }

    void hugePigmentsAreRefused() {
        std::string text = "#declare P = pigment { gradient x }\n";
        for (int k = 0; k < 40; ++k)
            text += "#declare P = pigment { gradient y pigment_map { [0 P] [1 P scale 2] } }\n";
        const ParseResult scene = parseScene(text + "sphere { 0, 1 pigment { P } }");
        QVERIFY(!scene.ok());
        QCOMPARE(scene.diagnostics.front().id, std::string("too-large"));
    }

    void manyLayersDoNotEatTheMemory() {
        const auto layers = [](int count) {
            std::string text = "camera { location -4*z look_at 0 } sphere { 0, 1 ";
            for (int k = 0; k < count; ++k) text += "texture { pigment { granite } }\n";
            return parseScene(text + "}");
        };
        QVERIFY(layers(200).ok());
        const ParseResult refused = layers(201);
        QVERIFY(!refused.ok());
        QCOMPARE(refused.diagnostics.front().message,
                 std::string("More than 200 layers and parts of this texture lie over one another."));
        // A map shows two of its textures at a time, an average all of them.
        std::string entries;
        for (int k = 0; k < 201; ++k) entries += "[" + std::to_string(k) + " pigment { granite }]\n";
        QVERIFY(parseScene("sphere { 0, 1 texture { gradient y texture_map {" + entries + "} } }").ok());
        QVERIFY(!parseScene("sphere { 0, 1 texture { average texture_map {" + entries + "} } }").ok());
    }

    void hugeTexturesAreRefused() {
        std::string text = "#declare T = texture { pigment { granite } }\n";
        for (int k = 0; k < 40; ++k) text += "#declare T = texture { T } texture { T }\n";
        const ParseResult layers = parseScene(text + "sphere { 0, 1 texture { T } }");
        QVERIFY(!layers.ok());
        QCOMPARE(layers.diagnostics.front().id, std::string("too-large"));
        text = "#declare T = texture { pigment { granite } }\n";
        for (int k = 0; k < 60; ++k)
            text += "#declare T = texture { gradient y texture_map { [0 T] [1 pigment { rgb 1 }] } }\n";
        QVERIFY(!parseScene(text + "sphere { 0, 1 texture { T } }").ok());
        text = "#declare N = normal { granite }\n";
        for (int k = 0; k < 40; ++k)
            text += "#declare N = normal { gradient y normal_map { [0 N] [1 N] } }\n";
        QVERIFY(!parseScene(text + "sphere { 0, 1 normal { N } }").ok());
    }
};

QTEST_APPLESS_MAIN(TexturePicturesTest)
#include "texture_pictures_test.moc"
