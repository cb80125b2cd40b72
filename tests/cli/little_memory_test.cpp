// SPDX-License-Identifier: GPL-3.0-or-later
#include <QTemporaryDir>
#include <QTest>

#include "test_folders.h"
#include "tests/support/program.h"

using namespace isoscope::test;

/// However little address space there is, a command does its work or says that it cannot. Below 47 MB all of
/// them ended with an exception that was not caught.
class LittleMemoryTest : public QObject {
    Q_OBJECT

    QTemporaryDir folder_;

    static constexpr int loaderFailed = 127;

    /// isoscope-cli with that many kilobytes of addresses.
    ProgramResult within(int kilobytes, const QStringList& arguments) const {
        const QString limited =
            QStringLiteral("ulimit -c 0; ulimit -v %1 && exec \"$0\" \"$@\"").arg(kilobytes);
        return runProgram("sh", QStringList{"-c", limited, ISOSCOPE_BINARY_DIR "/isoscope-cli"} + arguments,
                          60, folder_.path());
    }

  private slots:
    void commandsEndWithAMessage_data() {
        QTest::addColumn<QStringList>("command");
        writeFile(folder_.path(), "scene.pov",
                  "#version 3.7;\n#declare Level = 1;\n"
                  "camera { location -4*z look_at 0 } light_source { -9, 1 }\n"
                  "isosurface { function { pow(x,2)+y*y+z*z-Level } contained_by { box { -1.5, 1.5 } }\n"
                  "  max_gradient 4 pigment { granite } }\n");
        writeFile(folder_.path(), "rays.csv", "ox,oy,oz,dx,dy,dz\n0.1,0.2,-5,0,0,1\n");
        const QStringList small{"-W", "32", "-H", "24"};
        for (const char* option : {"--version", "--help", "--manual", "functions"})
            QTest::newRow(option) << QStringList{option};
        for (const char* command : {"check", "ranges", "health", "thresholds"})
            QTest::newRow(command) << QStringList{command, "scene.pov"};
        QTest::newRow("render") << QStringList{"render", "scene.pov", "-o", "a.png", "--force"} + small;
        QTest::newRow("mesh") << QStringList{"mesh", "scene.pov", "-o", "a.stl", "--force"};
        QTest::newRow("trace") << QStringList{"trace", "scene.pov", "--rays", "rays.csv"};
        QTest::newRow("sweep") << QStringList{"sweep", "scene.pov", "--parameter", "Level",   "--from",
                                              "1",     "--to",      "2",           "--steps", "2"} +
                                      small;
    }

    void commandsEndWithAMessage() {
        QFETCH(QStringList, command);
        // A build that watches memory takes terabytes of addresses for that.
        if (within(4 << 20, command).status != 0)
            QSKIP("NOT TESTED: this build needs gigabytes of addresses");
        int ended = 0;
        for (int megabytes = 16; megabytes <= 128; megabytes += 3) {
            const ProgramResult result = within(megabytes << 10, command);
            if (result.status == loaderFailed) continue;
            ++ended;
            const QByteArray told = QByteArray::number(megabytes) + " MB: status " +
                                    QByteArray::number(result.status) + ' ' + result.errors.left(300);
            QVERIFY2(result.status == 0 || (result.status == 1 && !result.errors.isEmpty()), told);
        }
        QVERIFY(ended > 3);
    }
};

QTEST_GUILESS_MAIN(LittleMemoryTest)
#include "little_memory_test.moc"
