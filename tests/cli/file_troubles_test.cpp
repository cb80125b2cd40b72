// SPDX-License-Identifier: GPL-3.0-or-later
#include <QDir>
#include <QFile>
#include <QProcess>
#include <QTest>

#include "test_folders.h"
#include "tests/support/small_disk.h"

using namespace isoscope::test;

/// What may happen to the files of a command: it says the reason, ends with 1, and leaves what was there.
class FileTroublesTest : public QObject {
    Q_OBJECT

    std::unique_ptr<SmallDisk> disk_;
    QTemporaryDir folder_;
    QString scene_;

    static QByteArray sceneText() {
        return "#version 3.7;\n#declare Level = 1;\n"
               "camera { location -4*z look_at 0 } light_source { -9, 1 }\n"
               "isosurface { function { pow(x,2)+y*y+z*z-Level } contained_by { box { -1.5, 1.5 } }\n"
               "  max_gradient 4 pigment { granite } }\n";
    }
    static QByteArray contentOf(const QString& path) {
        QFile file(path);
        return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray("(no file)");
    }

    /// A command that writes `name` on the small disk.
    ProgramResult write(const QString& name) const {
        const QString output = disk_->path(name);
        QStringList arguments{"render", scene_, "-o", output, "-W", "64", "-H", "48"};
        if (name == "out.pov") arguments = {"export", scene_, "-o", output, "--force"};
        if (name == "changed.pov")
            arguments = {"gradient", scene_, "--boxes", "100", "--write", output, "--force"};
        if (name == "out.json")
            arguments = {"render",       scene_, "-o",     folder_.filePath("picture.png"),
                         "-W",           "8",    "-H",     "6",
                         "--statistics", output, "--force"};
        if (name == "out1.png")
            arguments = {"frames",           scene_, "--first", "1",  "--last", "1", "-o",
                         disk_->path("out"), "-W",   "64",      "-H", "48"};
        return runCli(arguments);
    }

  private slots:
    void initTestCase() { scene_ = writeFile(folder_.path(), "scene.pov", sceneText()); }
    void init() { disk_ = std::make_unique<SmallDisk>(); }
    void cleanup() { disk_.reset(); }

    void outputsAreWholeOrNotThere_data() {
        QTest::addColumn<QString>("name");
        QTest::addColumn<bool>("full");
        for (const char* name : {"out.png", "out.pov", "changed.pov", "out.json", "out1.png"}) {
            QTest::addRow("%s, full", name) << QString(name) << true;
            QTest::addRow("%s, read-only", name) << QString(name) << false;
        }
    }

    void outputsAreWholeOrNotThere() {
        QFETCH(QString, name);
        QFETCH(bool, full);
        if (!disk_->mounted()) QSKIP("a file system can be mounted by root only");
        const auto spoil = [&] { full ? disk_->fill() : disk_->setReadOnly(true); };
        const auto mend = [&] { full ? disk_->empty() : disk_->setReadOnly(false); };
        const QByteArray reason = full ? "No space left on device" : "Read-only file system";

        spoil();
        const ProgramResult first = write(name);
        QCOMPARE(first.status, 1);
        QVERIFY2(first.errors.contains(reason), first.errors);
        QVERIFY(!QFile::exists(disk_->path(name)));
        mend();
        const ProgramResult good = write(name);
        QVERIFY2(good.status == 0 || name == "changed.pov", good.errors);
        if (name == "out1.png") return;  // a frame that is there is kept
        const QByteArray before = contentOf(disk_->path(name));
        QVERIFY2(before.size() > 20, good.errors);
        spoil();
        const ProgramResult second = write(name);
        QCOMPARE(second.status, 1);
        QVERIFY2(second.errors.contains(reason), second.errors);
        QCOMPARE(contentOf(disk_->path(name)), before);
        mend();
        QCOMPARE(QDir(disk_->path({})).entryList(QDir::Files | QDir::Hidden), QStringList{name});
    }

    /// Each table is an answer: a part of one is none.
    void aLostStandardOutputIsAFailure_data() {
        QTest::addColumn<QStringList>("command");
        const QString table = writeFile(folder_.path(), "rays.csv",
                                        "case_id,function,threshold,container,ox,oy,oz,dx,dy,dz\n"
                                        "a,x*x+y*y+z*z-1,0,\"box{<-2,-2,-2>,<2,2,2>}\",-5,0,0,1,0,0\n");
        const QString points = writeFile(folder_.path(), "points.csv", "x,y,z\n0,0,0\n");
        const QString equations =
            writeFile(folder_.path(), "equations.csv", "case_id,coefficients,lo,hi\na,1;0;-1,-2,2\n");
        QTest::newRow("roots") << QStringList{"roots", "--table", table};
        QTest::newRow("inside") << QStringList{"inside", scene_, "--points", points};
        QTest::newRow("trace") << QStringList{"trace", scene_, "--rays", table};
        QTest::newRow("polynomial") << QStringList{"polynomial", "--table", equations};
        QTest::newRow("gradient") << QStringList{"gradient", scene_, "--boxes", "100"};
        QTest::newRow("functions") << QStringList{"functions"};
        QTest::newRow("frames") << QStringList{"frames", scene_, "--first", "1",
                                               "--last", "1",    "-o",      folder_.filePath("frame"),
                                               "-W",     "8",    "-H",      "6"};
        QTest::newRow("container") << QStringList{"container", scene_};
        for (const char* command : {"accuracy", "evaluate-advice", "predict"})
            QTest::newRow(command) << QStringList{command, scene_, "-W", "16", "-H", "12"};
        for (const char* command : {"derivative", "health", "ranges", "report", "rewrites", "thresholds"})
            QTest::newRow(command) << QStringList{command, scene_};
        QTest::newRow("difference") << QStringList{"difference", scene_, "--with", scene_};
        QTest::newRow("mesh") << QStringList{"mesh", scene_, "-o", folder_.filePath("lost.stl")};
        QTest::newRow("sweep") << QStringList{"sweep", scene_, "--parameter", "Level",   "--from",
                                              "1",     "--to", "2",           "--steps", "2",
                                              "-W",    "16",   "-H",          "12"};
        QTest::newRow("help") << QStringList{"render", "--help"};
    }

    void aLostStandardOutputIsAFailure() {
        QFETCH(QStringList, command);
        QProcess process;
        process.setStandardOutputFile("/dev/full");
        process.start(QStringLiteral(ISOSCOPE_BINARY_DIR "/isoscope-cli"), command);
        QVERIFY(process.waitForFinished());
        const QByteArray errors = process.readAllStandardError();
        QVERIFY2(process.exitStatus() == QProcess::NormalExit, errors);
        QVERIFY2(errors.contains("standard output cannot be written"), errors);
        QCOMPARE(process.exitCode(), 1);
    }

    /// Every file that a command writes, where none can be: OUT is a device that is full, a file below a
    /// file, a file in no folder, a folder.
    void anOutputThatCannotBeWrittenIsSaid_data() {
        QTest::addColumn<QString>("ending");
        QTest::addColumn<QStringList>("command");
        const QString table = writeFile(folder_.path(), "lines.csv",
                                        "case_id,function,threshold,container,ox,oy,oz,dx,dy,dz\n"
                                        "a,x*x+y*y+z*z-1,0,\"box{<-2,-2,-2>,<2,2,2>}\",-5,0,0,1,0,0\n");
        const QString picture = folder_.filePath("beside.png");
        const auto small = [](const QStringList& command) {
            return command + QStringList{"-W", "16", "-H", "12"};
        };
        const auto add = [](const char* name, const char* ending, const QStringList& command) {
            QTest::newRow(name) << QString(ending) << command;
        };
        add("picture", "png", small({"render", scene_, "-o", "OUT"}));
        add("layers", "exr", small({"render", scene_, "-o", "OUT"}));
        add("hole map", "png", small({"render", scene_, "-o", picture, "--hole-map", "OUT"}));
        add("cost map", "png", small({"render", scene_, "-o", picture, "--cost-map", "OUT"}));
        add("statistics", "json", small({"render", scene_, "-o", picture, "--statistics", "OUT"}));
        for (const char* ending : {"stl", "obj", "ply", "3mf", "glb", "inc"})
            add(ending, ending, {"mesh", scene_, "-o", "OUT"});
        add("sheet", "png",
            small({"sheet", scene_, "-o", "OUT", "--parameter", "Level", "--from", "1", "--to", "2"}));
        add("chart", "png", small({"accuracy", scene_, "--plot", "OUT"}));
        add("containers", "pov", {"container", scene_, "--write", "OUT"});
        add("gradients", "pov", {"gradient", scene_, "--boxes", "100", "--write", "OUT"});
        add("rewrite", "pov", {"rewrites", scene_, "--apply", "1", "-o", "OUT"});
        add("proof", "csv", {"roots", "--table", table, "--proof", "OUT"});
        for (const char* ending : {"pov", "inc", "vl"})
            QTest::addRow("export of %s", ending)
                << QString(ending) << QStringList{"export", scene_, "-o", "OUT"};
        add("animation", "pov", {"export", scene_, "--animation", "-o", "OUT"});
    }

    void anOutputThatCannotBeWrittenIsSaid() {
        QFETCH(QString, ending);
        QFETCH(QStringList, command);
        const QString device = folder_.filePath("full." + ending),
                      folder = folder_.filePath("folder." + ending);
        QFile::remove(device);
        QVERIFY(QFile::link("/dev/full", device) && QDir().mkpath(folder));
        const QList<std::pair<QString, QByteArray>> outputs{
            {device, "No space left on device"},
            {scene_ + "/out." + ending, "Not a directory"},
            {folder_.filePath("no/such/out." + ending), "No such file or directory"},
            {folder, "Is a directory"}};
        for (const auto& [output, reason] : outputs) {
            const ProgramResult result = runCli(QStringList(command).replaceInStrings("OUT", output), 60);
            QCOMPARE(result.status, 1);
            const QByteArray told = output.toUtf8() + ": error: the file cannot be written: " + reason;
            QVERIFY2(result.errors.contains(told), told + " | " + result.errors.left(500));
        }
        QVERIFY(QFileInfo(device).isSymLink() && QFileInfo(folder).isDir());
        QCOMPARE(contentOf(scene_), sceneText());
    }

    /// A reader that goes away (`| head -1`) ends the program, quietly and with what the shell expects.
    void aReaderThatGoesAwayDoesNoHarm() {
        const ProgramResult result = runProgram("bash", {"-c", "set -o pipefail; '" ISOSCOPE_BINARY_DIR
                                                               "/isoscope-cli' functions --csv | head -1"});
        QVERIFY2(result.status == 141 || result.status == 1 || result.status == 0,
                 QByteArray::number(result.status));
        QCOMPARE(result.output.count('\n'), 1);
    }

    /// What a scene needs is gone, or is no file: a message with the name, for every command.
    void whatCannotBeReadIsSaid_data() {
        QTest::addColumn<QString>("path");
        const QString removed = writeFile(folder_.path(), "removed.pov", "sphere { 0, 1 }");
        QFile::remove(removed);
        QTest::newRow("removed") << removed;
        QTest::newRow("folder") << folder_.path();
        QTest::newRow("device") << QString("/dev/zero");
        QTest::newRow("below a file") << scene_ + "/scene.pov";
        QTest::newRow("link to itself") << folder_.filePath("itself.pov");
        QTest::newRow("name of 5000 characters") << folder_.filePath(QString(5000, QLatin1Char('n')));
        QTest::newRow("no name") << QString();
    }

    void whatCannotBeReadIsSaid() {
        QFETCH(QString, path);
        QFile::link(folder_.filePath("itself.pov"), folder_.filePath("itself.pov"));
        const QString output = folder_.filePath("unread.png");
        const QList<QStringList> commands{{"check", path},
                                          {"render", path, "-o", output},
                                          {"export", path, "-o", folder_.filePath("unread.pov")},
                                          {"gradient", path},
                                          {"container", path},
                                          {"accuracy", path},
                                          {"evaluate", "--table", path},
                                          {"roots", "--table", path},
                                          {"polynomial", "--table", path},
                                          {"trace", scene_, "--rays", path},
                                          {"inside", scene_, "--points", path}};
        for (const QStringList& command : commands) {
            const ProgramResult result = runCli(command, 20);
            QVERIFY2(result.status == 1 || result.status == 2, qPrintable(command.join(' ')));
            QVERIFY2(!result.errors.isEmpty(), qPrintable(command.join(' ')));
        }
        QVERIFY(!QFile::exists(output));
        QVERIFY(!QFile::exists(folder_.filePath("unread.pov")));
    }

    /// The scene is read once: a file that goes while it is drawn changes nothing.
    void aSceneRemovedWhileItIsDrawnIsDrawn() {
        const QString scene =
            writeFile(folder_.path(), "going.pov",
                      "#version 3.7;\n#warning \"all is read\"\nisosurface { function {\n"
                      "  sum(i,1,1e4,sum(j,1,1e4,sum(k,1,1e4,sin(i*x+j*y+k*z))))-1 } contained_by { box { "
                      "-1, 1 } } pigment { rgb 1 } }\n");
        const QString output = folder_.filePath("going.png");
        QProcess process;
        process.start(QStringLiteral(ISOSCOPE_BINARY_DIR "/isoscope-cli"),
                      {"render", scene, "-o", output, "-W", "64", "-H", "48", "--picture-limit", "3",
                       "--solver", "certified"});
        QVERIFY(process.waitForStarted());
        QByteArray errors;
        process.setReadChannel(QProcess::StandardError);
        while (!errors.contains("all is read") && process.waitForReadyRead(20000))
            errors += process.readAllStandardError();
        QVERIFY2(errors.contains("all is read"), errors);
        QVERIFY(QFile::remove(scene));
        QVERIFY(process.state() == QProcess::NotRunning || process.waitForFinished(60000));
        errors += process.readAllStandardError();
        QCOMPARE(process.exitStatus(), QProcess::NormalExit);
        QVERIFY2(errors.contains("drawing was cut off after 3 seconds"), errors);
        QVERIFY(QFile::exists(output));
    }
};

QTEST_GUILESS_MAIN(FileTroublesTest)
#include "file_troubles_test.moc"
