// SPDX-License-Identifier: GPL-3.0-or-later
// What a scene asks for and the picture does not show is named, with its place; nothing else is.
#include <algorithm>
#include <QFile>
#include <QTemporaryDir>
#include <QTest>

#include "core/language/parse.h"
#include "tests/support/problems.h"

using namespace isoscope;
using test::complaints, test::has, test::problems;

namespace {

const char* const ball = "isosurface { function { x*x + y*y + z*z - 1 } contained_by { sphere { 0, 1.2 } } ";

}  // namespace

class LeftOutTest : public QObject {
    Q_OBJECT

  private slots:
    void leavesOutAnOperandThatIsNotDrawn() {
        const ParseResult parsed =
            parseScene(std::string("intersection { ovus { 1, 0.2 } ") + ball + "} sphere { 0, 1 } }\n" +
                       "difference { ovus { 1, 0.2 } sphere { 0, 1 } }");
        QVERIFY(parsed.ok());
        QCOMPARE(parsed.scene->isosurfaces.size(), std::size_t(1));
        QCOMPARE(parsed.scene->objects.size(), std::size_t(1));
        TraceContext context;
        QVERIFY(parsed.scene->objects[0].shape->contains({0, 0, 0}, context));
        QCOMPARE(std::count_if(parsed.diagnostics.begin(), parsed.diagnostics.end(),
                               [](const Diagnostic& d) { return d.severity == Severity::leftOut; }),
                 3);
    }

    void namesWhatItLeavesOut() {
        const ParseResult parsed = parseScene(std::string(R"(global_settings { radiosity { count 10 } }
fog { distance 10 rgb 1 }
sky_sphere { pigment { rgb 1 } }
light_source { 1, 1 area_light x, y, 4, 4 adaptive 1 jitter circular orient }
lemon { "A}{" 1, 0 }
)") + ball +
                                              "interior { ior 1.5 "
                                              "} normal { projection } finish { subsurface { 1 } } }");
        QVERIFY2(parsed.ok(), problems(parsed).c_str());
        const std::vector<std::string> expected{
            "`radiosity` is not simulated: light that objects throw on each other is missing. [radiosity]",
            "`lemon` is not drawn yet. [lemon { \"A}{\" 1, 0 }]",
        };
        const std::vector<std::string> all = complaints(parsed);
        for (const std::string& sentence : expected)
            QVERIFY2(std::find(all.begin(), all.end(), sentence) != all.end(), sentence.c_str());
        for (const char* part : {"`projection` is not simulated.", "`subsurface` is not simulated"})
            QVERIFY2(std::any_of(all.begin(), all.end(),
                                 [&](const std::string& s) { return s.starts_with(part); }),
                     part);
        QCOMPARE(parsed.scene->isosurfaces.size(), std::size_t(1));
    }

    void settingsOfAnImageAreNotTakenForItsPattern() {
        const QTemporaryDir folder;
        QFile image(folder.filePath("a.pgm"));
        QVERIFY(image.open(QIODevice::WriteOnly));
        image.write("P5 1 1 255\nA");
        image.close();
        ParseOptions options;
        options.file = folder.filePath("scene.pov").toStdString();
        const ParseResult parsed =
            parseScene("sphere { 0, 1 pigment { image_map { pgm \"a.pgm\" map_type 3 } } }", options);
        QVERIFY2(parsed.ok(), problems(parsed).c_str());
        QVERIFY2(complaints(parsed).size() == 1, problems(parsed).c_str());
        QVERIFY(complaints(parsed)[0].starts_with("`map_type` is not simulated. ["));
    }

    /// It was drawn as one colour.
    void pavementIsDrawnWithSharpCorners() {
        const auto complain = [](const std::string& modifiers) {
            return complaints(parseScene("sphere { 0, 1 pigment { pavement " + modifiers + " scale 2 } }"));
        };
        QCOMPARE(complain("number_of_sides 4 number_of_tiles 3 pattern 2 exterior 0 interior 3 form 0"),
                 std::vector<std::string>{});
        const std::vector<std::string> rounded = complain("number_of_tiles 4 interior 2");
        QCOMPARE(rounded.size(), std::size_t{1});
        QVERIFY2(rounded.at(0).find("its corners are sharp.") != std::string::npos, rounded.at(0).c_str());
    }
    void pavementsThatDoNotExistAreToldWithTheNearest() {
        const ParseResult parsed =
            parseScene("sphere { 0, 1 pigment { pavement number_of_sides 6 number_of_tiles 6 } }");
        QVERIFY(parsed.ok());
        QVERIFY2(problems(parsed).find("number_of_sides 6 number_of_tiles 5 pattern 1") != std::string::npos,
                 problems(parsed).c_str());
    }

    void namesNoEffectOfLightThatIsShown() {
        const ParseResult parsed = parseScene(
            "#declare Mirror = finish { reflection 0.5 crand 0.1 }\n"
            "sphere { 0, 1 pigment { rgbt <1, 1, 1, 0.5> } finish { Mirror } interior { ior 1.5 } }");
        QVERIFY2(parsed.ok(), problems(parsed).c_str());
        QVERIFY2(!has(parsed, Severity::leftOut, "left-out"), problems(parsed).c_str());
    }

    void placesOnParametricsAreNamedAsLeftOut() {
        const std::string shape =
            "parametric { function { u } function { v } function { 0 } <0, 0>, <1, 1> contained_by { box { "
            "-2, 2 } "
            "}";
        const ParseResult parsed = parseScene(shape + " texture { uv_mapping pigment { checker } } }");
        QCOMPARE(complaints(parsed),
                 std::vector<std::string>{"`uv_mapping` looks otherwise than in POV-Ray here: on a "
                                          "`parametric` it takes x and y in place of u and v. [texture { "
                                          "uv_mapping pigment { checker } }]"});
        QVERIFY(complaints(parseScene(shape + " pigment { checker } }")).empty());
    }
};

QTEST_APPLESS_MAIN(LeftOutTest)
#include "left_out_test.moc"
