// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/text/diagnostic.h"

#include <QTest>

using namespace isoscope;

class DiagnosticTest : public QObject {
    Q_OBJECT

    static Diagnostic error(SourceRange range, std::vector<SourceRange> from = {}) {
        return {Severity::error, "id", range, "`x` is wrong.", "try `y`", std::move(from), {}};
    }
    static QString report(const Diagnostic& diagnostic, const SourceLibrary& sources) {
        return QString::fromStdString(toReport(diagnostic, sources));
    }

  private slots:
    void theLineIsShownWithThePlaceMarked() {
        SourceLibrary sources;
        sources.add("scene.pov", "one\n  sphere { foo, 1 }\n");
        QCOMPARE(report(error({0, 15, 18}), sources),
                 QString("scene.pov:2:12: error: `x` is wrong. (try `y`)\n"
                         "  2 |   sphere { foo, 1 }\n"
                         "    |            ^~~\n"));
    }

    void callsFollowWithTheirLines() {
        SourceLibrary sources;
        sources.add("scene.pov", "#include \"a.inc\"\nBall(3)\n");
        sources.add("a.inc", "#macro Ball(R)\n  foo\n#end\n");
        QCOMPARE(report(error({1, 17, 20}, {{0, 17, 24}}), sources),
                 QString("a.inc:2:3: error: `x` is wrong. (try `y`)\n"
                         "  2 |   foo\n"
                         "    |   ^~~\n"
                         "  in macro `Ball`, called at scene.pov:2:1\n"
                         "  2 | Ball(3)\n"
                         "    | ^~~~~~~\n"));
        QCOMPARE(QString::fromStdString(callText({0, 0, 16}, sources)), QString("included at"));
    }

    void aboutTheWholeTextNoLineIsShown() {
        SourceLibrary sources;
        sources.add("scene.pov", "one\n");
        QVERIFY(!report(error({}), sources).contains("|"));
    }

    void charactersAreCountedNotBytes() {
        SourceLibrary sources;
        sources.add("scene.pov", "ä\tb");
        QVERIFY(report(error({0, 3, 4}), sources).endsWith("  1 | ä\tb\n    |  \t^\n"));
    }

    void longLinesAreCutAndControlCharactersBlank() {
        SourceLibrary sources;
        sources.add("scene.pov", std::string(5000, 'a') + "\x1b" + std::string(5000, 'b'));
        const QStringList lines = report(error({0, 5000, 5003}), sources).split('\n');
        QVERIFY(lines[1].size() < 140);
        QVERIFY(!lines[1].contains(QChar(0x1b)));
        QCOMPARE(lines[2].indexOf('^'), lines[1].indexOf("a b") + 1);
        QVERIFY(lines[1].endsWith("b..."));
    }

    void placesAtTheEndAndBeyondAreSafe() {
        SourceLibrary sources;
        sources.add("scene.pov", "ab");
        QVERIFY(report(error({0, 2, 2}), sources).endsWith("  1 | ab\n    |   ^\n"));
        sources.add("empty", "");
        QVERIFY(!report(error({1, 0, 0}), sources).contains('|'));
        report(error({0, 700, 900}), sources);
        report(error({9, 1, 2}), sources);
    }

    void codeWords_data() {
        QTest::addColumn<QString>("message");
        QTest::addColumn<QString>("shown");
        QTest::newRow("none") << "plain"
                              << "plain";
        QTest::newRow("one") << "`a` is"
                             << "<a> is";
        QTest::newRow("two") << "`a` and `b c`"
                             << "<a> and <b c>";
        QTest::newRow("alone") << "it's ` here"
                               << "it's ` here";
        QTest::newRow("a backtick itself") << "found ```."
                                           << "found <`>.";
        QTest::newRow("at the end") << "`"
                                    << "`";
        QTest::newRow("nothing") << ""
                                 << "";
    }
    void codeWords() {
        QFETCH(QString, message);
        QFETCH(QString, shown);
        QCOMPARE(QString::fromStdString(withCodeWords(message.toStdString(), "<", ">")), shown);
    }
};

QTEST_APPLESS_MAIN(DiagnosticTest)
#include "diagnostic_test.moc"
