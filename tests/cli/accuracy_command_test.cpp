// SPDX-License-Identifier: GPL-3.0-or-later
#include <QFileInfo>
#include <QTemporaryDir>
#include <QTest>

#include "core/exchange/png.h"
#include "core/text/csv_table.h"
#include "tests/support/program.h"

using namespace isoscope;
using namespace isoscope::test;

namespace {

const QString sphere =
    "#version 3.7;\nglobal_settings { assumed_gamma 1 }\ncamera { location <0,0,-5> look_at 0 angle 30 }\n"
    "light_source { <5,5,-5> 1 }\n"
    "isosurface { function { x*x+y*y+z*z-1 } contained_by { sphere { 0, 1.2 } } %1 pigment { rgb 1 } }\n";

}  // namespace

class AccuracyCommandTest : public QObject {
    Q_OBJECT

  private slots:
    void everyValueIsMeasuredWithBothRootFinders() {
        QTemporaryDir folder;
        const QString file = writeFile(folder.path(), "s.pov", sphere.arg("max_gradient 2.4").toUtf8());
        const QString chart = folder.filePath("chart.png");
        const ProgramResult result = runCli({"accuracy", file, "--from", "1e-2", "--to", "1e-6", "--count",
                                             "3", "-W", "64", "-H", "48", "--plot", chart});
        QCOMPARE(result.status, 0);
        const isoscope::CsvTable rows = isoscope::CsvTable::parse(result.output.toStdString());
        QCOMPARE(rows.rowCount(), std::size_t(6));
        for (std::size_t row = 0; row < 6; ++row) {
            QCOMPARE(rows.field(row, "solver"), std::string(row % 2 == 0 ? "lipschitz" : "certified"));
            QCOMPARE(rows.number(row, "missed", 1), 0.0);
            QVERIFY(rows.number(row, "worst_error", 1) <= rows.number(row, "accuracy", 0) * 1.001);
        }
        QCOMPARE(readPng(chart.toStdString()).width, 640);
    }

    void maxGradientIsVariedAroundTheProvenBound() {
        QTemporaryDir folder;
        const QString file = writeFile(folder.path(), "s.pov", sphere.arg("max_gradient 2").toUtf8());
        const ProgramResult result = runCli(
            {"accuracy", file, "--max-gradient", "--count", "2", "--runs", "1", "-W", "40", "-H", "30"});
        QCOMPARE(result.status, 0);
        const isoscope::CsvTable rows = isoscope::CsvTable::parse(result.output.toStdString());
        QCOMPARE(rows.rowCount(), std::size_t(4));
        // A tenth to ten times a bound that is proven to 1 %: the gradient is 2.4 at the container's wall.
        const double low = rows.number(0, "max_gradient", 0), high = rows.number(2, "max_gradient", 0);
        QVERIFY(low >= 0.24 && low <= 0.2424 && high >= 24 && high <= 24.24);
        QVERIFY(rows.number(0, "missed", 0) > 100);
        QCOMPARE(rows.number(2, "missed", 1), 0.0);
    }

    void theKneeAndPovraysTimeAreTold() {
        QTemporaryDir folder;
        const QString file = writeFile(folder.path(), "s.pov", sphere.arg("max_gradient 2.4").toUtf8());
        const QStringList arguments{"accuracy", file, "--knee", "--max-gradient", "-W", "320", "-H", "240"};
        const ProgramResult result = runCli(arguments);
        QCOMPARE(result.status, 0);
        const isoscope::CsvTable rows = isoscope::CsvTable::parse(result.output.toStdString());
        QCOMPARE(rows.rowCount(), std::size_t(1));
        QCOMPARE(rows.number(0, "knee", 0), 10.0);
        QCOMPARE(rows.number(0, "lost", 1), 0.0);
        QVERIFY(rows.number(0, "povray_seconds", 0) > 0);
        QCOMPARE(rows.number(0, "error", 0), 0.5);
        // All but what was timed is the same on every run.
        const isoscope::CsvTable again = isoscope::CsvTable::parse(runCli(arguments).output.toStdString());
        for (const char* column : {"knee", "lost", "of_pixels", "evaluations_per_pixel", "products"})
            QCOMPARE(again.field(0, column), rows.field(0, column));
    }

    void wrongUsageIsRefused() {
        QTemporaryDir folder;
        const QString file = writeFile(folder.path(), "s.pov", sphere.arg("").toUtf8());
        QCOMPARE(runCli({"accuracy", file, "--from", "-1"}).status, 2);
        QCOMPARE(runCli({"accuracy", file, "--count", "0"}).status, 2);
        QCOMPARE(runCli({"accuracy", writeFile(folder.path(), "e.pov", "sphere { 0, 1 }")}).status, 1);
        QCOMPARE(runCli({"accuracy", file, "--count", "1", "--plot", folder.filePath("no/such.png"), "-W",
                         "8", "-H", "8"})
                     .status,
                 1);
    }

    void theHoleMapShowsWhatIsLost() {
        QTemporaryDir folder;
        const QString file = writeFile(folder.path(), "s.pov", sphere.arg("max_gradient 0.3").toUtf8());
        const QString map = folder.filePath("map.png");
        const ProgramResult result = runCli(
            {"render", file, "-o", folder.filePath("s.png"), "--hole-map", map, "-W", "80", "-H", "60"});
        QCOMPARE(result.status, 0);
        QVERIFY2(result.errors.contains("holes: ") && !result.errors.contains("holes: 0 lost"),
                 result.errors);
        const Image image = readPng(map.toStdString());
        QCOMPARE(image.width, 80);
        int red = 0;
        for (const auto& pixel : image.pixels) red += pixel[0] > 0.5f && pixel[1] < 0.2f;
        QVERIFY(red > 500);
    }
};

QTEST_GUILESS_MAIN(AccuracyCommandTest)
#include "accuracy_command_test.moc"
