// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/exchange/isosurface_export.h"

#include <QDir>
#include <QFile>
#include <QTemporaryDir>
#include <QTest>

using namespace isoscope;

namespace {

const std::string ball = "isosurface { function { x*x + y*y + z*z - R } }";

IsosurfaceExport exported(const std::string& text, std::size_t index = 0, ParseOptions options = {}) {
    return exportIsosurface(parseScene(text, std::move(options)), index);
}

}  // namespace

class IsosurfaceExportTest : public QObject {
    Q_OBJECT

    QTemporaryDir folder_;

    ParseResult parsedWith(const std::string& text, const QList<std::pair<QString, std::string>>& files) {
        for (const auto& [name, content] : files) {
            QFile file(folder_.filePath(name));
            if (!file.open(QIODevice::WriteOnly)) return {};
            file.write(QByteArray::fromStdString(content));
        }
        ParseOptions options;
        options.file = folder_.filePath("scene.pov").toStdString();
        return parseScene(text, options);
    }

  private slots:
    void takesItsDeclarationsAlong() {
        const std::string iso = "isosurface { function { F(x, y, z) - R } texture { T() } }";
        const std::string declarations =
            "#declare K = 2;\n#declare R = K/2;\n#declare F = function { f_sphere(x, y, z, K) }\n"
            "#declare Red = <1, 0, 0>;\n#macro T() pigment { rgb Red } #end\n";
        const std::string text =
            "#version 3.7;\n#include \"functions.inc\"\ncamera { location 0 }\n#declare Unused = 5;\n" +
            declarations + "sphere { 0, R }\n" + iso + "\n#declare R = 99;";
        const IsosurfaceExport block = exported(text);
        QCOMPARE(block.problem, std::string());
        QCOMPARE(block.text, "#version 3.7;\n#include \"functions.inc\"\n" + declarations + iso + "\n");
    }

    void findsWhatStandsInsideOfBlocks() {
        const std::string iso = "isosurface { function { x - A - B } }";
        const std::string text =
            "#declare A = 1;\n#if (A > 0) #local B = 2; #local C = 3; union { sphere { 0, C } " + iso +
            " } #end";
        QCOMPARE(exported(text).text, "#declare A = 1;\n#local B = 2;\n" + iso + "\n");
    }

    /// A bug once: the variable of the loop was left behind.
    void variablesOfLoopsBecomeNumbers() {
        const std::string iso = "isosurface { function { x - I } }";
        const std::string inFor = "#for (I, 1, 3) " + iso + " #end";
        QCOMPARE(exported(inFor, 0).text, "#local I = 1;\n" + iso + "\n");
        QCOMPARE(exported(inFor, 2).text, "#local I = 3;\n" + iso + "\n");
        const std::string inWhile = "#declare I = 1; #while (I < 4) " + iso + " #declare I = I + 1; #end";
        QCOMPARE(exported(inWhile, 0).text, "#declare I = 1;\n" + iso + "\n");
        QCOMPARE(exported(inWhile, 2).text, "#local I = 3;\n" + iso + "\n");
    }

    void parametersOfMacrosBecomeNumbers() {
        const std::string iso = "isosurface { function { F(x, y, z) - R } pigment { color C } }";
        const std::string f = "#declare F = function { x*x + y*y + z*z }\n";
        const std::string text =
            "#macro Ball(R, C) " + iso + " #end\n" + f + "Ball(0.5, rgb <1, 0.5, 0>)\nBall(2, rgb 1)\n";
        QCOMPARE(exported(text, 0).text,
                 "#local C = rgbft <1, 0.5, 0, 0, 0>;\n#local R = 0.5;\n" + f + iso + "\n");
        QCOMPARE(exported(text, 1).text,
                 "#local C = rgbft <1, 1, 1, 0, 0>;\n#local R = 2;\n" + f + iso + "\n");
    }

    void numbersThatChangeLaterAreThoseOfTheStatement() {
        QCOMPARE(exported("#declare R = 1; #declare R = R/4; " + ball + " #declare R = 7;").text,
                 "#declare R = 1;\n#declare R = R/4;\n" + ball + "\n");
    }

    void numbersFromOutsideAreWritten() {
        ParseOptions options;
        options.declarations["R"] = 0.3;
        QCOMPARE(exported(ball, 0, options).text, "#local R = 0.3;\n" + ball + "\n");
    }

    /// A bug once: a statement in an include file gave nothing.
    void aStatementInAnIncludeFileStandsOnItsOwn() {
        const ParseResult parsed = parsedWith(
            "#declare R = 0.5;\n#declare G = function { x*R }\n#include \"ball.inc\"\n",
            {{"ball.inc", "#declare Q = 2;\nisosurface { function { G(x, y, z) - Q } }\n#declare Q = 3;"}});
        QVERIFY(parsed.ok());
        QCOMPARE(exportIsosurface(parsed, 0).text,
                 std::string("#declare R = 0.5;\n#declare G = function { x*R }\n#declare Q = 2;\n"
                             "isosurface { function { G(x, y, z) - Q } }\n"));
    }

    void declarationsOfOwnIncludeFilesAreCopiedNotIncluded() {
        const ParseResult parsed = parsedWith(
            "#include \"colors.inc\"\n#include \"parts.inc\"\n" + ball,
            {{"parts.inc", "#include \"more.inc\"\nsphere { 0, R }\n"}, {"more.inc", "#declare R = 0.7;"}});
        QVERIFY(parsed.ok());
        QCOMPARE(exportIsosurface(parsed, 0).text,
                 "#include \"colors.inc\"\n#declare R = 0.7;\n" + ball + "\n");
    }

    void aMacroOfAnIncludeFileUsesWhatWasDeclaredLater() {
        const ParseResult parsed =
            parsedWith("#include \"macros.inc\"\n#declare F = function { x*x + y*y + z*z }\nBall(0.5)\n",
                       {{"macros.inc", "#macro Ball(R) isosurface { function { F(x, y, z) - R } } #end\n"}});
        QVERIFY(parsed.ok());
        QCOMPARE(exportIsosurface(parsed, 0).text,
                 std::string("#local R = 0.5;\n#declare F = function { x*x + y*y + z*z }\n"
                             "isosurface { function { F(x, y, z) - R } }\n"));
    }

    /// The function declared in each round is another one, of which the text has only one.
    void whatCannotStandAloneIsSaid() {
        const std::string text =
            "#declare I = 0;\n#declare F = function { x }\n#while (I < 3)\n"
            "isosurface { function { F(x, y, z) - 0.1 } }\n#declare F = function { F(x, y, z)*2 + I }\n"
            "#declare I = I + 1;\n#end\n";
        const ParseResult parsed = parseScene(text);
        QCOMPARE(parsed.scene->isosurfaces.size(), std::size_t{3});
        QVERIFY(exportIsosurface(parsed, 0).problem.empty());
        const IsosurfaceExport third = exportIsosurface(parsed, 2);
        QVERIFY(third.text.empty());
        QVERIFY2(third.problem.find("line 4") != std::string::npos, third.problem.c_str());
    }

    void theNoiseGeneratorOfTheSceneIsKeptInMind() {
        const std::string iso = "isosurface { function { f_noise3d(x, y, z) - 0.5 } }";
        const std::string text = "#include \"functions.inc\"\nglobal_settings { noise_generator 1 }\n" + iso;
        QCOMPARE(exported(text).text, "#include \"functions.inc\"\n" + iso + "\n");
    }

    void wrongNumbersAreSaid() {
        const std::string text = "isosurface { function { x } }";
        QCOMPARE(exported(text).text, text + "\n");
        QVERIFY(exported(text, 1).text.empty());
        QVERIFY(!exported(text, 1).problem.empty());
        QVERIFY(!exportIsosurface(ParseResult(), 0).problem.empty());
    }
};

QTEST_APPLESS_MAIN(IsosurfaceExportTest)
#include "isosurface_export_test.moc"
