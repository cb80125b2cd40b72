// SPDX-License-Identifier: GPL-3.0-or-later
#include <QDir>
#include <QFile>
#include <QProcess>
#include <QStandardPaths>
#include <QTemporaryDir>
#include <QTest>

#include "test_folders.h"
#include "tests/support/program.h"

using namespace isoscope;
using namespace isoscope::test;

namespace {

/// Numbers are right in each frame: the sphere's size by clock, and a mark by frame_number.
const QByteArray scene =
    "#version 3.7;\nglobal_settings { assumed_gamma 1 }\ncamera { location <0, 0, -5> look_at 0 }\n"
    "light_source { <5, 5, -5> 1 }\n"
    "isosurface { function { x*x + y*y + z*z - pow(0.2 + clock, 2) } contained_by { sphere { 0, 1.5 } }\n"
    "  max_gradient 3 pigment { rgb 1 } }\n"
    "box { <-2, -2, 0>, <-1.9, -1.9 + frame_number/10, 0.1> pigment { rgb x } }\n";

const QStringList size{"-W", "40", "-H", "30"};

}  // namespace

class FramesCommandTest : public QObject {
    Q_OBJECT

    QTemporaryDir folder_;
    QString scene_;

    QString in(const QString& name) const { return folder_.filePath(name); }
    QStringList command(const QString& output, const QStringList& more = {}) const {
        return QStringList{"frames", scene_, "--first", "0", "--last", "6", "-o", in(output)} + size + more;
    }
    /// The pictures of a folder, by name.
    QMap<QString, QByteArray> pictures(const QString& folder) const {
        QMap<QString, QByteArray> found;
        const QDir dir(in(folder));
        for (const QString& name : dir.entryList(QDir::Files)) {
            QFile file(dir.filePath(name));
            if (file.open(QFile::ReadOnly)) found[name] = file.readAll();
        }
        return found;
    }
    static QStringList states(const ProgramResult& result) {
        const isoscope::CsvTable table = tableOf(result);
        QStringList found;
        for (std::size_t i = 0; i < table.rowCount(); ++i)
            found << QString::fromStdString(table.field(i, "state"));
        return found;
    }

  private slots:
    void initTestCase() {
        scene_ = writeFile(folder_.path(), "ball.pov", scene);
        const ProgramResult whole = runCli(command("whole/ball"));
        QVERIFY2(whole.status == 0 && whole.errors.isEmpty(), whole.errors.constData());
        QCOMPARE(states(whole), QStringList(7, "drawn"));
    }

    void aFrameIsThePictureOfItsClock() {
        QCOMPARE(pictures("whole").keys(), (QStringList{"ball0.png", "ball1.png", "ball2.png", "ball3.png",
                                                        "ball4.png", "ball5.png", "ball6.png"}));
        const QString one = in("one.png");
        QCOMPARE(runCli(QStringList{"render", scene_, "-o", one, "--frame", "3", "--final-frame", "6",
                                    "--clock", "0.5"} +
                        size)
                     .status,
                 0);
        QFile file(one);
        QVERIFY(file.open(QFile::ReadOnly));
        QCOMPARE(pictures("whole")["ball3.png"], file.readAll());
        QVERIFY(pictures("whole")["ball2.png"] != pictures("whole")["ball3.png"]);
    }

    /// Two calls side by side, as on two machines with one disk.
    void partsAtTheSameTimeMakeTheWhole() {
        QProcess one, two;
        one.start(ISOSCOPE_BINARY_DIR "/isoscope-cli", command("parts/ball", {"--part", "1/2"}));
        two.start(ISOSCOPE_BINARY_DIR "/isoscope-cli", command("parts/ball", {"--part", "2/2"}));
        QVERIFY(one.waitForFinished(60000) && two.waitForFinished(60000));
        QCOMPARE(one.exitCode(), 0);
        QCOMPARE(two.exitCode(), 0);
        QCOMPARE(one.readAllStandardOutput().count("drawn"), 4);
        QCOMPARE(two.readAllStandardOutput().count("drawn"), 3);
        QVERIFY(pictures("parts") == pictures("whole"));
    }

    void whatIsDoneIsSkipped() {
        QCOMPARE(runCli(command("again/ball", {"--part", "2/3"})).status, 0);
        const auto before = pictures("again");
        QCOMPARE(before.size(), 2);
        // A call that was ended in the middle leaves whole pictures or none.
        QFile broken(in("again/ball6.png"));
        QVERIFY(broken.open(QFile::WriteOnly));
        broken.close();
        const ProgramResult rest = runCli(command("again/ball"));
        QCOMPARE(rest.status, 0);
        QCOMPARE(states(rest), (QStringList{"drawn", "kept", "drawn", "drawn", "kept", "drawn", "drawn"}));
        QVERIFY(pictures("again") == pictures("whole"));
        QCOMPARE(states(runCli(command("again/ball"))), QStringList(7, "kept"));
        QCOMPARE(states(runCli(command("again/ball", {"--force"}))), QStringList(7, "drawn"));
        // Another size, and a scene that was changed since.
        QStringList wider = command("again/ball", {"--part", "1/7"});
        wider[wider.indexOf("-W") + 1] = "41";
        QCOMPARE(states(runCli(wider)), QStringList{"drawn"});
        QFile changed(scene_);
        QVERIFY(changed.open(QFile::ReadWrite));
        const QDateTime was = changed.fileTime(QFile::FileModificationTime);
        QVERIFY(changed.setFileTime(QDateTime::currentDateTime().addSecs(60), QFile::FileModificationTime));
        QCOMPARE(states(runCli(command("again/ball", {"--part", "2/7"}))), QStringList{"drawn"});
        QVERIFY(changed.setFileTime(was, QFile::FileModificationTime));
        // The clock was set back since, so that what is older cannot be told.
        QFile ahead(in("again/ball1.png"));
        QVERIFY(ahead.open(QFile::ReadWrite));
        QVERIFY(ahead.setFileTime(QDateTime::currentDateTime().addDays(1), QFile::FileModificationTime));
        ahead.close();
        for (const char* state : {"drawn", "kept"})
            QCOMPARE(states(runCli(command("again/ball", {"--part", "2/7"}))), QStringList{state});
    }

    void theClockHasOtherEnds() {
        const ProgramResult result =
            runCli(command("ends/ball", {"--first-clock", "2", "--last-clock", "-1", "--part", "3/3"}));
        QCOMPARE(result.status, 0);
        const isoscope::CsvTable table = tableOf(result);
        QCOMPARE(table.number(0, "frame", -1), 2.0);
        QCOMPARE(table.number(0, "clock", 9), 1.0);
        QCOMPARE(table.number(1, "clock", 9), -0.5);
    }

    void aFrameWithAnErrorIsToldAndTheOthersAreDrawn() {
        const QString bad =
            writeFile(folder_.path(), "bad.pov", scene + "#if (frame_number = 1) nonsense { #end\n");
        const ProgramResult result =
            runCli(QStringList{"frames", bad, "--first", "0", "--last", "2", "-o", in("bad/f")} + size);
        QCOMPARE(result.status, 1);
        QCOMPARE(states(result), (QStringList{"drawn", "error", "drawn"}));
        QVERIFY2(result.errors.contains("bad.pov:8"), result.errors.constData());
        QCOMPARE(pictures("bad").keys(), (QStringList{"f0.png", "f2.png"}));
    }

    void filesOfOthersStay() {
        QVERIFY(QDir(folder_.path()).mkdir("others"));
        writeFile(in("others"), "ball0.png", "my notes");
        const ProgramResult result = runCli(command("others/ball", {"--part", "1/7"}));
        QCOMPARE(result.status, 1);
        QCOMPARE(states(result), QStringList{"error"});
        QCOMPARE(pictures("others")["ball0.png"], QByteArray("my notes"));
    }

    void wrongUsageIsRefused() {
        QCOMPARE(runCli({"frames", scene_, "--first", "0"}).status, 2);
        QCOMPARE(runCli({"frames", scene_, "--first", "3", "--last", "2"}).status, 2);
        QCOMPARE(runCli(command("x/x", {"--part", "3/2"})).status, 2);
        QCOMPARE(runCli(command("x/x", {"--clock", "1"})).status, 2);
        QCOMPARE(runCli({"frames", in("gone.pov"), "--first", "0", "--last", "2"}).status, 1);
        QVERIFY(!QDir(in("x")).exists());
    }

    /// Frames, clock and numbers are those of the scene's timeline; what is given counts before it.
    void theTimelineOfTheSceneIsDrawn() {
        const QString keyed = writeFile(
            folder_.path(), "keyed.pov",
            "#version 3.7;\nglobal_settings { assumed_gamma 1 }\n#declare R = 0.2;\n"
            "camera { location <0, 0, -5> look_at 0 }\nlight_source { <5, 5, -5> 1 }\n"
            "sphere { 0, R pigment { rgb 1 } }\n// timeline: frames 8 to 12, clock 1 to 3, 25 per second\n"
            "// keys \"R\": 8 = 0.5 linear, 12 = 1.5\n// keys \"camera azimuth\": 8 = 0, 12 = 90\n");
        const ProgramResult all = runCli(QStringList{"frames", keyed, "-o", in("keyed/f")} + size);
        QVERIFY2(all.status == 0, all.errors.constData());
        const isoscope::CsvTable table = tableOf(all);
        QCOMPARE(table.rowCount(), 5u);
        QCOMPARE(table.number(0, "frame", -1), 8.0);
        QCOMPARE(table.number(1, "clock", -1), 1.5);
        QCOMPARE(pictures("keyed").keys(),
                 (QStringList{"f08.png", "f09.png", "f10.png", "f11.png", "f12.png"}));
        // The same by hand, and by the scene for POV-Ray.
        const QString moved =
            writeFile(folder_.path(), "moved.pov",
                      "#version 3.7;\nglobal_settings { assumed_gamma 1 }\n#declare R = 1;\n"
                      "camera { location <5*sin(radians(45)), 0, -5*cos(radians(45))> look_at 0 }\n"
                      "light_source { <5, 5, -5> 1 }\nsphere { 0, R pigment { rgb 1 } }\n");
        const auto pictureOf = [&](const QString& scene, const QStringList& more) {
            runCli(QStringList{"render", scene, "-o", in("one.png"), "--force"} + more + size);
            QFile file(in("one.png"));
            return file.open(QFile::ReadOnly) ? file.readAll() : QByteArray();
        };
        QCOMPARE(pictureOf(moved, {}), pictures("keyed")["f10.png"]);
        QCOMPARE(pictureOf(keyed, {"--clock", "2"}), pictures("keyed")["f10.png"]);
        QVERIFY(pictureOf(keyed, {}) != pictures("keyed")["f10.png"]);
        QCOMPARE(
            runCli(QStringList{"export", keyed, "--animation", "-o", in("for-povray.pov")} + size).status, 0);
        QCOMPARE(pictureOf(in("for-povray.pov"), {"--clock", "2"}), pictures("keyed")["f10.png"]);
        QFile settings(in("for-povray.ini"));
        QVERIFY(settings.open(QFile::ReadOnly));
        QVERIFY(settings.readAll().contains("Final_Frame=12\nInitial_Clock=1\nFinal_Clock=3\nWidth=40\n"));
        const QString unknown = writeFile(folder_.path(), "unknown.pov",
                                          "camera { location -5*z } light_source { 9 1 } sphere { 0, 1 }\n"
                                          "// keys \"Gone\": 0 = 1\n");
        const ProgramResult told =
            runCli(QStringList{"frames", unknown, "--last", "2", "-o", in("unknown/f")} + size);
        QCOMPARE(told.status, 0);
        QCOMPARE(told.errors.count("`Gone`"), 1);
        const ProgramResult part =
            runCli(QStringList{"frames", keyed, "--first", "10", "-o", in("part/f")} + size);
        QCOMPARE(tableOf(part).rowCount(), 3u);
        QVERIFY(pictures("part")["f10.png"] == pictures("keyed")["f10.png"]);
    }

    /// As docs/animation.md has it.
    void gnuParallelSharesThemOut() {
        const QString parallel = QStandardPaths::findExecutable("parallel");
        if (parallel.isEmpty() || !runProgram(parallel, {"--version"}).output.startsWith("GNU parallel"))
            QSKIP("GNU parallel is missing");
        const QStringList work{ISOSCOPE_BINARY_DIR "/isoscope-cli"};
        const ProgramResult result = runProgram(
            parallel, QStringList{"--jobs", "2"} + work + command("parallel/ball", {"--threads", "1"}) +
                          QStringList{"--part", "{}/3", ":::", "1", "2", "3"});
        QVERIFY2(result.status == 0, result.errors.constData());
        QVERIFY(pictures("parallel") == pictures("whole"));
    }
};

QTEST_GUILESS_MAIN(FramesCommandTest)
#include "frames_command_test.moc"
