// SPDX-License-Identifier: GPL-3.0-or-later
#include <QFile>
#include <QTemporaryDir>
#include <QTest>

#include "core/text/csv_table.h"
#include "tests/support/program.h"

using namespace isoscope;
using namespace isoscope::test;

class ContainerCommandTest : public QObject {
    Q_OBJECT

  private slots:
    void theSceneIsWrittenWithSmallerContainers() {
        QTemporaryDir folder;
        const QByteArray scene =
            "#version 3.7;\ncamera { location <0,0,-9> look_at 0 }  // kept\nlight_source { <5,5,-5> 1 }\n"
            "isosurface { function { x*x+y*y+z*z-1 } contained_by { box { -3, 3 } } pigment { rgb 1 } }\n"
            "isosurface { function { -1 } contained_by { box { 2, 3 } } }\n";
        const QString file = writeFile(folder.path(), "s.pov", scene);
        const QString changed = folder.filePath("t.pov");
        const ProgramResult result = runCli({"container", file, "-W", "80", "-H", "60", "--write", changed});
        QCOMPARE(result.status, 0);
        const isoscope::CsvTable rows = isoscope::CsvTable::parse(result.output.toStdString());
        const std::vector<std::string> header{"line",         "container",      "fitted",
                                              "volume_share", "povray_seconds", "fitted_povray_seconds"};
        QCOMPARE(rows.header(), header);
        QCOMPARE(rows.rowCount(), std::size_t(2));
        QCOMPARE(rows.field(0, "line"), std::string("4"));
        QVERIFY(rows.number(0, "volume_share", 1) < 0.03);
        QVERIFY(rows.field(1, "fitted").empty());
        QFile written(changed);
        QVERIFY(written.open(QIODevice::ReadOnly));
        const QByteArray fitted = " " + QByteArray::fromStdString(rows.field(0, "fitted")) + " ";
        QCOMPARE(written.readAll(), QByteArray(scene).replace(" box { -3, 3 } ", fitted));
    }

    void itsOwnSceneIsNotReplaced() {
        QTemporaryDir folder;
        const QString file =
            writeFile(folder.path(), "s.pov",
                      "isosurface { function { x*x+y*y+z*z-1 } contained_by { box { -3, 3 } } }");
        QCOMPARE(runCli({"container", file, "--write", file}).status, 1);
        QCOMPARE(runCli({"container", writeFile(folder.path(), "e.pov", "sphere { 0, 1 }")}).status, 1);
    }
};

QTEST_GUILESS_MAIN(ContainerCommandTest)
#include "container_command_test.moc"
