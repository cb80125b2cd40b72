// SPDX-License-Identifier: GPL-3.0-or-later
// The commands that say what a function is like as a whole: report, health, rewrites.
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
    "#version 3.7;\n#include \"functions.inc\"\nisosurface {\n  function { f_torus(x, y, z, 0.8, 0.2) }\n"
    "  contained_by { box { -1.1, 1.1 } }\n}\nisosurface { function { 1/x - 2 } contained_by { box { -1, 1 } "
    "} }\n";

}  // namespace

class ReportCommandTest : public QObject {
    Q_OBJECT

  private:
    QTemporaryDir folder_;
    QString scene_;

  private slots:
    void initTestCase() { scene_ = writeFile(folder_.path(), "s.pov", scene); }

    void reportIsText() {
        const ProgramResult result = runCli({"report", scene_, "--cells", "48"});
        QCOMPARE(result.status, 0);
        QVERIFY2(result.errors.isEmpty(), result.errors);
        const QList<QByteArray> lines = result.output.split('\n');
        QCOMPARE(lines[0], QByteArray("Isosurface in line 3"));
        QVERIFY2(lines[1].startsWith("Pieces: 1 piece with 1 tunnel and no hollows"), lines[1]);
        for (const char* topic : {"Extent: ", "Volume: ", "Area: ", "Thinnest wall: ", "Symmetry: "})
            QVERIFY2(result.output.contains(QByteArray("\n") + topic), topic);
        QVERIFY(result.output.contains("Isosurface in line 7"));
    }

    void reportHasJson() {
        const QJsonArray all =
            QJsonDocument::fromJson(runCli({"report", scene_, "--cells", "32", "--json"}).output).array();
        QCOMPARE(all.size(), 2);
        const QJsonObject first = all[0].toObject();
        QCOMPARE(first["tunnels"].toInt(), 1);
        const QJsonObject volume = first["volume"].toObject();
        QVERIFY(volume["low"].toDouble() < 0.6317 && volume["high"].toDouble() > 0.6316);
        QCOMPARE(first["text"].toArray().size(), 6);
    }

    void healthHasAPlaceForEachFinding() {
        const ProgramResult result = runCli({"health", scene_});
        QCOMPARE(result.status, 0);
        const isoscope::CsvTable rows = isoscope::CsvTable::parse(result.output.toStdString());
        bool pole = false;
        for (std::size_t row = 0; row < rows.rowCount(); ++row) {
            if (rows.field(row, "line") != "7" || rows.field(row, "kind") != "infinite") continue;
            pole = true;
            QCOMPARE(rows.field(row, "certainty"), std::string("met"));
            QVERIFY(std::abs(rows.number(row, "x", 9)) < 0.04);
            QVERIFY(std::abs(rows.number(row, "distance", 9) - 0.5) < 0.1);
        }
        QVERIFY(pole);
        const QJsonArray all = QJsonDocument::fromJson(runCli({"health", scene_, "--json"}).output).array();
        QCOMPARE(all.size(), 2);
        QVERIFY(all[1].toObject()["findings"].toArray().size() >= 1);
    }

    void rewritesAreListedAndWritten() {
        const QByteArray text =
            "#version 3.7;\nisosurface { function { (x + y*z)*(x + y*z) - 0.3 /* kept */ } }\n";
        const QString file = writeFile(folder_.path(), "w.pov", text);
        const QString out = folder_.filePath("out.pov");
        const ProgramResult result = runCli({"rewrites", file, "--apply", "1", "-o", out});
        QCOMPARE(result.status, 0);
        const isoscope::CsvTable rows = isoscope::CsvTable::parse(result.output.toStdString());
        QCOMPARE(rows.rowCount(), std::size_t(1));
        QCOMPARE(rows.field(0, "kind"), std::string("power"));
        QCOMPARE(rows.field(0, "line"), std::string("2"));
        QCOMPARE(rows.field(0, "text"), std::string("(x + y*z)*(x + y*z)"));
        QCOMPARE(rows.field(0, "replacement"), std::string("pow(x + y*z, 2)"));
        QCOMPARE(rows.number(0, "largest_difference", 9), 0.0);
        QVERIFY(rows.number(0, "povray_ns_after", 9) < rows.number(0, "povray_ns", 0));
        QFile written(out);
        QVERIFY(written.open(QIODevice::ReadOnly));
        QCOMPARE(written.readAll(), QByteArray(text).replace("(x + y*z)*(x + y*z)", "pow(x + y*z, 2)"));
        QCOMPARE(runCli({"rewrites", file, "--apply", "2", "-o", folder_.filePath("no.pov")}).status, 1);
        QCOMPARE(runCli({"rewrites", file, "--apply", "1"}).status, 2);
    }

    void scenesWithoutIsosurfaceAreErrors() {
        const QString file = writeFile(folder_.path(), "e.pov", "sphere { 0, 1 }\n");
        for (const char* command : {"report", "health", "rewrites"}) {
            const ProgramResult result = runCli({command, file});
            QCOMPARE(result.status, 1);
            QVERIFY(result.errors.contains("there is no isosurface"));
        }
    }
};

QTEST_MAIN(ReportCommandTest)
#include "report_command_test.moc"
