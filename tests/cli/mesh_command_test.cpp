// SPDX-License-Identifier: GPL-3.0-or-later
#include <QFile>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QTemporaryDir>
#include <QTest>

#include "tests/support/program.h"

using namespace isoscope::test;

namespace {

const QByteArray torusScene =
    "#version 3.7;\n#include \"functions.inc\"\nisosurface {\n  function { f_torus(x, y, z, 1, 0.4) }\n  "
    "contained_by { box { -2, 2 } }\n}\n";

}  // namespace

class MeshCommandTest : public QObject {
    Q_OBJECT

  private:
    QTemporaryDir folder_;

  private slots:
    void jsonTellsTheForm() {
        const QString scene = writeFile(folder_.path(), "torus.pov", torusScene);
        const QString file = folder_.filePath("torus.stl");
        const ProgramResult result = runCli({"mesh", scene, "-o", file, "--tolerance", "0.05", "--json"});
        QVERIFY2(result.status == 0, result.errors);
        const QJsonObject json = QJsonDocument::fromJson(result.output).object();
        QCOMPARE(json["genus"].toInt(-1), 1);
        QCOMPARE(json["euler_characteristic"].toInt(-1), 0);
        QCOMPARE(json["pieces"].toInt(), 1);
        QVERIFY(json["watertight"].toBool() && json["manifold"].toBool());
        QVERIFY(!json["cut_by_container"].toBool(true));
        QVERIFY(json["distance"].toDouble(9) <= 0.05);
        QCOMPARE(json["isosurfaces"].toArray()[0].toObject()["line"].toInt(), 3);
        QCOMPARE(QFile(file).size(), 84 + 50 * json["triangles"].toInt());
    }

    void sentencesTellIt() {
        const QString scene = writeFile(folder_.path(), "torus.pov", torusScene);
        const ProgramResult result =
            runCli({"mesh", scene, "-o", folder_.filePath("torus.3mf"), "--tolerance", "0.1"});
        QVERIFY2(result.status == 0, result.errors);
        QVERIFY2(result.output.contains("genus 1") && result.output.contains("Watertight and manifold"),
                 result.output);
        QVERIFY(result.output.contains("sampled, not proven"));
    }

    void aMeshReplacesAMeshAndNothingElse() {
        const QString scene = writeFile(folder_.path(), "torus.pov", torusScene);
        for (const char* name : {"m.stl", "m.obj", "m.ply", "m.3mf", "m.glb", "m.inc"})
            for (int time = 0; time < 2; ++time) {
                const ProgramResult result =
                    runCli({"mesh", scene, "-o", folder_.filePath(name), "--tolerance", "0.2"});
                QVERIFY2(result.status == 0, result.errors);
            }
        const QString foreign = writeFile(folder_.path(), "foreign.obj", "v 0 0 0\n");
        const ProgramResult refused = runCli({"mesh", scene, "-o", foreign, "--tolerance", "0.2"});
        QCOMPARE(refused.status, 1);
        QVERIFY2(refused.errors.contains("no mesh that Isoscope exported"), refused.errors);
    }

    void wrongUsageAndMissingSurfacesAreTold() {
        const QString scene = writeFile(folder_.path(), "torus.pov", torusScene);
        QCOMPARE(runCli({"mesh", scene, "-o", folder_.filePath("m.png")}).status, 2);
        QCOMPARE(runCli({"mesh", scene, "-o", folder_.filePath("n.stl"), "--tolerance", "-1"}).status, 2);
        const ProgramResult line = runCli({"mesh", scene, "-o", folder_.filePath("n.stl"), "--line", "77"});
        QCOMPARE(line.status, 1);
        QVERIFY2(line.errors.contains("no isosurface on line 77"), line.errors);
        QVERIFY(!QFile::exists(folder_.filePath("n.stl")));
    }
};

QTEST_APPLESS_MAIN(MeshCommandTest)
#include "mesh_command_test.moc"
