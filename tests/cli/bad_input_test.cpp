// SPDX-License-Identifier: GPL-3.0-or-later
#include <QRandomGenerator>
#include <QRegularExpression>
#include <QTemporaryDir>
#include <QTest>

#include "tests/support/program.h"

using namespace isoscope::test;

/// Whatever is typed ends in a diagnostic with line and column, soon, and without a crash.
class BadInputTest : public QObject {
    Q_OBJECT

  private:
    QTemporaryDir folder_;

  private slots:
    void isDiagnosed_data() {
        QTest::addColumn<QByteArray>("text");
        QTest::newRow("open brace") << QByteArray("isosurface { function { x*x");
        QTest::newRow("closing brace") << QByteArray("sphere { 0, 1 } } } }");
        QTest::newRow("unknown name") << QByteArray("isosurface { function { f_tours(x,y,z,1,2) } }");
        QTest::newRow("argument count") << QByteArray("isosurface { function { f_sphere(x,y,z) } }");
        QTest::newRow("recursive macro") << QByteArray("#macro M(N) M(N+1) #end\nM(0)\n");
        QTest::newRow("recursive function") << QByteArray("#declare F = function(x,y,z) { F(x,y,z) }\n");
        QTest::newRow("endless while") << QByteArray("#while (1)\n#declare A = 1;\n#end\n");
        QTest::newRow("endless empty while") << QByteArray("#while (1) #end\n");
        QTest::newRow("endless for") << QByteArray("#for (I, 0, 1e18) #end\n");
        QTest::newRow("deep parentheses") << QByteArray("#declare A = " + QByteArray(200000, '(') + ";\n");
        QTest::newRow("deep braces") << QByteArray("union " + QByteArray(200000, '{'));
        QTest::newRow("deep unions") << QByteArray("union { ").repeated(100000);
        QTest::newRow("long sum") << QByteArray("#declare A = 1" + QByteArray("+1").repeated(300000) + "\n}");
        QTest::newRow("doubling function") << [] {
            QByteArray text = "#declare F0 = function(x,y,z) { sin(x*y+z) }\n";
            for (int i = 1; i < 60; ++i)
                text += QByteArray("#declare F%1 = function(x,y,z) { F%2(sin(x+y),y,z)*F%2(x,cos(x*y),z) }\n")
                            .replace("%1", QByteArray::number(i))
                            .replace("%2", QByteArray::number(i - 1));
            return text + "isosurface { function { F59(x,y,z) } }\n";
        }();
        QTest::newRow("self include") << QByteArray("#include \"self include.pov\"\n");
        QTest::newRow("unterminated string") << QByteArray("#declare A = \"abc\n");
        QTest::newRow("unterminated comment") << QByteArray("/* /* */ sphere { 0, 1 }");
        QTest::newRow("huge array") << QByteArray("#declare A = array[1000000][1000000];\n");
        QTest::newRow("string that doubles") << QByteArray(
            "#declare S = \"x\";\n#declare I = 0;\n#while (I < 100)\n#declare S = concat(S, S);\n"
            "#declare I = I + 1;\n#end\n");
    }

    void isDiagnosed() {
        QFETCH(QByteArray, text);
        const QString name = QString::fromLatin1(QTest::currentDataTag()) + ".pov";
        const ProgramResult result = runCli({"check", writeFile(folder_.path(), name, text)}, 20);
        QVERIFY2(result.status == 1,
                 "status " + QByteArray::number(result.status) + ": " + result.errors.left(500));
        static const QRegularExpression place(R"(\.pov:\d+:\d+: error: .+)");
        QVERIFY2(place.match(QString::fromUtf8(result.errors)).hasMatch(), result.errors.left(500));
        QVERIFY(result.errors.size() < 200000);
    }

    /// F3: an empty scene, or one that is a comment, passed without a word.
    void F3ASceneOfNothingIsTold() {
        for (const char* text : {"", "// only a comment\n", "#declare A = 1;\n"}) {
            const ProgramResult scene = runCli({"check", writeFile(folder_.path(), "nothing.pov", text)});
            QCOMPARE(scene.status, 0);
            QVERIFY2(scene.errors.contains("nothing.pov: note: the scene has no object"), scene.errors);
            const ProgramResult include = runCli({"check", writeFile(folder_.path(), "nothing.inc", text)});
            QCOMPARE(include.status, 0);
            QVERIFY2(!include.errors.contains("no object"), include.errors);
        }
    }

    /// 1 MB of random bytes, and of random tokens, which go deeper into the parser.
    void randomTextDoesNoHarm() {
        const quint32 seed = QRandomGenerator::global()->generate();
        qInfo("seed %u", seed);
        QRandomGenerator random(seed);
        QByteArray bytes(1 << 20, Qt::Uninitialized);
        for (char& byte : bytes) byte = static_cast<char>(random.bounded(256));
        const QList<QByteArray> words{"isosurface",
                                      "function",
                                      "{",
                                      "}",
                                      "(",
                                      ")",
                                      "<",
                                      ">",
                                      ",",
                                      "#declare",
                                      "#if",
                                      "#end",
                                      "#while",
                                      "#macro",
                                      "A",
                                      "B",
                                      "=",
                                      "1",
                                      "0.5",
                                      "x",
                                      "+",
                                      "*",
                                      "/",
                                      "union",
                                      "pigment",
                                      "rgb",
                                      "translate",
                                      "\"s\"",
                                      ";",
                                      "camera",
                                      "#for",
                                      "array",
                                      "[",
                                      "]",
                                      "#else",
                                      "#local",
                                      "f_torus",
                                      "texture",
                                      "finish",
                                      "sphere",
                                      "light_source",
                                      "object",
                                      "#include",
                                      "#switch",
                                      "#case",
                                      "#break",
                                      "select",
                                      "sum",
                                      "#undef",
                                      "?",
                                      ":"};
        QByteArray tokens;
        while (tokens.size() < (1 << 20))
            tokens += words[random.bounded(words.size())] + (random.bounded(20) ? " " : "\n");
        for (const auto& [name, text] : {std::pair{"bytes.pov", bytes}, std::pair{"tokens.pov", tokens}}) {
            const ProgramResult result = runCli({"check", writeFile(folder_.path(), name, text)}, 60);
            QVERIFY2(result.status == 1, name + QByteArray(" ") + result.errors.left(300));
        }
    }
};

QTEST_GUILESS_MAIN(BadInputTest)
#include "bad_input_test.moc"
