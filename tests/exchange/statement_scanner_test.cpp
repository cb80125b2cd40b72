// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/exchange/statement_scanner.h"

#include <QTest>
#include <random>

using namespace isoscope;

namespace {

std::vector<std::string> pieceTexts(const std::string& text) {
    std::vector<std::string> result;
    for (const ScenePiece& piece : scanPieces(text))
        result.push_back(text.substr(piece.begin, piece.end - piece.begin));
    return result;
}

using Texts = std::vector<std::string>;

}  // namespace

class StatementScannerTest : public QObject {
    Q_OBJECT

  private slots:
    void cutsAtTheOutermostLevel() {
        QCOMPARE(pieceTexts("#version 3.7;\n#include \"functions.inc\"\n#declare R = 2;\n"
                            "sphere { 0, R pigment { rgb 1 } }\nbox{-1,1}"),
                 (Texts{"#version 3.7;", "#include \"functions.inc\"", "#declare R = 2;",
                        "sphere { 0, R pigment { rgb 1 } }", "box{-1,1}"}));
    }

    void severalDirectivesOnALine() {
        QCOMPARE(pieceTexts("#version 3.7; #include \"a.inc\" #declare A = 1; #declare B = A;"),
                 (Texts{"#version 3.7;", "#include \"a.inc\"", "#declare A = 1;", "#declare B = A;"}));
    }

    void declarationsMayEndWithoutSemicolon() {
        QCOMPARE(
            pieceTexts(
                "#declare F = function { x + 1 }\n#declare T = texture { pigment { rgb 1 } }\nsphere{0,1}"),
            (Texts{"#declare F = function { x + 1 }", "#declare T = texture { pigment { rgb 1 } }",
                   "sphere{0,1}"}));
        QCOMPARE(pieceTexts("#declare F = function(a, b) { a*b };\n#declare N = 3\n#declare M = 4;"),
                 (Texts{"#declare F = function(a, b) { a*b };", "#declare N = 3", "#declare M = 4;"}));
    }

    void blocksStayWhole() {
        const std::string loop =
            "#declare F = function { 0\n #declare I = 0; #while (I < 3) + I*x #declare I = I + 1; #end }";
        QCOMPARE(pieceTexts(loop + "\nsphere{0,1}"), (Texts{loop, "sphere{0,1}"}));
        const std::string macro = "#macro M(a)\n #if (a) sphere{0,a} #else #declare Q = 1; #end\n#end";
        QCOMPARE(pieceTexts("#declare A=1; " + macro + " M(2)"), (Texts{"#declare A=1;", macro, "M(2)"}));
    }

    void commentsAndStringsAreNoStructure() {
        QCOMPARE(pieceTexts("/* sphere { /* nested */ #declare X = 1; */ #declare S = \"} #end \\\" {\";\n// "
                            "#end }\nbox{-1,1}"),
                 (Texts{"#declare S = \"} #end \\\" {\";", "box{-1,1}"}));
        QCOMPARE(identifiersIn("a + b1 /* c */ // d\n \"e\" f_torus"),
                 (std::set<std::string>{"a", "b1", "f_torus"}));
    }

    void knowsWhatIsDeclared() {
        const auto pieces = scanPieces("#declare A = B; #macro M(c) #local L = 1; #end");
        QCOMPARE(pieces[0].declared, std::set<std::string>{"A"});
        QVERIFY(pieces[0].used.contains("B"));
        QCOMPARE(pieces[1].declared, (std::set<std::string>{"L", "M"}));
    }

    void anyBytesComeToAnEnd() {
        const unsigned seed = 4711;
        std::mt19937 random(seed);
        const std::string signs = "{}#\"/*\n\\; aifdend_declare1";
        for (int i = 0; i < 3000; ++i) {
            std::string text;
            for (unsigned k = random() % 60; k > 0; --k) text += signs[random() % signs.size()];
            std::size_t end = 0;
            for (const ScenePiece& piece : scanPieces(text)) {
                QVERIFY2(piece.begin >= end && piece.end > piece.begin && piece.end <= text.size(),
                         qPrintable(QString("seed %1, text: ").arg(seed) + QString::fromStdString(text)));
                end = piece.end;
            }
        }
    }
};

QTEST_APPLESS_MAIN(StatementScannerTest)
#include "statement_scanner_test.moc"
