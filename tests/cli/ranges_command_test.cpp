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

const QByteArray torusScene =
    "#version 3.7;\n#include \"functions.inc\"\nisosurface {\n  function { f_torus(x, y, z, 0.8, 0.2) }\n"
    "  contained_by { box { -1, 1 } }\n}\n";

}  // namespace

class RangesCommandTest : public QObject {
    Q_OBJECT

  private:
    QTemporaryDir folder_;

  private slots:
    void theTableHasOneRowForEachNumber() {
        const QString file = writeFile(folder_.path(), "s.pov", torusScene);
        const ProgramResult result = runCli({"ranges", file});
        QCOMPARE(result.status, 0);
        QVERIFY2(result.errors.isEmpty(), result.errors);
        const isoscope::CsvTable rows = isoscope::CsvTable::parse(result.output.toStdString());
        const std::vector<std::string> header{"line",    "group", "name", "value",       "minimum",
                                              "maximum", "from",  "to",   "proven_share"};
        QCOMPARE(rows.header(), header);
        QCOMPARE(rows.rowCount(), std::size_t(3));
        QCOMPARE(rows.field(1, "line"), std::string("3"));
        QCOMPARE(rows.field(1, "group"), std::string("f_torus"));
        QCOMPARE(rows.field(1, "name"), std::string("Minor Radius"));
        QCOMPARE(rows.number(1, "value", 9), 0.2);
        QVERIFY(rows.number(1, "proven_share", 0) > 0.9);
        QCOMPARE(rows.field(2, "name"), std::string("threshold"));
        // From the ring itself to the middles of top and bottom.
        const double farthest = std::hypot(0.8, 1.0) - 0.2;
        QVERIFY(std::abs(rows.number(2, "from", 9) + 0.2) < 0.05);
        QVERIFY(std::abs(rows.number(2, "to", 9) - std::min(farthest, rows.number(2, "maximum", 9))) < 0.05);
    }

    void jsonHasThePieces() {
        const QString file = writeFile(folder_.path(), "s.pov", torusScene);
        const QJsonArray all = QJsonDocument::fromJson(runCli({"ranges", file, "--json"}).output).array();
        QCOMPARE(all.size(), 3);
        const QJsonArray pieces = all[2].toObject()["pieces"].toArray();
        QVERIFY(pieces.size() >= 3);
        QCOMPARE(pieces.first().toObject()["presence"].toString(), QStringLiteral("outside"));
        bool surface = false;
        for (const auto& piece : pieces) surface |= piece.toObject()["presence"] == QStringLiteral("surface");
        QVERIFY(surface);
    }

    void aSceneWithoutIsosurfaceIsAnError() {
        const QString file = writeFile(folder_.path(), "e.pov", "sphere { 0, 1 }\n");
        const ProgramResult result = runCli({"ranges", file});
        QCOMPARE(result.status, 1);
        QVERIFY(result.errors.contains("there is no isosurface"));
    }
};

QTEST_MAIN(RangesCommandTest)
#include "ranges_command_test.moc"
