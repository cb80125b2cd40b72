// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/exchange/povray_process.h"

#include <algorithm>
#include <numeric>
#include <thread>
#include <QDir>
#include <QElapsedTimer>
#include <QFile>
#include <QTemporaryDir>
#include <QTest>

#include "core/exchange/png.h"
#include "core/language/directives/library_paths.h"
#include "core/study/view/povray_comparison.h"
#include "tests/support/povray.h"
#include "tests/support/scene_picture.h"

using namespace isoscope;

namespace {

/// A ball whose max_gradient may be far too low.
std::string ball(double maxGradient) {
    return "#version 3.7;\nglobal_settings { assumed_gamma 1 }\ncamera { location <2.2, 1.6, -2.9> look_at 0 "
           "angle 45 }\nlight_source { <4, 6, -5> rgb 0.9 }\nisosurface { function { x*x + y*y + z*z - 1 } "
           "contained_by { sphere { 0, 1.2 } } max_gradient " +
           std::to_string(maxGradient) + " pigment { rgb <0.85, 0.3, 0.25> } }\n";
}

PovrayOrder orderOf(const std::string& text, int width = 80, int height = 60) {
    PovrayOrder order;
    order.text = text;
    order.width = width;
    order.height = height;
    return order;
}

}  // namespace

class PovrayProcessTest : public QObject {
    Q_OBJECT

    QTemporaryDir folder_;
    QByteArray path_;

    /// Puts a program of that name, a shell script, before all others.
    void setPovray(const QByteArray& script) {
        QFile program(folder_.filePath("povray"));
        QVERIFY(program.open(QIODevice::WriteOnly | QIODevice::Truncate));
        program.write("#!/bin/sh\n" + script);
        program.close();
        QVERIFY(program.setPermissions(QFile::ReadOwner | QFile::WriteOwner | QFile::ExeOwner));
        qputenv("PATH", folder_.path().toLocal8Bit() + ':' + path_);
    }
    static QStringList temporaryFolders() {
        return QDir::temp().entryList({"isoscope-povray-*"}, QDir::Dirs);
    }

  private slots:
    void initTestCase() {
        path_ = qgetenv("PATH");
        // A place of its own for temporary files: other tests draw with POV-Ray at the same time.
        qputenv("TMPDIR", folder_.path().toLocal8Bit());
    }
    void cleanup() { qputenv("PATH", path_); }

    void progressAndPictureComeFromTheProgram() {
        Image image(80, 60);
        for (auto& pixel : image.pixels) pixel = {0, 1, 0};
        QVERIFY(writePng(folder_.filePath("made.png").toStdString(), image));
        setPovray(
            "printf 'Rendered 10 of 40 pixels (25%%)\\r' >&2\nsleep 0.2\n"
            "printf 'Rendered 30 of 40 pixels (75%%)\\r' >&2\nsleep 0.2\n"
            "test -f scene.pov || exit 3\nfor word; do case $word in +O*) cp " +
            folder_.filePath("made.png").toLocal8Bit() + " ${word#+O};; esac; done\n");
        std::vector<double> shares;
        const PovrayPicture picture =
            drawWithPovray(orderOf(ball(4)), {}, [&](double share) { shares.push_back(share); });
        QCOMPARE(picture.problem, std::string());
        QCOMPARE(picture.image.width, 80);
        QCOMPARE(encodePixel(picture.image.pixels[5]), 0xff00ff00u);
        QVERIFY(std::find(shares.begin(), shares.end(), 0.25) != shares.end());
        QVERIFY(std::find(shares.begin(), shares.end(), 0.75) != shares.end());
    }

    void aStopEndsTheProgramAndLeavesNothing() {
        const QString alive = folder_.filePath("alive");
        setPovray("sleep 20\ntouch " + alive.toLocal8Bit() + "\n");
        const QStringList before = temporaryFolders();
        std::stop_source stop;
        std::jthread later([&] {
            QTest::qSleep(200);
            stop.request_stop();
        });
        QElapsedTimer timer;
        timer.start();
        const PovrayPicture picture = drawWithPovray(orderOf(ball(4)), stop.get_token());
        QVERIFY(picture.stopped && picture.image.pixels.empty());
        // Far less than the program would take.
        QVERIFY(timer.elapsed() < 15000);
        QCOMPARE(temporaryFolders(), before);
    }

    /// POV-Ray waited for ever for a thread of its own to which memory was refused. One that works without a
    /// word is left alone.
    void aProgramThatDoesNothingIsEnded() {
        PovrayOrder order = orderOf(ball(4));
        order.patience = std::chrono::milliseconds(300);
        setPovray("echo begun >&2\nexec sleep 60\n");
        const PovrayPicture idle = drawWithPovray(order);
        QCOMPARE(idle.problem, std::string("POV-Ray stands still and was ended"));
        QVERIFY(!idle.stopped && idle.image.pixels.empty());

        order.patience = std::chrono::seconds(1);
        setPovray("while :; do :; done\n");
        std::stop_source stop;
        std::jthread later([&] {
            QTest::qSleep(2500);
            stop.request_stop();
        });
        QVERIFY(drawWithPovray(order, stop.get_token()).stopped);
    }

    void whatIsWrongIsSaid() {
        setPovray(
            "echo 'File x.pov line 3: Possible Parse Error: Suspicious' >&2\n"
            "echo \"File '$PWD/scene.pov' line 5: Parse Error: Expected operator\" >&2\n"
            "echo 'Render failed' >&2\nexit 1\n");
        QCOMPARE(drawWithPovray(orderOf(ball(4))).problem,
                 std::string("POV-Ray: File 'scene.pov' line 5: Parse Error: Expected operator"));
        setPovray("exit 0\n");
        QCOMPARE(drawWithPovray(orderOf(ball(4))).problem, std::string("POV-Ray wrote no picture"));
        QFile program(folder_.filePath("povray"));
        QVERIFY(program.open(QIODevice::WriteOnly | QIODevice::Truncate));
        program.write("#!/no/such/shell\n");
        program.close();
        QCOMPARE(drawWithPovray(orderOf(ball(4))).problem, std::string("POV-Ray could not be started"));
        qputenv("PATH", folder_.filePath("nothing").toLocal8Bit());
        QVERIFY(!povrayProgram());
        QVERIFY(drawWithPovray(orderOf(ball(4))).problem.starts_with("POV-Ray is not installed"));
    }

    void scenesThatWriteElsewhereAreNotForPovray() {
        QVERIFY(whyNotForPovray({{"heights.txt", ""}, {"sub/a.txt", ""}}).empty());
        QVERIFY(!whyNotForPovray({{"/etc/passwd", ""}}).empty());
        QVERIFY(!whyNotForPovray({{"a/../../b", ""}}).empty());
    }

    /// With the real program: a right max_gradient gives the same picture, a low one holes that are told.
    void holesAreToldApart() {
        if (!test::hasPovray()) QSKIP(test::povrayIsMissing);
        for (const double maxGradient : {4.0, 1.1}) {
            const std::string text = ball(maxGradient);
            const PovrayPicture theirs = drawWithPovray(orderOf(text, 160, 120));
            QCOMPARE(theirs.problem, std::string());
            const RenderRequest request = test::requestFor(parseScene(text), 160, 120);
            const PovrayComparison comparison = compareWithPovray(request, theirs.image, false);
            QVERIFY(comparison.complete);
            const std::uint64_t byGradient = comparison.count(DifferenceCause::hole) +
                                             comparison.count(DifferenceCause::gained) +
                                             comparison.count(DifferenceCause::wrongSheet);
            QCOMPARE(std::accumulate(comparison.counts.begin(), comparison.counts.end(), std::uint64_t{0}),
                     std::uint64_t{160 * 120});
            if (maxGradient > 2) {
                QVERIFY2(comparison.differing() < 40, qPrintable(QString::number(comparison.differing())));
            } else {
                QVERIFY2(byGradient > 500, qPrintable(QString::number(byGradient)));
                QVERIFY(comparison.count(DifferenceCause::unknown) * 50 < byGradient);
                // The difference picture shows them in their colour.
                const Image shown = picture(comparison);
                const auto wrong = std::find(comparison.causes.begin(), comparison.causes.end(),
                                             DifferenceCause::wrongSheet) -
                                   comparison.causes.begin();
                QCOMPARE(encodePixel(shown.pixels[static_cast<std::size_t>(wrong)]),
                         differenceColor(DifferenceCause::wrongSheet));
            }
        }
    }

    void whatTheWindowDoesNotDrawIsTold() {
        const RenderRequest request = test::requestFor(parseScene(ball(4)), 40, 30);
        Image other(40, 30);
        for (auto& pixel : other.pixels) pixel = {0.5f, 0.5f, 0.5f};
        const PovrayComparison told = compareWithPovray(request, other, true);
        QVERIFY(told.count(DifferenceCause::leftOut) > 200);
        QCOMPARE(told.count(DifferenceCause::unknown), std::uint64_t{0});
        QVERIFY(compareWithPovray(request, other, false).count(DifferenceCause::unknown) > 200);
        QVERIFY(!compareWithPovray(request, Image(30, 30), false).complete);
        std::stop_source stop;
        stop.request_stop();
        QVERIFY(!compareWithPovray(request, other, false, 1, stop.get_token()).complete);
    }
};

QTEST_GUILESS_MAIN(PovrayProcessTest)
#include "povray_process_test.moc"
