// SPDX-License-Identifier: GPL-3.0-or-later
#include <QFile>
#include <QImage>
#include <QProcess>
#include <QProcessEnvironment>
#include <QTemporaryDir>
#include <QTest>

#include "test_folders.h"
#include "tests/app/window_driver.h"
#include "tests/support/comma_locale.h"

/// The program as a whole, from its command line.
class ProgramTest : public QObject {
    Q_OBJECT

    QTemporaryDir folder_;

    struct Outcome {
        int status = -1;
        QString output;
        QString errors;
    };
    /// `changed` are variables of the environment; those without a value are taken out.
    static Outcome run(const QStringList& arguments, const QMap<QString, QString>& changed = {}) {
        QProcess process;
        QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
        for (const auto& [name, value] : changed.asKeyValueRange())
            value.isEmpty() ? environment.remove(name) : environment.insert(name, value);
        process.setProcessEnvironment(environment);
        process.start(QStringLiteral(ISOSCOPE_BINARY_DIR "/isoscope"), arguments);
        if (!process.waitForFinished(120000)) {
            process.kill();
            process.waitForFinished();
            return {};
        }
        return {process.exitStatus() == QProcess::NormalExit ? process.exitCode() : -1,
                QString::fromUtf8(process.readAllStandardOutput()),
                QString::fromUtf8(process.readAllStandardError())};
    }
    static QMap<QString, QString> noDisplay() {
        return {{"QT_QPA_PLATFORM", ""}, {"DISPLAY", ""}, {"WAYLAND_DISPLAY", ""}};
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

    /// Qt aborts where it finds nothing to draw on, with the advice to install the program anew.
    void theReasonIsToldWhereThereIsNoDisplay_data() {
        QTest::addColumn<QString>("variable");
        QTest::addColumn<QString>("value");
        QTest::addColumn<QString>("told");
        QTest::newRow("none") << "DISPLAY"
                              << ""
                              << "there is no display: neither DISPLAY nor";
        QTest::newRow("a wrong one") << "DISPLAY"
                                     << ":4242"
                                     << "the display cannot be used (DISPLAY=:4242)";
        QTest::newRow("a wrong platform") << "QT_QPA_PLATFORM"
                                          << "none"
                                          << "the platform \"none\"";
    }

    void theReasonIsToldWhereThereIsNoDisplay() {
        QFETCH(QString, variable);
        QFETCH(QString, value);
        QFETCH(QString, told);
        QMap<QString, QString> environment = noDisplay();
        environment[variable] = value;
        const Outcome outcome = run({}, environment);
        QCOMPARE(outcome.status, 1);
        QVERIFY2(outcome.errors.contains("isoscope: " + told), qPrintable(outcome.errors));
        QVERIFY2(outcome.errors.contains("isoscope-cli"), qPrintable(outcome.errors));
        const Outcome help = run({"--help"}, environment);
        QCOMPARE(help.status, 0);
        QVERIFY(help.output.contains("--screenshot"));
    }

    void missingFontsAreTold() {
        const QString none = isoscope::test::writeFile(
            folder_.path(), "fonts.conf", "<?xml version=\"1.0\"?>\n<fontconfig></fontconfig>\n");
        const Outcome without =
            run({"--screenshot", folder_.filePath("fonts.png"), ISOSCOPE_SOURCE_DIR "/examples/sphere.pov"},
                {{"FONTCONFIG_FILE", none}});
        QCOMPARE(without.status, 0);
        QVERIFY2(without.errors.contains("isoscope: no fonts are installed"), qPrintable(without.errors));
    }

    /// The picture of the surface needs no OpenGL, and the panels that do say that there is none.
    void theWindowWorksWithoutOpenGl() {
        const QStringList shot{"--screenshot", folder_.filePath("opengl.png"), "--size", "1280x800",
                               ISOSCOPE_SOURCE_DIR "/examples/sphere.pov"};
        const Outcome without = run(shot, {{"__EGL_VENDOR_LIBRARY_DIRS", folder_.path()}});
        QCOMPARE(without.status, 0);
        QVERIFY(isoscope::test::distinctColors(QImage(folder_.filePath("opengl.png"))) > 500);
        // They are not waited for.
        QVERIFY2(!without.errors.contains("not everything is drawn"), qPrintable(without.errors));
    }

    /// Exceptions were not caught: the end looked like a crash.
    void tooLittleMemoryIsTold() {
        const auto within = [&](int megabytes) {
            const QString limited =
                QStringLiteral("ulimit -c 0; ulimit -v %1 && exec \"$0\" --screenshot \"$1\"")
                    .arg(megabytes << 10);
            return isoscope::test::runProgram(
                "sh", {"-c", limited, ISOSCOPE_BINARY_DIR "/isoscope", folder_.filePath("memory.png")}, 10);
        };
        int refused = 0;
        // With more, drivers of OpenGL crash by themselves; and Qt may wait for ever for a thread of its own
        // that it could not start.
        for (int megabytes = 150; megabytes <= 500; megabytes += 50) {
            const isoscope::test::ProgramResult result = within(megabytes);
            QVERIFY2(!result.errors.contains("terminate called"), result.errors.constData());
            if (result.status == 1 && result.errors.contains("isoscope: ")) ++refused;
        }
        if (refused == 0) QSKIP("NOT TESTED: this build needs gigabytes of addresses");
        qInfo("%d times", refused);
    }

    void screenshotOfAFile() {
        const QString picture = folder_.filePath(QStringLiteral("window.png"));
        const Outcome shot =
            run({QStringLiteral("--screenshot"), picture, QStringLiteral("--size"),
                 QStringLiteral("1280x800"), QStringLiteral("--theme"), QStringLiteral("dark"),
                 QStringLiteral(ISOSCOPE_SOURCE_DIR "/examples/sphere.pov")});
        QVERIFY2(shot.status == 0, qPrintable(shot.output));
        QVERIFY2(!shot.errors.contains("fonts"), qPrintable(shot.errors));
        const QImage window(picture);
        QCOMPARE(window.size(), QSize(1280, 800));
        QVERIFY(isoscope::test::distinctColors(window) > 500);
    }

    void aPictureThatCannotBeWrittenIsTold() {
        const QString words = isoscope::test::writeFile(folder_.path(), "kept.text", "words");
        const Outcome unknown = run({"--screenshot", words});
        QCOMPARE(unknown.status, 1);
        QVERIFY2(unknown.errors.contains("use .png"), qPrintable(unknown.errors));
        QFile file(words);
        QVERIFY(file.open(QIODevice::ReadOnly));
        QCOMPARE(file.readAll(), QByteArray("words"));

        const Outcome nowhere = run({"--screenshot", folder_.filePath("no/such/folder.png")});
        QCOMPARE(nowhere.status, 1);
        QVERIFY2(nowhere.errors.contains("No such file or directory"), qPrintable(nowhere.errors));
    }

    /// A system with a decimal comma has the same surfaces: `str` once gave 1,5, of which `val` made 1.
    void picturesDoNotDependOnTheLocale() {
        const isoscope::test::CommaLocale locale;
        if (!locale.valid()) QSKIP("NOT TESTED: no German locale can be made, see Debian's package locales");
        const QString scene = isoscope::test::writeFile(
            folder_.path(), QStringLiteral("comma.pov"),
            "#version 3.7;\n#include \"functions.inc\"\ncamera { location -3*z look_at 0 }\n"
            "isosurface { function { f_sphere(x, y, z, 1.5) } contained_by { box { -2, 2 } } max_gradient 2\n"
            "  #if (val(str(1.5, 0, 1)) = 1.5) pigment { rgb <0, 1, 0> } #else pigment { rgb <1, 0, 0> } "
            "#end\n"
            "  finish { emission 1 } }\n");
        const QString picture = folder_.filePath(QStringLiteral("comma.png"));
        const Outcome shot = run({QStringLiteral("--screenshot"), picture, QStringLiteral("--size"),
                                  QStringLiteral("1280x800"), scene});
        QVERIFY2(shot.status == 0, qPrintable(shot.output));
        const QImage window(picture);
        int green = 0, red = 0;
        for (int y = 0; y < window.height(); ++y)
            for (int x = 0; x < window.width(); ++x) {
                const QColor color = window.pixelColor(x, y);
                green += color.green() > 200 && color.red() < 60 && color.blue() < 60;
                red += color.red() > 200 && color.green() < 60 && color.blue() < 60;
            }
        QVERIFY2(green > 10000 && red < 1000, qPrintable(QStringLiteral("%1 %2").arg(green).arg(red)));
    }

    void screenshotThatCannotBeWritten() {
        QCOMPARE(
            run({QStringLiteral("--screenshot"), folder_.filePath(QStringLiteral("no/folder/a.png"))}).status,
            1);
    }
};

QTEST_MAIN(ProgramTest)
#include "program_test.moc"
