// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/scene_picture.h"

using namespace isoscope;
using test::costOf, test::find, test::requestFor;

namespace {

constexpr double wantedShare = 0.99;

QDir folder() { return QDir(ISOSCOPE_TEST_DATA "/texture"); }

}  // namespace

class TexturePicturesTest : public QObject {
    Q_OBJECT

  private slots:
    void looksAsInPovray_data() { test::addScenes(folder()); }

    void looksAsInPovray() {
        if (!test::hasPovray()) QSKIP(test::povrayIsMissing);
        QFETCH(QString, name);
        const test::PictureDifference difference =
            test::differenceFromPovray(folder().filePath(name), "texture_" + name.chopped(4));
        QVERIFY(difference.shareWithin8 >= wantedShare);
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
