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

const QByteArray scene =
    "#version 3.7;\nglobal_settings { assumed_gamma 1 }\ncamera { location <0,0,-5> look_at 0 }\n"
    "light_source { <5,5,-5> 1 }\n"
    "isosurface { function { x*x+y*y+z*z-1 } contained_by { sphere { 0, 1.2 } } %1 pigment { rgb 1 } }\n";

isoscope::CsvTable rowsOf(const ProgramResult& result) {
    return isoscope::CsvTable::parse(result.output.toStdString());
}

}  // namespace

class GradientCommandTest : public QObject {
    Q_OBJECT

  private slots:
    void aTableIsAnsweredRowByRow() {
        QTemporaryDir folder;
        const QString file = writeFile(folder.path(), "t.csv",
                                       "function,container\n"
                                       "\"x*x+y*y+z*z-1\",\"sphere{<0,0,0>,1.2}\"\n"
                                       "1/x,\"box{<-1,-1,-1>,<1,1,1>}\"\n"
                                       "x+,\"box{<-1,-1,-1>,<1,1,1>}\"\n"
                                       "x,\"cone{<-1,-1,-1>,<1,1,1>}\"\n");
        const ProgramResult result = runCli({"gradient", "--table", file});
        QCOMPARE(result.status, 1);
        QCOMPARE(result.errors.count("error:"), 2);
        const isoscope::CsvTable rows = rowsOf(result);
        const std::vector<std::string> header{"sampled", "lower",     "upper",   "x",      "y",
                                              "z",       "suggested", "verdict", "seconds"};
        QCOMPARE(rows.header(), header);
        QCOMPARE(rows.rowCount(), std::size_t(4));
        QCOMPARE(rows.number(0, "suggested", 0), 2.4);
        QCOMPARE(rows.field(0, "verdict"), std::string("proven"));
        QCOMPARE(rows.field(1, "lower"), std::string("inf"));
        QCOMPARE(rows.field(1, "verdict"), std::string("unbounded-pole"));
        QVERIFY(std::abs(rows.number(1, "x", 1)) < 1e-9);
        QCOMPARE(rows.field(2, "verdict"), std::string("error"));
    }

    void aSettingIsJudged_data() {
        QTest::addColumn<QString>("setting");
        QTest::addColumn<QString>("verdict");
        QTest::newRow("missing") << ""
                                 << "holes";
        QTest::newRow("low") << "max_gradient 2"
                             << "holes";
        QTest::newRow("right") << "max_gradient 2.4"
                               << "right";
        QTest::newRow("high") << "max_gradient 20"
                              << "wasteful";
    }

    void aSettingIsJudged() {
        QFETCH(QString, setting);
        QFETCH(QString, verdict);
        QTemporaryDir folder;
        const QString file = writeFile(folder.path(), "s.pov", QString(scene).arg(setting).toUtf8());
        const ProgramResult result = runCli({"gradient", "--check", file});
        QCOMPARE(result.status, verdict == "holes" ? 1 : 0);
        QCOMPARE(rowsOf(result).field(0, "verdict"), verdict.toStdString());
    }

    void jsonSaysTheSameAndMore() {
        QTemporaryDir folder;
        const QString file = writeFile(folder.path(), "t.csv",
                                       "function,container\n"
                                       "\"x*x+y*y+z*z-1\",\"sphere{<0,0,0>,1.2}\"\n"
                                       "1/(x-0.5),\"box{<-1,-1,-1>,<1,1,1>}\"\n"
                                       "x+,\"box{<-1,-1,-1>,<1,1,1>}\"\n");
        const ProgramResult result = runCli({"gradient", "--json", "--table", file});
        QCOMPARE(result.status, 1);
        const QJsonArray all = QJsonDocument::fromJson(result.output).array();
        QCOMPARE(all.size(), 3);
        const QJsonObject sphere = all[0].toObject(), pole = all[1].toObject(), bad = all[2].toObject();
        QCOMPARE(sphere["suggested"].toDouble(), 2.4);
        QCOMPARE(sphere["state"].toString(), QStringLiteral("proven"));
        QVERIFY(sphere["singularity"].isNull());
        QVERIFY(sphere["lower"].toDouble() <= 2.4 && sphere["upper"].toDouble() >= 2.4);
        QVERIFY(pole["upper"].isNull() && pole["suggested"].isNull());
        const QJsonObject singularity = pole["singularity"].toObject();
        QCOMPARE(singularity["kind"].toString(), QStringLiteral("pole"));
        QVERIFY(std::abs(singularity["place"].toArray()[0].toDouble() - 0.5) < 1e-9);
        QVERIFY(!singularity["advice"].toString().isEmpty());
        // A plane's distance from the pole is at least that of a cell: 1/32.
        const QJsonObject beside = pole["beside"].toObject();
        QVERIFY(beside["upper"].toDouble() >= beside["lower"].toDouble() &&
                beside["upper"].toDouble() < 32 * 32 * 1.02);
        QCOMPARE(beside["reach"].toDouble(), 1.0 / 32);
        QVERIFY(beside["share"].toDouble() > 0 && beside["share"].toDouble() < 0.1);
        QVERIFY(sphere["beside"].isNull());
        QCOMPARE(bad["verdict"].toString(), QStringLiteral("error"));
        QVERIFY(!bad["problem"].toString().isEmpty());
    }

    void jsonOfASceneNamesTheSetting() {
        QTemporaryDir folder;
        const QString file =
            writeFile(folder.path(), "s.pov", QString(scene).arg(QStringLiteral("max_gradient 2")).toUtf8());
        const ProgramResult result = runCli({"gradient", "--json", "--check", file});
        QCOMPARE(result.status, 1);
        const QJsonObject surface = QJsonDocument::fromJson(result.output).array()[0].toObject();
        QCOMPARE(surface["max_gradient"].toDouble(), 2.0);
        QCOMPARE(surface["verdict"].toString(), QStringLiteral("holes"));
    }

    void aDeclaredObjectIsFoundInsideOthers() {
        QTemporaryDir folder;
        const QString file = writeFile(
            folder.path(), "s.inc",
            "#declare Thing = difference { isosurface { function { 3*x } contained_by { box { -1, 1 } } }\n"
            "  isosurface { function { 4*y } } rotate 30*x }\n");
        const ProgramResult result = runCli({"gradient", file, "--object", "Thing"});
        QCOMPARE(result.status, 0);
        const isoscope::CsvTable rows = rowsOf(result);
        QCOMPARE(rows.rowCount(), std::size_t(2));
        QCOMPARE(rows.number(0, "suggested", 0), 3.0);
        QCOMPARE(rows.number(1, "suggested", 0), 4.0);
    }

    void wrongUsageIsRefused() {
        QTemporaryDir folder;
        const QString file = writeFile(folder.path(), "s.pov", QString(scene).arg("").toUtf8());
        QCOMPARE(runCli({"gradient"}).status, 2);
        QCOMPARE(runCli({"gradient", file, "--table", file}).status, 2);
        QCOMPARE(runCli({"gradient", "--object", "Thing"}).status, 2);
        QCOMPARE(runCli({"gradient", file, "--object", "Nothing"}).status, 1);
        QCOMPARE(runCli({"gradient", "--table", folder.filePath("missing.csv")}).status, 1);
    }
};

QTEST_GUILESS_MAIN(GradientCommandTest)
#include "gradient_command_test.moc"
