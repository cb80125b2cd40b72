// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <chrono>
#include <QDir>
#include <QTest>
#include <random>
#include <thread>

#include "core/render/progressive/progressive_renderer.h"
#include "test_folders.h"
#include "tests/support/scene_picture.h"

using namespace isoscope;

namespace {

constexpr int stops = 25;
/// A stop that takes longer is a hang, on any machine.
constexpr double longest = 5000;

double millisecondsSince(std::chrono::steady_clock::time_point begin) {
    return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - begin).count();
}

}  // namespace

/// Prints how soon a picture of 800 x 600 ends after stop(), asked for at random moments; asserts only that
/// it does, since the machine may be busy.
class StopLatencyTest : public QObject {
    Q_OBJECT

  private slots:
    void aStoppedPictureEndsSoon_data() {
        QTest::addColumn<QString>("text");
        const QDir folder(QStringLiteral(ISOSCOPE_SOURCE_DIR "/tests/bench"));
        for (const QFileInfo& file : folder.entryInfoList({QStringLiteral("*.pov")}))
            QTest::newRow(qPrintable(file.baseName())) << file.filePath();
        QTest::newRow("glass that sends ever more rays")
            << "#version 3.7; global_settings { max_trace_level 256 adc_bailout 0 }\n"
               "#default { pigment { rgbt 1 } finish { reflection 1 } } camera { location -2*z look_at 0 }\n"
               "light_source { <0, 3.5, -1>, 1 } sphere { -x, 0.8 interior { ior 1.5 } }\n"
               "sphere { x, 0.8 interior { ior 1.5 } } sphere { 0, 4 pigment { rgb 0 } }";
        QTest::newRow("a loop of a hundred thousand steps")
            << "camera { location -4*z look_at 0 }\n"
               "isosurface { function { sum(i, 1, 100000, sin(i*x)/i) - y } contained_by { sphere { 0, 1.3 } "
               "} }";
    }
    void aStoppedPictureEndsSoon() {
        QFETCH(QString, text);
        const bool isFile = text.endsWith(QStringLiteral(".pov"));
        const ParseResult parsed =
            isFile ? parseSceneFile(text.toStdString()) : parseScene(text.toStdString());
        QVERIFY(parsed.ok());
        std::mt19937 random(11);
        for (const RootFinder finder : {RootFinder::certified, RootFinder::lipschitz}) {
            std::vector<double> times;
            ProgressiveRenderer renderer(2);
            for (int i = 0; i < stops; ++i) {
                RenderRequest request = test::requestFor(parsed, 800, 600);
                request.rootFinder = finder;
                renderer.request(request);
                std::this_thread::sleep_for(std::chrono::microseconds(500 + random() % 20000));
                const auto begin = std::chrono::steady_clock::now();
                renderer.stop();
                while (!renderer.progress().finished && millisecondsSince(begin) < longest)
                    std::this_thread::yield();
                times.push_back(millisecondsSince(begin));
                QVERIFY2(times.back() < longest, "the picture goes on");
                renderer.takeTiles();
            }
            std::sort(times.begin(), times.end());
            qInfo("%s: median %.1f ms, worst %.1f ms",
                  finder == RootFinder::certified ? "certified" : "POV-Ray", times[stops / 2], times.back());
        }
    }
};

QTEST_APPLESS_MAIN(StopLatencyTest)
#include "stop_latency_test.moc"
