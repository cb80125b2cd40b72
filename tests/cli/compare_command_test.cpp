// SPDX-License-Identifier: GPL-3.0-or-later
#include <signal.h>

#include <QProcess>
#include <QTemporaryDir>
#include <QTest>

#include "core/exchange/png.h"
#include "test_folders.h"
#include "tests/support/csv_table.h"
#include "tests/support/povray.h"
#include "tests/support/program.h"

using namespace isoscope::test;

namespace {

/// A process that has ended has no command line, whether or not its status was asked for.
bool runs(const QByteArray& process) {
    QFile file("/proc/" + process + "/cmdline");
    return file.open(QIODevice::ReadOnly) && !file.readAll().isEmpty();
}

}  // namespace

class CompareCommandTest : public QObject {
    Q_OBJECT

    QTemporaryDir folder_;

  private slots:
    void differencesAreCountedByCause() {
        if (!hasPovray()) QSKIP(povrayIsMissing);
        const QString scene = writeFile(
            folder_.path(), "ball.pov",
            "#version 3.7;\nglobal_settings { assumed_gamma 1 }\n#ifndef (Steep) #declare Steep = 4; #end\n"
            "camera { location <2.2, 1.6, -2.9> look_at 0 angle 45 }\nlight_source { <4, 6, -5> rgb 0.9 }\n"
            "isosurface { function { x*x + y*y + z*z - 1 } contained_by { sphere { 0, 1.2 } } max_gradient "
            "Steep "
            "pigment { rgb <0.85, 0.3, 0.25> } }\n");
        const QString picture = folder_.filePath("difference.png"), theirs = folder_.filePath("povray.png");
        const QStringList compare{"compare", scene, "-W", "160", "-H", "120"};
        const ProgramResult right = runCli(compare);
        QCOMPARE(right.status, 0);
        QVERIFY(tableOf(right).number(1, "pixels", 1e9) < 40);
        const ProgramResult low = runCli(
            compare + QStringList{"--declare", "Steep=1.1", "-o", picture, "--povray-picture", theirs});
        QCOMPARE(low.status, 0);
        const isoscope::CsvTable rows = tableOf(low);
        QCOMPARE(rows.field(0, "cause"), std::string("all"));
        QCOMPARE(rows.number(0, "pixels", 0), 160.0 * 120);
        QCOMPARE(rows.field(1, "cause"), std::string("differing"));
        QVERIFY(rows.number(1, "pixels", 0) > 500);
        double sum = 0;
        for (std::size_t row = 2; row < rows.rowCount(); ++row) sum += rows.number(row, "pixels", 0);
        QCOMPARE(sum, rows.number(1, "pixels", 0));
        QCOMPARE(isoscope::readPng(picture.toStdString()).width, 160);
        QCOMPARE(isoscope::readPng(theirs.toStdString()).height, 120);
    }

    void scenesThatWriteElsewhereAreRefused() {
        const QString written = folder_.filePath("written.txt");
        const QString scene = writeFile(
            folder_.path(), "writes.pov",
            "#fopen F \"" + written.toLocal8Bit() + "\" write #write (F, 1) #fclose F sphere { 0, 1 }");
        const ProgramResult result = runCli({"compare", scene});
        QCOMPARE(result.status, 1);
        QVERIFY2(result.errors.contains("outside of its folder"), result.errors.constData());
        QVERIFY(!QFile::exists(written));
    }

    /// It went on drawing in vain: a signal of the terminal, or a kill, reached the command alone.
    void povrayEndsWithTheCommand_data() {
        QTest::addColumn<int>("signal");
        QTest::newRow("Ctrl+C") << SIGINT;
        QTest::newRow("kill") << SIGTERM;
        QTest::newRow("kill -9") << SIGKILL;
    }

    void povrayEndsWithTheCommand() {
        QFETCH(int, signal);
        const QString program =
            writeFile(folder_.path(), "povray",
                      "#!/bin/sh\necho $$ > " + folder_.filePath("id").toLocal8Bit() + "\nexec sleep 300\n");
        QVERIFY(QFile::setPermissions(program, QFile::ReadOwner | QFile::WriteOwner | QFile::ExeOwner));
        QFile::remove(folder_.filePath("id"));
        QProcess command;
        QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
        environment.insert("PATH", folder_.path() + ':' + environment.value("PATH"));
        environment.insert("TMPDIR", folder_.path());
        command.setProcessEnvironment(environment);
        command.start(ISOSCOPE_BINARY_DIR "/isoscope-cli",
                      {"compare", writeFile(folder_.path(), "ball.pov", "sphere { 0, 1 }\n")});
        QByteArray povray;
        const auto begun = [&] {
            QFile file(folder_.filePath("id"));
            if (file.open(QIODevice::ReadOnly)) povray = file.readAll();
            return povray.endsWith('\n') && runs(povray.trimmed());
        };
        QTRY_VERIFY_WITH_TIMEOUT(begun(), 30000);
        QCOMPARE(::kill(static_cast<pid_t>(command.processId()), signal), 0);
        QVERIFY(command.waitForFinished());
        QTRY_VERIFY_WITH_TIMEOUT(!runs(povray.trimmed()), 30000);
    }
};

QTEST_GUILESS_MAIN(CompareCommandTest)
#include "compare_command_test.moc"
