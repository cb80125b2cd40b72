// SPDX-License-Identifier: GPL-3.0-or-later
// The commands that vary a number of a scene: sweep, sheet.
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QTemporaryDir>
#include <QTest>

#include "core/exchange/png.h"
#include "core/text/csv_table.h"
#include "tests/support/program.h"

using namespace isoscope;
using namespace isoscope::test;

namespace {

const QByteArray torusScene =
    "#version 3.7;\n#include \"functions.inc\"\ncamera { location <0, 2, -4> look_at 0 angle 40 }\n"
    "light_source { <4, 6, -5> rgb 1 }\n#declare R = 0.6;\nisosurface {\n"
    "  function { f_torus(x, y, z, R, 0.2) }\n  contained_by { box { -1.5, 1.5 } }\n  max_gradient 1.2\n"
    "  pigment { rgb 1 }\n}\n";

}  // namespace

class SweepCommandTest : public QObject {
    Q_OBJECT

  private:
    QTemporaryDir folder_;
    QString scene_;

  private slots:
    void initTestCase() { scene_ = writeFile(folder_.path(), "s.pov", torusScene); }

    void sweepTellsTunnels() {
        const ProgramResult result = runCli(
            {"sweep", scene_, "--parameter", "R", "--from", "0", "--to", "0.8", "--steps", "3", "-W", "40"});
        QCOMPARE(result.status, 0);
        QVERIFY2(result.errors.isEmpty(), result.errors);
        const isoscope::CsvTable rows = isoscope::CsvTable::parse(result.output.toStdString());
        QCOMPARE(rows.rowCount(), std::size_t(3));
        QCOMPARE(rows.number(1, "value", 9), 0.4);
        // A ball, then rings.
        QCOMPARE(rows.field(0, "tunnels"), std::string("0"));
        for (const std::size_t row : {1, 2}) QCOMPARE(rows.field(row, "tunnels"), std::string("1"));
        for (const std::size_t row : {0, 1, 2}) {
            QCOMPARE(rows.field(row, "pieces"), std::string("1"));
            QVERIFY(rows.number(row, "povray_evaluations", 0) > 0);
        }
    }

    void jsonTellsTheSame() {
        const ProgramResult result =
            runCli({"sweep", scene_, "--parameter", "f_torus minor radius", "--steps", "2", "--json"});
        QCOMPARE(result.status, 0);
        const QJsonArray points = QJsonDocument::fromJson(result.output).array();
        QCOMPARE(points.size(), 2);
        QVERIFY(points[0].toObject()["gradient_high"].toDouble() >= 1);
    }

    void aNumberThatIsNotThereIsAnError() {
        const ProgramResult result = runCli({"sweep", scene_, "--parameter", "nothing"});
        QCOMPARE(result.status, 1);
        QVERIFY(result.errors.contains("no number is called `nothing`; there are: R"));
    }

    void sheetDrawsOneOrTwoNumbers() {
        const QString file = folder_.filePath("sheet.png");
        const ProgramResult result = runCli({"sheet",
                                             scene_,
                                             "-o",
                                             file,
                                             "--parameter",
                                             "R",
                                             "--from",
                                             "0.3",
                                             "--to",
                                             "0.9",
                                             "--steps",
                                             "3",
                                             "--second",
                                             "Minor Radius",
                                             "--second-from",
                                             "0.05",
                                             "--second-to",
                                             "0.2",
                                             "--second-steps",
                                             "2",
                                             "-W",
                                             "60",
                                             "-H",
                                             "40"});
        QCOMPARE(result.status, 0);
        const isoscope::CsvTable rows = isoscope::CsvTable::parse(result.output.toStdString());
        QCOMPARE(rows.rowCount(), std::size_t(6));
        QCOMPARE(rows.field(4, "row") + rows.field(4, "column"), std::string("11"));
        QCOMPARE(rows.number(4, "second", 9), 0.2);
        const Image picture = readPng(file.toStdString());
        QCOMPARE(picture.width, 3 * 64 - 4);
        QCOMPARE(picture.height, 2 * (40 + 7 + 4) - 4);
        const auto lit = [&](int left, int top) {
            int count = 0;
            for (int y = 0; y < 40; ++y)
                for (int x = 0; x < 60; ++x)
                    count +=
                        picture.pixels[static_cast<std::size_t>((top + y) * picture.width + left + x)][0] >
                                0.05f
                            ? 1
                            : 0;
            return count;
        };
        // Thicker and larger rings fill more.
        QVERIFY(lit(0, 0) > 0 && lit(0, 51) > lit(0, 0) && lit(128, 51) > lit(0, 51));
        const ProgramResult again = runCli({"sheet", scene_, "-o", file, "--parameter", "R", "--steps", "5",
                                            "--columns", "5", "-W", "40", "-H", "30", "--force"});
        QCOMPARE(again.status, 0);
        QCOMPARE(readPng(file.toStdString()).width, 5 * 44 - 4);
        QCOMPARE(readPng(file.toStdString()).height, 37);
    }

    void sheetsThatAreTooLargeAreRefused() {
        const QString file = folder_.filePath("huge.png");
        const ProgramResult result = runCli(
            {"sheet", scene_, "-o", file, "--parameter", "R", "--steps", "900", "-W", "4000", "-H", "4000"});
        QCOMPARE(result.status, 2);
        QVERIFY(result.errors.contains("100 million"));
        QVERIFY(!QFile::exists(file));
    }
};

QTEST_MAIN(SweepCommandTest)
#include "sweep_command_test.moc"
