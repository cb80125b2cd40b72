// SPDX-License-Identifier: GPL-3.0-or-later
#include <QDir>
#include <QFile>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QTemporaryDir>
#include <QTest>
#include <cmath>

#include "core/exchange/png.h"
#include "test_folders.h"
#include "tests/support/csv_table.h"
#include "tests/support/png_channels.h"
#include "tests/support/program.h"

using namespace isoscope::test;

namespace {

const char* const sphereScene = R"(#version 3.7;
global_settings { assumed_gamma 1 }
#declare Radius = 1;
camera { location <0, 0, -4> look_at 0 angle 40 }
light_source { <-3, 5, -6> rgb 1 shadowless }
#declare Ball = isosurface {
  function { x*x + y*y + z*z - Radius*Radius }
  contained_by { sphere { 0, 1.5 } }
  max_gradient 4
  accuracy 1e-6
}
object { Ball pigment { rgb 1 } }
)";

QByteArray contentOf(const QString& path) {
    QFile file(path);
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray("(no file)");
}

}  // namespace

class ContractTest : public QObject {
    Q_OBJECT

  private:
    QTemporaryDir folder_;
    QString scene_;

    QString file(const QString& name, const QByteArray& text) {
        return writeFile(folder_.path(), name, text);
    }

  private slots:
    void initTestCase() { scene_ = file("sphere.pov", sphereScene); }

    void evaluateKeepsRowsAndOrder() {
        const QString table = file("in.csv",
                                   "id,expression,prelude,x,y,z\n"
                                   "a,\"f_torus(x,y,z,0.8,0.2)\",,1,0,0\n"
                                   "b,nonsense(,,0,0,0\n"
                                   "c,x+R,#declare R = 2;,1,2,3\n"
                                   "d,1/(x-x),,1,0,0\n");
        for (const char* evaluator : {"reference", "batch"}) {
            const ProgramResult result = runCli({"evaluate", "--table", table, "--evaluator", evaluator});
            QCOMPARE(result.status, 0);
            const isoscope::CsvTable rows = tableOf(result);
            QCOMPARE(rows.rowCount(), 4u);
            QCOMPARE(rows.field(0, "id"), std::string("a"));
            QVERIFY(std::abs(rows.number(0, "value", 9)) < 1e-15);
            QVERIFY(rows.field(1, "value").empty());
            QVERIFY(!rows.field(1, "error").empty());
            QCOMPARE(rows.number(2, "value", 0), 3.0);
            QCOMPARE(rows.field(3, "value"), std::string("inf"));
        }
    }

    void evaluateEnclosesOverBoxes() {
        const QString table = file("boxes.csv",
                                   "expression,noise_generator,x,y,z,rx,ry,rz\n"
                                   "x*x+y,,0.5,0.25,0,0.1,0,0\n"
                                   "sqrt(x),,-1,0,0,0.5,0,0\n"
                                   "nonsense(,,0,0,0,0,0,0\n"
                                   "\"f_noise3d(x,y,z)\",1,0.1,0.2,0.3,0.001,0.001,0.001\n");
        for (const char* evaluator : {"interval", "affine"}) {
            const isoscope::CsvTable rows =
                tableOf(runCli({"evaluate", "--table", table, "--evaluator", evaluator}));
            QCOMPARE(rows.rowCount(), 4u);
            QCOMPARE(rows.header().back(), std::string("error"));
            const double lower = rows.number(0, "lower", 9), upper = rows.number(0, "upper", -9);
            QVERIFY(lower <= 0.41 && lower > 0.38);
            QVERIFY(upper >= 0.61 && upper < 0.62);
            QCOMPARE(rows.field(1, "lower"), std::string("nan"));
            QVERIFY(rows.field(2, "lower").empty() && !rows.field(2, "error").empty());
            QVERIFY(rows.number(3, "lower", 9) < 0.2992429090099138);
            QVERIFY(rows.number(3, "upper", -9) > 0.2992429090099138);
        }
    }

    void evaluateTakesHeadsAndNoiseGenerators() {
        const QString table = file("heads.csv",
                                   "expression,prelude,noise_generator,x,y,z\n"
                                   "a+10*b+100*c,\"function(a,b,c)\",,1,2,3\n"
                                   "\"f_noise3d(x,y,z)\",,1,0.1,0.2,0.3\n"
                                   "\"f_noise3d(x,y,z)\",,3,0.1,0.2,0.3\n");
        const isoscope::CsvTable rows = tableOf(runCli({"evaluate", "--table", table}));
        QCOMPARE(rows.number(0, "value", 0), 321.0);
        QCOMPARE(rows.number(1, "value", 0), 0.2992429090099138);
        QCOMPARE(rows.number(2, "value", 0), 0.6522608537200985);
    }

    void traceAnswersEveryRay() {
        const QString rays =
            file("rays.csv", "ox,oy,oz,dx,dy,dz,comment\n0,0,-4,0,0,2,hit\n3,0,-4,0,0,1,miss\n");
        for (const QStringList& object : {QStringList{}, QStringList{"--object", "Ball"}}) {
            const ProgramResult result = runCli(QStringList{"trace", scene_, "--rays", rays} + object);
            QCOMPARE(result.status, 0);
            QVERIFY(result.output.startsWith("hit,t,px,py,pz,nx,ny,nz,kind\n"));
            const isoscope::CsvTable rows = tableOf(result);
            QCOMPARE(rows.rowCount(), 2u);
            QCOMPARE(rows.field(0, "hit"), std::string("1"));
            // t is in units of the ray's own direction.
            QVERIFY(std::abs(rows.number(0, "t", 0) - 1.5) < 2e-6);
            QVERIFY(std::abs(rows.number(0, "nz", 0) + 1) < 1e-5);
            QCOMPARE(rows.field(0, "kind"), std::string("crossing"));
            QCOMPARE(rows.field(1, "hit"), std::string("0"));
        }
    }

    void insideAnswersEveryPoint() {
        const QString points = file("points.csv", "x,y,z\n0,0,0\n0,0,1.01\n");
        const ProgramResult result = runCli({"inside", scene_, "--points", points, "--object", "Ball"});
        QCOMPARE(result.status, 0);
        QCOMPARE(result.output, QByteArray("inside\n1\n0\n"));
    }

    void renderWritesPictureAndStatistics() {
        const QString png = folder_.filePath("out.png"), json = folder_.filePath("out.json");
        const ProgramResult result = runCli({"render", scene_, "-o", png, "-W", "64", "-H", "48",
                                             "--statistics", json, "--solver", "lipschitz"});
        QCOMPARE(result.status, 0);
        const isoscope::Image image = isoscope::readPng(png.toStdString());
        QCOMPARE(image.width, 64);
        QCOMPARE(image.height, 48);
        QVERIFY(image.pixels[24 * 64 + 32][0] > 0.1f);
        QCOMPARE(image.pixels[0][0], 0.0f);

        QFile file(json);
        QVERIFY(file.open(QIODevice::ReadOnly));
        const QJsonObject statistics = QJsonDocument::fromJson(file.readAll()).object();
        for (const char* key :
             {"render_cpu_seconds", "parse_seconds", "evaluations", "verdicts", "stages", "left_out"})
            QVERIFY2(statistics.contains(key), key);
        QVERIFY(statistics["evaluations"].toDouble() > 64 * 48 / 10);
        double pixels = 0;
        for (const auto& count : statistics["verdicts"].toObject()) pixels += count.toDouble();
        QCOMPARE(pixels, 64.0 * 48.0);
        for (const auto& stage : statistics["stages"].toArray())
            for (const char* key : {"name", "reason", "rays", "evaluations", "cpu_seconds"})
                QVERIFY2(stage.toObject().contains(key), key);
    }

    void renderWritesDeepAndTransparentPictures() {
        const QString deep = folder_.filePath("deep.png"), layers = folder_.filePath("layers.exr");
        const QStringList render{"render", scene_, "-W", "64", "-H", "48", "--transparent"};
        QCOMPARE(runCli(render + QStringList{"-o", deep, "--depth", "16"}).status, 0);
        const PngChannels picture = readPngChannels(deep.toStdString());
        QCOMPARE(picture.bits, 16);
        QCOMPARE(picture.channels, 4);
        QCOMPARE(picture.at(0, 0, 3), 0);
        QCOMPARE(picture.at(32, 24, 3), 65535);
        QCOMPARE(runCli(render + QStringList{"-o", layers, "--solver", "certified"}).status, 0);
        QVERIFY(contentOf(layers).startsWith("\x76\x2f\x31\x01"));
        QCOMPARE(runCli(render + QStringList{"-o", layers, "--depth", "16"}).status, 2);
        QCOMPARE(runCli(render + QStringList{"-o", deep, "--depth", "12"}).status, 2);
    }

    void aSceneWithoutAnObjectIsDrawnWithAWord() {
        const QString png = folder_.filePath("nothing.png");
        for (const QByteArray text : {"", "// nothing yet\n", "camera { location -3*z }\n"}) {
            const ProgramResult result =
                runCli({"render", file("nothing.pov", text), "-o", png, "-W", "16", "-H", "12"});
            QCOMPARE(result.status, 0);
            QVERIFY2(result.errors.contains("nothing.pov: note: the scene has no object"), result.errors);
            QCOMPARE(isoscope::readPng(png.toStdString()).width, 16);
        }
        const ProgramResult seen = runCli({"render", scene_, "-o", png, "-W", "16", "-H", "12"});
        QVERIFY2(!seen.errors.contains("no object"), seen.errors);
    }

    void declarationsAndThreadsTakeEffect() {
        const QString one = folder_.filePath("one.png"), four = folder_.filePath("four.png");
        const QString small = folder_.filePath("small.png");
        QCOMPARE(runCli({"render", scene_, "-o", one, "-W", "64", "-H", "48", "--threads", "1"}).status, 0);
        QCOMPARE(runCli({"render", scene_, "-o", four, "-W", "64", "-H", "48", "--threads", "4"}).status, 0);
        QFile first(one), second(four);
        QVERIFY(first.open(QIODevice::ReadOnly) && second.open(QIODevice::ReadOnly));
        QCOMPARE(first.readAll(), second.readAll());

        const QString optional =
            file("optional.pov", QByteArray("#ifndef (Size) #declare Size = 1; #end\n") +
                                     QByteArray(sphereScene).replace("Radius = 1", "Radius = Size"));
        QCOMPARE(
            runCli({"render", optional, "-o", small, "-W", "64", "-H", "48", "--declare", "Size=0.5"}).status,
            0);
        QFile third(small);
        QVERIFY(third.open(QIODevice::ReadOnly));
        first.seek(0);
        QVERIFY(third.readAll() != first.readAll());
    }

    void edgesAreSmoothedByThreeMethods() {
        const auto drawn = [&](const QString& name, const QStringList& how) {
            const QString picture = folder_.filePath(name);
            const ProgramResult result =
                runCli(QStringList{"render", scene_, "-o", picture, "-W", "64", "-H", "48"} + how);
            return result.status == 0 ? isoscope::readPng(picture.toStdString()) : isoscope::Image();
        };
        const isoscope::Image plain = drawn("plain.png", {});
        const QList<QStringList> methods{{"--antialias"},
                                         {"--antialias-method", "1"},
                                         {"--antialias-method", "2", "--antialias-depth", "2"}};
        for (const QStringList& how : methods) {
            const isoscope::Image smooth = drawn("smooth.png", how);
            QCOMPARE(smooth.pixels.size(), plain.pixels.size());
            QVERIFY2(smooth.pixels != plain.pixels, qPrintable(how.join(' ')));
            // The background stays what it is.
            QVERIFY(smooth.pixels.front() == plain.pixels.front());
        }
        const QString nowhere = folder_.filePath("none.png");
        QCOMPARE(runCli({"render", scene_, "-o", nowhere, "--antialias-method", "3"}).status, 2);
        QCOMPARE(runCli({"render", scene_, "-o", nowhere, "--antialias-depth", "2"}).status, 2);
    }

    void checkNamesPlaceAndStatus() {
        const QString bad = file("bad.pov", "isosurface {\n  function { f_torus(x,y,z,1) }\n}\n");
        const ProgramResult result = runCli({"check", bad});
        QCOMPARE(result.status, 1);
        QVERIFY2(result.errors.contains(
                     "bad.pov:2:14: error: `f_torus` takes x, y, z and 2 parameters; 1 is missing"),
                 result.errors);
        QCOMPARE(runCli({"check", scene_}).status, 0);
    }

    void functionsListsAll() {
        const isoscope::CsvTable rows = tableOf(runCli({"functions", "--csv"}));
        QVERIFY(rows.rowCount() >= 78);
        bool found = false;
        for (std::size_t row = 0; row < rows.rowCount(); ++row) {
            if (rows.field(row, "name") != "f_torus") continue;
            found = true;
            QCOMPARE(rows.field(row, "param_count"), std::string("2"));
            QCOMPARE(rows.field(row, "P0_name"), std::string("Major Radius"));
        }
        QVERIFY(found);
    }

    void exportsObjectsOfVirtualightTexts() {
        const QString text = folder_.filePath("solid.vl"), include = folder_.filePath("solid.inc");
        QFile file(text);
        QVERIFY(file.open(QIODevice::WriteOnly));
        file.write(
            "Declare A = Shape [ Sphere((0,0,0), 1) ]\nSolid [ A - Shape [ Box((0,0,0), (2,2,2)) ] ]\n");
        file.close();
        QCOMPARE(runCli({"export", text, "-o", include}).status, 0);
        QFile written(include);
        QVERIFY(written.open(QIODevice::ReadOnly));
        const QByteArray objects = written.readAll();
        QVERIFY(objects.contains("#declare vl_A") && objects.contains("difference"));
        QVERIFY(!objects.contains("camera") && !objects.contains("light_source") &&
                !objects.contains("#version"));
        QCOMPARE(runCli({"check", include}).status, 0);
    }

    void exportRendersTheSame() {
        const QString exported = folder_.filePath("exported.pov"), include = folder_.filePath("exported.inc");
        QCOMPARE(runCli({"export", scene_, "-o", exported}).status, 0);
        QCOMPARE(runCli({"check", exported}).status, 0);
        QCOMPARE(runCli({"export", scene_, "-o", include}).status, 0);
        QCOMPARE(runCli({"check", include}).status, 0);
        QCOMPARE(runCli({"export", scene_, "-o", folder_.filePath("exported.xyz")}).status, 2);
    }

    /// The note that a file is not written stood beside files that had just been written.
    void filesOfTheSceneAreWrittenWithLeaveAlone() {
        const QString scene = file("writes.pov",
                                   "#fopen F \"heights.txt\" write #write (F, 1, \",\", <2, 3, 4>) #fclose F "
                                   "sphere { 0, 1 }");
        const QString written = folder_.filePath("heights.txt"), picture = folder_.filePath("writes.png");
        const QStringList render{"render", scene, "-o", picture, "-W", "8", "-H", "6"};
        const ProgramResult without = runCli(render);
        QCOMPARE(without.status, 0);
        QVERIFY(without.errors.contains("is not written until you allow it") ||
                without.output.contains("is not written until you allow it"));
        QVERIFY(!QFile::exists(written));
        const ProgramResult allowed = runCli(render + QStringList{"--allow-writes"});
        QCOMPARE(allowed.status, 0);
        QVERIFY(!allowed.errors.contains("not written") && !allowed.output.contains("not written"));
        QFile result(written);
        QVERIFY(result.open(QIODevice::ReadOnly));
        QVERIFY(result.readAll().startsWith("1,"));
        const QString outside =
            file("outside.pov", "#fopen F \"../heights.txt\" write #write (F, 1) #fclose F sphere { 0, 1 }");
        const ProgramResult refused = runCli({"render", outside, "-o", picture, "--allow-writes"});
        QCOMPARE(refused.status, 1);
        QVERIFY(
            refused.errors.contains("../heights.txt: error: the file cannot be written beside the scene"));
        // Another file that stands there is asked for by name; one that this scene wrote is not.
        const QString other =
            file("other.pov", "#fopen F \"heights.txt\" write #write (F, 2) #fclose F sphere { 0, 1 }");
        const QStringList renderOther{"render", other, "-o", picture, "-W", "8", "-H", "6", "--allow-writes"};
        const ProgramResult neighbour = runCli(renderOther);
        QCOMPARE(neighbour.status, 1);
        QVERIFY2(neighbour.errors.contains("heights.txt: error: stands there already"),
                 neighbour.errors.constData());
        QCOMPARE(runCli(render + QStringList{"--allow-writes"}).status, 0);
        QCOMPARE(runCli(renderOther + QStringList{"--replace", "heights.txt"}).status, 0);
        QCOMPARE(contentOf(written), QByteArray("2"));
    }

    /// F5: a scene was replaced by its picture.
    void onlyWhatIsOursIsReplaced() {
        const QString scene = file("kept.pov", "isosurface { function { x } pigment { rgb 1 } }");
        const QByteArray text = contentOf(scene);
        const QString picture = folder_.filePath("kept.png"), exported = folder_.filePath("kept-export.pov"),
                      empty = file("empty.png", ""), notes = file("notes.txt", "my notes");
        const auto render = [&](const QStringList& more) {
            return runCli(QStringList{"render", scene, "-W", "8", "-H", "6"} + more);
        };
        const ProgramResult over = render({"-o", scene, "--force"});
        QCOMPARE(over.status, 1);
        QVERIFY2(over.errors.contains("is the scene itself"), over.errors.constData());
        for (const QStringList& outputs : {QStringList{"-o", notes},
                                           {"-o", picture, "--hole-map", notes},
                                           {"-o", picture, "--statistics", notes}}) {
            const ProgramResult refused = render(outputs);
            QCOMPARE(refused.status, 1);
            QVERIFY2(refused.errors.contains("notes.txt: error: stands there already"),
                     refused.errors.constData());
        }
        QCOMPARE(runCli({"accuracy", scene, "--plot", notes}).status, 1);
        QCOMPARE(runCli({"export", scene, "-o", scene}).status, 1);
        QCOMPARE(runCli({"export", scene, "-o", file("by-hand.inc", "sphere { 0, 1 }")}).status, 1);
        QVERIFY(!QFile::exists(picture));
        QCOMPARE(contentOf(notes), QByteArray("my notes"));
        QCOMPARE(contentOf(scene), text);

        // Ours, empty ones and forced ones go.
        const QString statistics = folder_.filePath("kept.json");
        for (int turn = 0; turn < 2; ++turn) {
            QCOMPARE(render({"-o", picture, "--statistics", statistics}).status, 0);
            QCOMPARE(runCli({"export", scene, "-o", exported}).status, 0);
        }
        QVERIFY(contentOf(exported).startsWith("// Exported by Isoscope"));
        QCOMPARE(render({"-o", empty}).status, 0);
        QCOMPARE(render({"-o", notes, "--force"}).status, 0);
        QVERIFY(contentOf(notes).startsWith("\x89PNG"));
        QVERIFY(QDir(folder_.path()).entryList({".*.part"}, QDir::Files | QDir::Hidden).isEmpty());
    }

    /// F4, and the same for files: exit status 1 and a message.
    void outputThatIsLostIsNoSuccess() {
        const auto lost = [](const QString& arguments) {
            return runProgram("sh", {"-c", ISOSCOPE_BINARY_DIR "/isoscope-cli " + arguments});
        };
        for (const QString& command : {QStringLiteral("functions --csv"), QStringLiteral("--help")}) {
            const ProgramResult result = lost(command + " > /dev/full");
            QCOMPARE(result.status, 1);
            QVERIFY2(result.errors.contains("cannot be written"), result.errors.constData());
        }
        const QString scene = file("lost.pov", "sphere { 0, 1 pigment { rgb 1 } }");
        const ProgramResult full = runCli({"render", scene, "-o", "/dev/full", "-W", "8", "-H", "6"});
        QCOMPARE(full.status, 1);
        QVERIFY2(full.errors.contains("No space left"), full.errors.constData());
        QCOMPARE(runCli({"render", scene, "-o", "/dev/null", "-W", "8", "-H", "6"}).status, 0);
        QVERIFY(!QFileInfo("/dev/null").isFile());
    }

    void wrongUsageIsTwo() {
        QCOMPARE(runCli({}).status, 2);
        QCOMPARE(runCli({"paint"}).status, 2);
        QCOMPARE(runCli({"render", scene_}).status, 2);
        QCOMPARE(runCli({"render", scene_, "-o", "x.png", "-W", "-3"}).status, 2);
        QCOMPARE(runCli({"render", scene_, "-o", "x.png", "--declare", "Size"}).status, 2);
        QCOMPARE(runCli({"--help"}).status, 0);
    }

    void missingFilesAreErrors() {
        const ProgramResult result = runCli({"check", folder_.filePath("nowhere.pov")});
        QCOMPARE(result.status, 1);
        QVERIFY(result.errors.contains("nowhere.pov"));
        QCOMPARE(runCli({"evaluate", "--table", folder_.filePath("nowhere.csv")}).status, 1);
        QCOMPARE(runCli({"trace", scene_, "--rays", file("norays.csv", "a,b\n1,2\n")}).status, 1);
    }
};

QTEST_GUILESS_MAIN(ContractTest)
#include "contract_test.moc"
