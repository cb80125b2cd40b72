// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <QFile>
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

const QByteArray ball =
    "#version 3.7;\nglobal_settings { assumed_gamma 1 }\ncamera { location <0,0,-5> look_at 0 angle 30 }\n"
    "light_source { <5,5,-5> 1 }\n"
    "isosurface { function { x*x+y*y+z*z-1 } contained_by { sphere { 0, 1.2 } } max_gradient 2.4 pigment { "
    "rgb 1 } }\n";

QJsonObject jsonIn(const QString& file) {
    QFile json(file);
    return json.open(QIODevice::ReadOnly) ? QJsonDocument::fromJson(json.readAll()).object() : QJsonObject();
}

}  // namespace

/// What a picture takes, told before it is drawn, and pixel by pixel.
class PictureCostTest : public QObject {
    Q_OBJECT

  private slots:
    void theCostMapAddsUpToTheStatistics() {
        QTemporaryDir folder;
        const QString file = writeFile(folder.path(), "s.pov", ball);
        const QString map = folder.filePath("cost.png"), counts = folder.filePath("c.json");
        const ProgramResult result = runCli({"render", file, "-o", folder.filePath("s.png"), "-W", "80", "-H",
                                             "60", "--cost-map", map, "--statistics", counts});
        QCOMPARE(result.status, 0);
        QCOMPARE(readPng(map.toStdString()).width, 80);
        const QJsonObject json = jsonIn(counts), cost = json["cost"].toObject();
        double sum = 0;
        const QJsonObject causes = cost["causes"].toObject();
        QCOMPARE(causes.size(), 5);
        for (const QString& cause : causes.keys()) sum += causes[cause].toDouble();
        QVERIFY(sum > 0);
        QCOMPARE(cost["evaluations"].toDouble(), sum);
        double primary = 0;
        for (const QJsonValue& stage : json["stages"].toArray())
            if (stage["name"].toString() == QStringLiteral("primary rays"))
                primary = stage["evaluations"].toDouble();
        QCOMPARE(sum, primary);
        QVERIFY2(result.errors.contains("grazing ray"), result.errors.constData());
        // Without being asked, nothing is counted by cause.
        QCOMPARE(runCli({"render", file, "-o", folder.filePath("s.png"), "-W", "80", "-H", "60",
                         "--statistics", counts})
                     .status,
                 0);
        QVERIFY(!jsonIn(counts).contains("cost"));
    }

    void theTimeIsToldForBothPrograms() {
        QTemporaryDir folder;
        const QString file = writeFile(folder.path(), "s.pov", ball);
        const ProgramResult result =
            runCli({"predict", file, "-W", "200", "-H", "150", "--threads", "1", "--check"});
        QCOMPARE(result.status, 0);
        const CsvTable rows = CsvTable::parse(result.output.toStdString());
        QCOMPARE(rows.rowCount(), std::size_t(2));
        QCOMPARE(rows.field(0, "program"), std::string("isoscope"));
        QCOMPARE(rows.field(1, "program"), std::string("povray"));
        const double told = rows.number(0, "processor_seconds", 0),
                     measured = rows.number(0, "measured_processor_seconds", 0);
        QVERIFY(told > 0 && measured > 0);
        QCOMPARE(rows.number(0, "seconds", 0), told);
        QVERIFY(std::abs(rows.number(0, "off", 9) - (told / measured - 1)) < 1e-9);
        QCOMPARE(rows.number(0, "squares", 0), 35.0);
        QVERIFY(rows.number(0, "error", 0) >= 0.1 && rows.number(1, "error", 0) == 0.5);
        QVERIFY(rows.number(1, "processor_seconds", 0) > 0);
        QCOMPARE(runCli({"predict", file, "-W", "0"}).status, 2);
        QCOMPARE(runCli({"predict", writeFile(folder.path(), "e.pov", "#version 3.7;\n")}).status, 1);
    }
};

QTEST_APPLESS_MAIN(PictureCostTest)
#include "picture_cost_test.moc"
