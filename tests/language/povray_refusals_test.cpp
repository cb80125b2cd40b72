// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/language/tokens/povray_refusals.h"

#include <QFile>
#include <QTest>

#include "core/language/parse.h"
#include "test_folders.h"
#include "tests/support/problems.h"

using namespace isoscope;

namespace {

const std::string declarations = R"(#version 3.7;
global_settings { assumed_gamma 1 }
#declare P0 = pigment { gradient x }
#declare T0 = texture { pigment { rgb 1 } }
#declare N0 = normal { bumps }
#declare F0 = finish { phong 1 }
#declare C0 = camera { location -z }
#declare L0 = light_source { 0, 1 }
#declare ISO = isosurface { function { x } }
#declare SPH = sphere { 0, 1 }
)";

bool isOf(const Diagnostic& diagnostic, Severity severity) { return diagnostic.severity == severity; }

}  // namespace

class PovrayRefusalsTest : public QObject {
    Q_OBJECT

  private slots:
    /// POV-Ray's answers, row by row: what it refuses is told of, and what it takes is not said to be
    /// refused.
    void whatPovrayRefusesIsTold_data() {
        QTest::addColumn<bool>("refused");
        QTest::addColumn<QString>("text");
        QFile table(ISOSCOPE_TEST_DATA "/language/povray_refusals.txt");
        QVERIFY(table.open(QIODevice::ReadOnly));
        while (!table.atEnd()) {
            const QString line = QString::fromUtf8(table.readLine()).trimmed();
            if (line.startsWith('#') || !line.contains(' ')) continue;
            const QString text = line.section(' ', 1);
            QTest::newRow(qPrintable(text)) << line.startsWith("refused") << text;
        }
    }

    void whatPovrayRefusesIsTold() {
        QFETCH(bool, refused);
        QFETCH(QString, text);
        const ParseResult parsed = parseScene(declarations + text.toStdString() + "\n");
        bool told = false, blamed = false;
        for (const Diagnostic& diagnostic : parsed.diagnostics) {
            const bool isError = isOf(diagnostic, Severity::error);
            told |= isError || isOf(diagnostic, Severity::warning);
            blamed |= isError || diagnostic.id == "povray-refuses";
        }
        QVERIFY2(refused ? told : !blamed, test::problems(parsed).c_str());
    }

    void theWarningStandsAtTheWordAndSaysWhatToDo() {
        const std::string text = "isosurface { function { x } translate x max_gradient 2 pigment { rgb 1 } }";
        const ParseResult parsed = parseScene(text);
        const auto found = std::ranges::find(parsed.diagnostics, "povray-refuses", &Diagnostic::id);
        QVERIFY(found != parsed.diagnostics.end());
        QCOMPARE(found->message,
                 std::string("POV-Ray wants `max_gradient` before textures, transformations and other "
                             "modifiers of an `isosurface`."));
        QCOMPARE(found->hint, std::string("move it in front of them"));
        QCOMPARE(found->range.begin, text.find("max_gradient"));
        // It counts all the same.
        QCOMPARE(parsed.scene->isosurfaces.at(0).shape->settings().maxGradient, 2.0);
    }

    void whatIsRefusedIsReadAllTheSame() {
        const ParseResult camera = parseScene(declarations + "camera { C0 location y } sphere { 0, 1 }");
        QCOMPARE(camera.scene->camera.location.y, 1.0);
        const ParseResult light = parseScene("light_source { 0, 1, parallel, shadowless } sphere { 0, 1 }");
        QVERIFY(light.scene->lights.at(0).shadowless &&
                light.scene->lights.at(0).kind == LightKind::parallel);
        const ParseResult flags = parseScene("sphere { 0, 1 hierarchy off split_union off sturm no_shadow }");
        QVERIFY(!flags.scene->objects.at(0).castsShadow);
        const ParseResult shadow = parseScene("sphere { 0, 1 no_shadow no_shadow off }");
        QVERIFY(shadow.scene->objects.at(0).castsShadow);
        const ParseResult noise = parseScene(
            "sphere { 0, 1 pigment { bozo noise_generator 7 } } sphere { 0, 1 pigment { bozo noise_generator "
            "-2 } }");
        const auto generator = [&](std::size_t object) {
            const MaterialId material = noise.scene->objects.at(object).material;
            const Pigment& pigment = noise.scene->materials.at(material).pigment;
            return std::get<std::shared_ptr<const MappedPigment>>(pigment)->pattern.noiseGenerator;
        };
        QCOMPARE(generator(0), 3);
        QCOMPARE(generator(1), 0);
    }

    /// They were taken for the nearest that there is, without a word.
    void numbersThatPatternsDoNotKnowAreTold() {
        const auto refusals = [](const std::string& pattern) {
            const ParseResult parsed = parseScene("sphere { 0, 1 pigment { " + pattern + " } }");
            return std::ranges::count(parsed.diagnostics, "povray-refuses", &Diagnostic::id);
        };
        for (const char* wrong : {"mandel 9 exterior 7, 1", "mandel 9 exterior -1, 1",
                                  "mandel 9 interior 7, 1", "magnet 3 mandel 9"})
            QVERIFY2(refusals(wrong) == 1, wrong);
        for (const char* right :
             {"mandel 9 exterior 6, 1 interior 6, 1", "mandel 9 exterior 1.5, 1", "magnet 2 mandel 9"})
            QVERIFY2(refusals(right) == 0, right);
        QVERIFY(!parseScene("sphere { 0, 1 pigment { bozo warp { repeat <1, 0.5, 0> } } }").ok());
        QVERIFY(!parseScene("sphere { 0, 1 pigment { bozo warp { planar 0, 1 } } }").ok());
    }

    void whatIsTooMuchOrMissingIsMendedByAClick() {
        const auto mended = [](const std::string& text) {
            const ParseResult parsed = parseScene(text);
            const auto found = std::ranges::find(parsed.diagnostics, "povray-refuses", &Diagnostic::id);
            if (found == parsed.diagnostics.end() || found->fixes.size() != 1) return std::string("no fix");
            const QuickFix& fix = found->fixes.front();
            return text.substr(0, fix.range.begin) + fix.replacement + text.substr(fix.range.end);
        };
        QCOMPARE(mended("sphere { 0, 1, pigment { rgb 1 } }"),
                 std::string("sphere { 0, 1 pigment { rgb 1 } }"));
        QCOMPARE(mended("isosurface { function { x }, max_gradient 2 }"),
                 std::string("isosurface { function { x } max_gradient 2 }"));
        QCOMPARE(mended("isosurface {\n  function { x }\n  pigment { rgb 1 }\n  max_gradient 2\n}"),
                 std::string("isosurface {\n  function { x }\n  max_gradient 2\n  pigment { rgb 1 }\n}"));
        QCOMPARE(mended("isosurface { function { x } pigment { rgb 1 } // red\n max_gradient 2 }"),
                 std::string("no fix"));
        QCOMPARE(
            mended("union { sphere { 0, 1 } rotate y translate x box { 0, 1 } pigment { rgb 1 } }"),
            std::string("union { sphere { 0, 1 } box { 0, 1 } rotate y translate x pigment { rgb 1 } }"));
        // What comes from a macro, or under a condition, stays where it is.
        QCOMPARE(mended("#macro P() pigment { rgb 1 } #end isosurface { function { x } P() max_gradient 2 }"),
                 std::string("no fix"));
        QCOMPARE(mended("isosurface { function { x } #if (1) pigment { rgb 1 } #end max_gradient 2 }"),
                 std::string("no fix"));
        QCOMPARE(mended("camera { location x, look_at 0 }"), std::string("camera { location x look_at 0 }"));
        QCOMPARE(mended("sphere { 0, 1 };"), std::string("sphere { 0, 1 }"));
        QCOMPARE(mended("sphere { 0, 1 pigment { <1, 0, 0> } }"),
                 std::string("sphere { 0, 1 pigment { rgb <1, 0, 0> } }"));
    }

    /// Before version 3.5 it was written anywhere.
    void theKindOfACameraStandsAnywhereInOldScenes() {
        const std::string camera = "camera { location -z*5 orthographic look_at 0 } sphere { 0, 1 }";
        const auto refusals = [](const ParseResult& parsed) {
            return std::ranges::count(parsed.diagnostics, "povray-refuses", &Diagnostic::id);
        };
        QCOMPARE(refusals(parseScene("#version 3.1; " + camera)), 0);
        QCOMPARE(refusals(parseScene("#version 3.7; " + camera)), 1);
    }
};

QTEST_APPLESS_MAIN(PovrayRefusalsTest)
#include "povray_refusals_test.moc"
