// SPDX-License-Identifier: GPL-3.0-or-later
#include <QImage>
#include <QProcess>
#include <QTemporaryDir>
#include <QtTest>

#include "tests/app/window_driver.h"

/// The program as a whole, from its command line.
class ProgramTest : public QObject {
    Q_OBJECT

    QTemporaryDir folder_;

    struct Outcome {
        int status = -1;
        QString output;
    };
    static Outcome run(const QStringList& arguments) {
        QProcess process;
        process.start(QStringLiteral(ISOSCOPE_BINARY_DIR "/isoscope"), arguments);
        if (!process.waitForFinished(120000)) {
            process.kill();
            process.waitForFinished();
            return {};
        }
        return {process.exitStatus() == QProcess::NormalExit ? process.exitCode() : -1,
                QString::fromUtf8(process.readAllStandardOutput())};
    }

  private slots:
    void versionAndHelp() {
        const Outcome version = run({QStringLiteral("--version")});
        QCOMPARE(version.status, 0);
        QVERIFY(version.output.startsWith(QStringLiteral("isoscope ")));
        const Outcome help = run({QStringLiteral("--help")});
        QCOMPARE(help.status, 0);
        QVERIFY(help.output.contains(QStringLiteral("--screenshot")));
    }

    void wrongUsage() {
        QCOMPARE(run({QStringLiteral("--size"), QStringLiteral("large")}).status, 2);
        QCOMPARE(run({QStringLiteral("a.pov"), QStringLiteral("b.pov")}).status, 2);
    }

    void screenshotOfAFile() {
        const QString picture = folder_.filePath(QStringLiteral("window.png"));
        const Outcome shot =
            run({QStringLiteral("--screenshot"), picture, QStringLiteral("--size"),
                 QStringLiteral("1280x800"), QStringLiteral("--theme"), QStringLiteral("dark"),
                 QStringLiteral(ISOSCOPE_SOURCE_DIR "/examples/sphere.pov")});
        QVERIFY2(shot.status == 0, qPrintable(shot.output));
        const QImage window(picture);
        QCOMPARE(window.size(), QSize(1280, 800));
        QVERIFY(isoscope::test::distinctColors(window) > 500);
    }

    void screenshotThatCannotBeWritten() {
        QCOMPARE(
            run({QStringLiteral("--screenshot"), folder_.filePath(QStringLiteral("no/folder/a.png"))}).status,
            1);
    }
};

QTEST_MAIN(ProgramTest)
#include "program_test.moc"
