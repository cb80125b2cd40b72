// SPDX-License-Identifier: GPL-3.0-or-later
#include <QFile>
#include <QStandardPaths>
#include <QTemporaryDir>
#include <QTest>

#include "test_folders.h"
#include "tests/support/program.h"

using namespace isoscope::test;

/// What the start of the program runs.
class StartCostTest : public QObject {
    Q_OBJECT

  private slots:
    /// It took 4 ms, and an instruction at which Valgrind ended the program on some machines.
    void highwayMeasuresNoClock() {
        if (QStandardPaths::findExecutable("valgrind").isEmpty()) QSKIP("NOT MEASURED: valgrind is missing");
        const QTemporaryDir folder;
        const QString counts = folder.filePath("counts");
        const ProgramResult run = runProgram(
            "valgrind", {"--tool=callgrind", "--compress-strings=no", "--callgrind-out-file=" + counts,
                         ISOSCOPE_BINARY_DIR "/isoscope-cli", "--version"});
        QVERIFY2(run.status == 0, run.errors.constData());
        QFile file(counts);
        QVERIFY(file.open(QIODevice::ReadOnly));
        const QString text = QString::fromUtf8(file.readAll());
        // Costs of functions stand below the name of their library.
        bool measured = false, libraryIsThere = false;
        for (const QString& library : text.split("\nob=").mid(1)) {
            if (!library.section('\n', 0, 0).contains("libhwy")) continue;
            libraryIsThere = true;
            measured = measured || library.contains("\nfn=hwy::platform::TimerResolution()");
        }
        QVERIFY(libraryIsThere);
        QVERIFY(!measured);
    }
};

QTEST_GUILESS_MAIN(StartCostTest)
#include "start_cost_test.moc"
