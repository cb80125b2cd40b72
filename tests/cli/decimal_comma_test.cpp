// SPDX-License-Identifier: GPL-3.0-or-later
#include <QTest>

#include "core/exchange/pov_export.h"
#include "core/language/parse.h"
#include "core/text/csv_table.h"
#include "core/text/number_format.h"
#include "tests/support/comma_locale.h"

using namespace isoscope;
using namespace isoscope::test;

/// Numbers have a point wherever the program runs. The window's process has the system's locale, for Qt asks
/// for it: `str` and `#write` once gave POV-Ray 1,5 there, and 0.4 in a table was no number.
class DecimalCommaTest : public QObject {
    Q_OBJECT

    std::unique_ptr<CommaLocale> locale_;

    static QString written(const char* text) {
        const ParseResult parsed = parseScene("#fopen F \"a.txt\" write #write (F, " + std::string(text) +
                                              ") #fclose F sphere { 0, 1 }");
        return parsed.writtenFiles.empty() ? "(none)"
                                           : QString::fromStdString(parsed.writtenFiles.begin()->second);
    }

  private slots:
    void initTestCase() {
        locale_ = std::make_unique<CommaLocale>();
        if (!locale_->valid())
            QSKIP("NOT TESTED: no German locale can be made, see Debian's package locales");
        QCOMPARE(QString::asprintf("%.1f", 1.5), QString("1.5"));  // Qt's own
        char text[8];
        std::snprintf(text, sizeof text, "%.1f", 1.5);
        QCOMPARE(text, "1,5");
    }
    void cleanupTestCase() { locale_.reset(); }

    void stringsOfNumbersHaveAPoint() {
        QCOMPARE(written("str(1.5, 0, 2)"), QString("1.50"));
        QCOMPARE(written("str(-1.5, -8, 2), \"|\", str(-1.5, 8, 2)"), QString("-0001.50|   -1.50"));
        QCOMPARE(written("vstr(2, <0.5, 2.25>, \";\", 0, 2)"), QString("0.50;2.25"));
        QCOMPARE(written("0.1, \" \", 1.5e300, \" \", <1.5, -2, 0.25>"),
                 QString("0.1 1.5e+300 <1.5,-2,0.25> "));
    }

    void textsAndTablesAreReadWithAPoint() {
        const ParseResult parsed = parseScene("#declare A = 1.5; sphere { 0, A } #debug str(A, 0, 1)");
        QVERIFY(parsed.ok());
        QCOMPARE(std::get<NumberValue>(parsed.symbols->find("A")->data).value, 1.5);
        const CsvTable table = CsvTable::parse("a,b,c\n0.4,\"0,4\",-1.25e-3\n");
        QCOMPARE(table.number(0, "a", 0), 0.4);
        QVERIFY(std::isnan(table.number(0, "b", 0)));
        QCOMPARE(table.number(0, "c", 0), -1.25e-3);
    }

    void exportedScenesHaveAPoint() {
        const std::string text = "camera { location <0.5, 0.25, -4> look_at 0.5 angle 40 } sphere { 0, 1.5 }";
        ParseResult parsed = parseScene(text);
        Camera camera = parsed.scene->camera;
        camera.location.x += 0.125;
        const std::string exported = exportScene(*parsed.scene, camera, text, 160, 120);
        QVERIFY2(exported.find("0.625") != std::string::npos, exported.c_str());
        QVERIFY2(parseScene(exported).ok(), exported.c_str());
    }

    void theCommandLineAnswersAsElsewhere() {
        QTemporaryDir folder;
        const QString table = writeFile(folder.path(), "table.csv", "expression,x,y,z\nx*1.5,0.5,0,0\n");
        const ProgramResult result = runCli({"evaluate", "--table", table});
        QVERIFY2(result.output.contains("0.75"), result.output + result.errors);
    }
};

QTEST_GUILESS_MAIN(DecimalCommaTest)
#include "decimal_comma_test.moc"
