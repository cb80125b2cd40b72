// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <QFile>
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

    void includesAreRepairedWhereTheyStand() {
        QTemporaryDir folder, elsewhere;
        const QByteArray ball = "isosurface { function { x*x+y*y+z*z-1 } contained_by { sphere { 0, 1.2 } } ";
        const QByteArray part =
            "// a part\r\n#macro Ball(R)\n  " + ball + "max_gradient 2*0.6 /* low */ open }\n#end\n";
        const QString include = writeFile(folder.path(), "part.inc", part);
        const QByteArray text = "#version 3.7;\n#include \"part.inc\"\nBall(1)\n" + ball + "}\n" + ball +
                                "max_gradient 2.4 }\n" + ball + "max_gradient 1 }\n";
        const QString scene = writeFile(folder.path(), "s.pov", text);
        const auto contentOf = [](const QString& name) {
            QFile file(name);
            return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
        };
        // The one in line 6 only.
        const ProgramResult one = runCli({"gradient", scene, "--repair", "--only", scene + ":6"});
        QVERIFY2(one.status == 0, one.errors);
        const QByteArray mended = QByteArray(text).replace("max_gradient 1 }", "max_gradient 2.4 }");
        QCOMPARE(contentOf(scene), mended);
        QCOMPARE(contentOf(include), part);
        // All others, in both files; every other character is kept.
        const ProgramResult all = runCli({"gradient", scene, "--repair"});
        QVERIFY2(all.status == 0, all.errors);
        QCOMPARE(contentOf(include), QByteArray(part).replace("max_gradient 2*0.6", "max_gradient 2.4"));
        QVERIFY(all.errors.contains("part.inc: note: 1 of its max_gradient changed"));
        QCOMPARE(contentOf(scene).count("max_gradient 2.4"), 3);
        QCOMPARE(runCli({"gradient", scene, "--check"}).status, 0);
        // Include files elsewhere belong to others.
        const QString far = writeFile(elsewhere.path(), "far.inc", ball + "}\n");
        const QString other =
            writeFile(folder.path(), "o.pov", "#version 3.7;\n#include \"" + far.toUtf8() + "\"\n");
        const ProgramResult refused =
            runCli({"gradient", other, "--repair", "--allow-read", elsewhere.path()});
        QCOMPARE(refused.status, 1);
        QVERIFY2(refused.errors.contains("stands in another folder"), refused.errors);
        QCOMPARE(contentOf(far), ball + "}\n");
    }

    void exportedNotesAreCheckedAgain() {
        QTemporaryDir folder;
        const QString file =
            writeFile(folder.path(), "s.pov", QByteArray(scene).replace("%1", "max_gradient 2.4"));
        const QString out = folder.filePath("out.inc");
        QCOMPARE(runCli({"export", file, "-o", out, "--note"}).status, 0);
        QFile written(out);
        QVERIFY(written.open(QIODevice::ReadOnly));
        const QByteArray text = written.readAll();
        QVERIFY2(text.contains("/* Proven by Isoscope "), text);
        QVERIFY(text.contains("gradient at most 2.4"));
        QVERIFY(text.contains("accuracy 0.001") &&
                text.contains("view: location <0, 0, -5>, look_at <0, 0, 0> */"));
        const ProgramResult good = runCli({"gradient", out, "--check"});
        QVERIFY2(good.status == 0 && !good.errors.contains("comment"), good.errors);
        // Another function, or another accuracy, is another isosurface.
        const QString steeper =
            writeFile(folder.path(), "t.inc", QByteArray(text).replace("x*x+y*y", "2*x*x+y*y"));
        const ProgramResult bad = runCli({"gradient", steeper, "--check"});
        QCOMPARE(bad.status, 1);
        QVERIFY2(bad.errors.contains("warning: The comment says that no gradient is longer than 2.4"),
                 bad.errors);
        const QString coarse =
            writeFile(folder.path(), "u.inc",
                      QByteArray(text).replace("max_gradient 2.4", "accuracy 0.1 max_gradient 2.4"));
        QVERIFY(runCli({"gradient", coarse, "--check"}).errors.contains("is about accuracy 0.001"));
        QCOMPARE(runCli({"export", file, "-o", folder.filePath("out.pov"), "--note"}).status, 2);
    }

    void aSceneIsRepaired() {
        QTemporaryDir folder;
        const QByteArray surfaces =
            "isosurface { function { x*x+y*y+z*z-1 } contained_by { sphere { 0, 1.2 } } }  // kept\n"
            "isosurface { function { x*x+y*y+z*z-1 } contained_by { sphere { 0, 1.2 } } max_gradient 2.4 }\n"
            "isosurface { function { x*x+y*y+z*z-1 } contained_by { sphere { 0, 1.2 } } max_gradient 99 }\n"
            "#declare I = 0; #while (I < 2) isosurface { function { (1 + I)*x } max_gradient 0.5 }\n"
            "#declare I = I + 1; #end\n";
        const QString file = writeFile(folder.path(), "s.pov", QString(scene).arg("").toUtf8() + surfaces);
        const QString repaired = folder.filePath("t.pov");
        QCOMPARE(runCli({"gradient", file, "--check"}).status, 1);
        QCOMPARE(runCli({"gradient", file, "--write", repaired}).status, 0);
        QFile written(repaired);
        QVERIFY(written.open(QIODevice::ReadOnly));
        QByteArray wanted = QString(scene).arg("").toUtf8() + surfaces;
        wanted.replace("x*x+y*y+z*z-1 } contained_by { sphere { 0, 1.2 } }  ",
                       "x*x+y*y+z*z-1 }\n  max_gradient 2.4 contained_by { sphere { 0, 1.2 } }  ");
        wanted.replace("function { x*x+y*y+z*z-1 } contained_by { sphere { 0, 1.2 } } }",
                       "function { x*x+y*y+z*z-1 }\n  max_gradient 2.4 contained_by { sphere { 0, 1.2 } } }");
        wanted.replace("max_gradient 99", "max_gradient 2.4").replace("max_gradient 0.5", "max_gradient 2");
        QCOMPARE(written.readAll(), wanted);
        QCOMPARE(runCli({"gradient", repaired, "--check"}).status, 0);
        QCOMPARE(runCli({"gradient", file, "--write", file}).status, 1);
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

    /// As a build system asks: a line for each isosurface, and what is wrong as compilers say it.
    void manyScenesAreCheckedInOneCall() {
        QTemporaryDir folder;
        const auto file = [&](const char* name, const char* setting) {
            return writeFile(folder.path(), name, QString(scene).arg(setting).toUtf8());
        };
        const QString right = file("right.pov", "max_gradient 2.4"), low = file("low.pov", "max_gradient 2"),
                      high = file("high.pov", "max_gradient 20");
        const QString none = writeFile(folder.path(), "none.pov", "sphere { 0, 1 }\n");
        const ProgramResult good = runCli({"gradient", "--check", right, high});
        QCOMPARE(good.status, 0);
        QVERIFY2(good.errors.isEmpty(), good.errors.constData());
        QCOMPARE(rowsOf(good).rowCount(), std::size_t(2));
        QCOMPARE(rowsOf(good).field(0, "place"), right.toStdString() + ":5");
        QCOMPARE(rowsOf(good).number(1, "max_gradient", 0), 20.0);
        QCOMPARE(rowsOf(good).field(1, "verdict"), std::string("wasteful"));

        const ProgramResult bad =
            runCli({"gradient", "--check", low, none, folder.filePath("gone.pov"), right});
        QCOMPARE(bad.status, 1);
        // The others are judged all the same.
        QCOMPARE(rowsOf(bad).rowCount(), std::size_t(2));
        QCOMPARE(rowsOf(bad).field(0, "verdict"), std::string("holes"));
        QCOMPARE(rowsOf(bad).field(1, "verdict"), std::string("right"));
        QVERIFY(rowsOf(bad).number(0, "lower", 0) <= 2.4 && rowsOf(bad).number(0, "upper", 0) >= 2.4);
        const QByteArray message = low.toUtf8() + ":5: error: max_gradient 2 is too small: ";
        QVERIFY2(bad.errors.contains(message) && bad.errors.contains("; use 2.4\n"), bad.errors.constData());
        QVERIFY(bad.errors.contains(none.toUtf8()) && bad.errors.contains("gone.pov"));

        const ProgramResult json = runCli({"gradient", "--json", "--check", low, right});
        const QJsonArray all = QJsonDocument::fromJson(json.output).array();
        QCOMPARE(all.size(), 2);
        QCOMPARE(all[1].toObject()["file_line"].toString(), right + ":5");
        QCOMPARE(runCli({"gradient", right, high}).status, 2);
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

    /// A bug once: a sum of 40 000 noises was studied for more than half an hour.
    void whatIsProvenWhenTheTimeIsOverIsTold() {
        QTemporaryDir folder;
        QByteArray body = "f_noise3d(x,y,z)";
        for (int k = 0; k < 4000; ++k) body += "+f_noise3d(x,y," + QByteArray::number(k) + ")";
        const QString file = writeFile(folder.path(), "noises.pov",
                                       "#version 3.7;\n#include \"functions.inc\"\nisosurface { function { " +
                                           body + " } contained_by { sphere { 0, 1.2 } } max_gradient 2 }\n");
        const ProgramResult result = runCli({"gradient", file, "--proof-limit", "0.01"});
        QVERIFY2(result.status == 0, result.errors);
        QVERIFY2(result.errors.contains(":3: note: the time is over (--proof-limit 0.01)"), result.errors);
        const isoscope::CsvTable rows = rowsOf(result);
        QCOMPARE(rows.rowCount(), std::size_t(1));
        QCOMPARE(rows.field(0, "upper"), std::string("inf"));
        const ProgramResult json = runCli({"gradient", file, "--proof-limit", "0.01", "--json"});
        QVERIFY2(json.output.contains("\"stopped\""), json.output);
        QCOMPARE(runCli({"gradient", file, "--proof-limit", "0"}).status, 2);
    }

    /// A bug once: the limit was for each of them, and a scene of 3000 isosurfaces took 40 s with any.
    void manyIsosurfacesShareOneLimit() {
        QTemporaryDir folder;
        QByteArray text = "#version 3.7;\n#include \"functions.inc\"\n";
        QByteArray table = "function,container\n";
        constexpr int count = 3000;
        for (int k = 0; k < count; ++k) {
            const QByteArray body = "f_noise3d(x*" + QByteArray::number(1 + k * 1e-3) + ",y,z)-0.5+x*y";
            text += "isosurface { function { " + body +
                    " } contained_by { box { -1, 1 } } max_gradient 9 translate 3*z*" +
                    QByteArray::number(k) + " }\n";
            table += "\"" + body + "\",\"box{<-1,-1,-1>,<1,1,1>}\"\n";
        }
        const QString scene = writeFile(folder.path(), "many.pov", text);
        const ProgramResult result = runCli({"gradient", scene, "--proof-limit", "0.2"}, 60);
        QVERIFY2(result.status == 0, result.errors);
        const isoscope::CsvTable rows = rowsOf(result);
        QCOMPARE(rows.rowCount(), std::size_t(count));
        std::size_t first = 0;
        while (first < count && rows.field(first, "verdict") != "not-studied") ++first;
        QVERIFY(first < count);
        for (std::size_t row = first; row < count; ++row) {
            QCOMPARE(rows.field(row, "verdict"), std::string("not-studied"));
            QCOMPARE(rows.field(row, "upper"), std::string("inf"));
        }
        const QByteArray told = "the time is over (--proof-limit 0.2); this ";
        const QByteArray where = "many.pov:" + QByteArray::number(qulonglong(first + 3));
        QVERIFY2(result.errors.contains(where + ": note: " + told + "isosurface"), result.errors.left(300));
        // What was not looked at has not passed, in none of the scenes.
        const ProgramResult check = runCli({"gradient", "--check", scene, scene, "--proof-limit", "0.2"}, 60);
        QCOMPARE(check.status, 1);
        QCOMPARE(rowsOf(check).rowCount(), std::size_t(2 * count));
        QCOMPARE(rowsOf(check).field(count, "verdict"), std::string("not-studied"));
        QVERIFY2(
            check.errors.contains("many.pov:3: error: " + told + "isosurface and the 2999 after it were"),
            check.errors.left(500));

        const ProgramResult ofTable = runCli(
            {"gradient", "--table", writeFile(folder.path(), "many.csv", table), "--proof-limit", "0.2"}, 60);
        QCOMPARE(ofTable.status, 0);
        QCOMPARE(rowsOf(ofTable).rowCount(), std::size_t(count));
        QCOMPARE(rowsOf(ofTable).field(count - 1, "verdict"), std::string("not-studied"));
        QVERIFY2(ofTable.errors.contains(told + "row and the "), ofTable.errors.left(300));
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
