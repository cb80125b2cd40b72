// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QTemporaryDir>
#include <QTest>

#include "core/text/csv_table.h"
#include "tests/support/program.h"

using namespace isoscope;
using namespace isoscope::test;

namespace {

const QByteArray blobScene =
    "#version 3.7;\n\nisosurface {\n  function { 1 - exp(-2*(pow(x-0.8,2)+y*y+z*z)) - "
    "exp(-2*(pow(x+0.8,2)+y*y+z*z)) }\n  contained_by { box { -2, 2 } } threshold 0.3\n}\n"
    "isosurface { function { abs(x) + y*y + z*z } contained_by { sphere { 0, 1 } } }\n";

}  // namespace

class ThresholdsCommandTest : public QObject {
    Q_OBJECT

  private:
    QTemporaryDir folder_;

  private slots:
    void theTableHasOneRowForEachPoint() {
        const QString file = writeFile(folder_.path(), "s.pov", blobScene);
        const ProgramResult result = runCli({"thresholds", file});
        QCOMPARE(result.status, 0);
        QVERIFY2(result.errors.isEmpty(), result.errors);
        const isoscope::CsvTable rows = isoscope::CsvTable::parse(result.output.toStdString());
        const std::vector<std::string> header{"line", "value", "low",  "high",      "x",
                                              "y",    "z",     "kind", "certainty", "meaning"};
        QCOMPARE(rows.header(), header);
        QCOMPARE(rows.rowCount(), std::size_t(4));
        for (const std::size_t row : {0, 1}) {
            QCOMPARE(rows.field(row, "line"), std::string("3"));
            QCOMPARE(rows.field(row, "kind"), std::string("minimum"));
        }
        QCOMPARE(rows.field(2, "kind"), std::string("saddle-1"));
        QCOMPARE(rows.field(2, "certainty"), std::string("proven"));
        QCOMPARE(rows.field(2, "meaning"), std::string("two pieces join or a tunnel opens"));
        QVERIFY(std::abs(rows.number(2, "value", 9) - (1 - 2 * std::exp(-1.28))) < 1e-12);
        QVERIFY(rows.number(2, "low", 9) <= rows.number(2, "high", -9));
        QCOMPARE(rows.field(3, "line"), std::string("7"));
        QCOMPARE(rows.field(3, "certainty"), std::string("suspected-kink"));
    }

    void jsonTellsTheSame() {
        const QString file = writeFile(folder_.path(), "s.pov", blobScene);
        const ProgramResult result = runCli({"thresholds", file, "--json"});
        QCOMPARE(result.status, 0);
        const QJsonArray all = QJsonDocument::fromJson(result.output).array();
        QCOMPARE(all.size(), 2);
        const QJsonObject first = all[0].toObject();
        QCOMPARE(first["threshold"].toDouble(), 0.3);
        QVERIFY(first["finished"].toBool());
        const QJsonArray points = first["points"].toArray();
        QCOMPARE(points.size(), 3);
        QVERIFY(points[2].toObject()["proven"].toBool());
        const QJsonObject kink = all[1].toObject()["points"].toArray()[0].toObject();
        QVERIFY(!kink["proven"].toBool());
        QCOMPARE(kink["reason"].toString(), QString("kink"));
        QCOMPARE(kink["kind"].toString(), QString("minimum"));
    }

    void aSmallBudgetIsTold() {
        const QString file =
            writeFile(folder_.path(), "n.pov",
                      "#include \"functions.inc\"\nisosurface { function { f_noise3d(20*x,20*y,20*z) } "
                      "contained_by { box { -1, 1 } } }");
        const ProgramResult result = runCli({"thresholds", file, "--boxes", "1000"});
        QCOMPARE(result.status, 0);
        QVERIFY2(result.errors.contains("unfinished"), result.errors);
        QVERIFY(result.output.contains("suspected-unfinished"));
    }

    void aSceneWithoutIsosurfaceHasAnError() {
        QCOMPARE(runCli({"thresholds", writeFile(folder_.path(), "e.pov", "sphere { 0, 1 }")}).status, 1);
        QCOMPARE(runCli({"thresholds", folder_.filePath("missing.pov")}).status, 1);
        QCOMPARE(runCli({"thresholds"}).status, 2);
    }
};

QTEST_GUILESS_MAIN(ThresholdsCommandTest)
#include "thresholds_command_test.moc"
