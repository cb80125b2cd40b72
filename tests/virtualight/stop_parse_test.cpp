// SPDX-License-Identifier: GPL-3.0-or-later
// How soon a parse ends when it is asked to, in texts of both notations that take long.
#include <QTest>
#include <algorithm>
#include <chrono>
#include <ctime>
#include <future>
#include <pthread.h>
#include <random>
#include <thread>

#include "core/exchange/read_scene.h"

using namespace isoscope;

namespace {

using Clock = std::chrono::steady_clock;

/// Of the processor in this clock, in milliseconds: what others do on the machine does not count.
double milliseconds(clockid_t clock) {
    timespec time{};
    clock_gettime(clock, &time);
    return 1e3 * static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_nsec);
}

struct Stopped {
    ParseResult result;
    /// Milliseconds that the reading thread worked behind the request; -1 when it ended by itself.
    double after = -1;
};

/// Reads the text and asks for its end `delay` later.
Stopped readAndStop(const std::string& text, std::chrono::milliseconds delay) {
    std::stop_source source;
    ParseOptions options;
    options.stop = source.get_token();
    options.progress = std::make_shared<ParseProgress>();
    Stopped stopped;
    std::atomic<bool> ended = false;
    double end = 0;
    std::promise<void> mayLeave;
    std::thread reader([&] {
        stopped.result = readScene(text, options);
        end = milliseconds(CLOCK_THREAD_CPUTIME_ID);
        ended = true;
        mayLeave.get_future().wait();
    });
    clockid_t clock{};
    pthread_getcpuclockid(reader.native_handle(), &clock);
    const auto begin = Clock::now();
    while (!ended && Clock::now() - begin < delay)
        std::this_thread::sleep_for(std::chrono::microseconds(200));
    const bool running = !ended;
    const double asked = milliseconds(clock);
    source.request_stop();
    mayLeave.set_value();
    reader.join();
    if (running) stopped.after = end - asked;
    return stopped;
}

std::string repeated(const std::string& text, int count) {
    std::string all;
    for (int k = 0; k < count; ++k) all += text;
    return all;
}

}  // namespace

class StopParseTest : public QObject {
    Q_OBJECT

  private slots:
    void stopsSoon_data() {
        QTest::addColumn<QString>("text");
        const auto row = [](const char* name, const std::string& text) {
            QTest::newRow(name) << QString::fromStdString(text);
        };
        row("loop", "#while (1) #declare A = 1; #end");
        row("macros", "#macro M(N) #if (N > 0) M(N - 1) M(N - 1) #end #end M(60)");
        row("strings",
            "#while (1) #declare S = \"\"; #for (I, 1, 500) #declare S = concat(S, \"abcdef\"); #end #end");
        row("skipped branches", "#while (1) #if (0)" + repeated(" a", 20000) + " #end #end");
        row("objects", "union { #for (I, 1, 200000) sphere { <I, sin(I), cos(I)>, 0.5 } #end }");
        row("separate objects",
            "#for (I, 1, 60000) sphere { <I, sin(I), cos(I)>, 0.5 pigment { rgb I/60000 } } #end");
        row("mesh",
            "mesh { #for (I, 1, 100000) triangle { <I, sin(I), 0>, <I + 1, cos(I), 1>, <I, 2, cos(I)> } #end "
            "}");
        row("blob", "blob { threshold 0.5 #for (I, 1, 30000) sphere { <I, sin(I), cos(I)>, 2, 1 } #end }");
        row("rays",
            "#declare S = isosurface { function { f_noise3d(4*x, 4*y, 4*z) - 0.5 + 0.1*sin(30*x) } "
            "contained_by { box { -1, 1 } } max_gradient 20 accuracy 1e-6 }\n"
            "#include \"functions.inc\"\n#for (I, 1, 1e6) #declare P = trace(S, <I/1e6, 0.1, -5>, z); #end");
        row("one long ray",
            "#declare S = isosurface { function { sum(i, 1, 100000, sin(i*x + y*z)/i) + 7 } "
            "contained_by { sphere { 0, 1 } } max_gradient 9 accuracy 1e-9 }\n"
            "#declare P = trace(S, <0.1, 0.1, -5>, z);");
        row("height field", "height_field { function 3000, 3000 { pattern { wrinkles scale 0.02 } } }");
        row("letters", "text { ttf \"timrom.ttf\", \"" + repeated("Ag8", 4000) + "\", 1, 0 }");
        row("sweep", "sphere_sweep { b_spline 4000 #for (I, 1, 4000) <I, sin(I), cos(I)>, 0.3 #end }");
        row("arrays", "#while (1) #local A = array[1000]; #for (I, 0, 999) #local A[I] = I; #end #end");
        row("declared functions",
            "#declare F = function { x + y*sin(z) }\n#while (1) #declare G = function { F(x, y, z)*F(z, y, "
            "x) + " +
                repeated("F(x, y, z) + ", 200) + "1 } #end");
        row("VirtuaLight, long text",
            "Declare A = 1\n" + repeated("Shape [ Sphere((0, 0, 0), A) ]\n", 100000));
        row("VirtuaLight, nets", repeated("Shape [ ParametricSurface(cos(u)*sin(v), sin(u)*sin(9*v), "
                                          "exp(cos(u*v))) RenderBound(0, 6, 0, "
                                          "3) ShapeSubdivisions(500, 500) ]\n",
                                          15));
        row("VirtuaLight, powers",
            repeated("Shape [ PolynomialSurface((x + y + z + 1)^20 - 1) Bound((-1,-1,-1), (1,1,1)) ]\n",
                     300));
        row("VirtuaLight, set operators",
            "Declare B = Shape [ Sphere((0, 0, 0), 1) ]\nSolid [ B " + repeated("+ B ", 50000) + "]");
    }
    void stopsSoon() {
        QFETCH(QString, text);
        const std::string bytes = text.toStdString();
        const unsigned seed = std::random_device()();
        std::mt19937 random(seed);
        std::vector<double> times;
        int endedBefore = 0;
        for (const int base : {5, 30, 80, 200, 400, 800}) {
            const auto delay = std::chrono::milliseconds(base + static_cast<int>(random() % 20));
            const Stopped stopped = readAndStop(bytes, delay);
            if (stopped.after < 0) {
                ++endedBefore;
                continue;
            }
            times.push_back(stopped.after);
            QVERIFY(stopped.result.scene);
            const Diagnostics& said = stopped.result.diagnostics;
            const bool ended =
                std::none_of(said.begin(), said.end(), [](const Diagnostic& d) { return d.id == "stopped"; });
            // It may have been at its end; then nothing is missing, and nothing is said.
            if (ended) ++endedBefore;
            QVERIFY(ended || !stopped.result.ok());
        }
        std::sort(times.begin(), times.end());
        if (times.empty())
            qInfo("seed %u: ended by itself each time", seed);
        else
            qInfo("seed %u: %zu stops, median %.1f ms, worst %.1f ms; %d ended by themselves", seed,
                  times.size(), times[times.size() / 2], times.back(), endedBefore);
    }

    void whatIsStoppedSaysWhere() {
        const Stopped stopped =
            readAndStop("sphere { 0, 1 pigment { rgb 1 } }\n#while (1) #declare A = 1; #end",
                        std::chrono::milliseconds(50));
        QVERIFY(stopped.after >= 0);
        QCOMPARE(stopped.result.diagnostics.size(), std::size_t(1));
        QCOMPARE(stopped.result.diagnostics[0].message, std::string("Reading was stopped here."));
        QCOMPARE((*stopped.result.sources)[0].position(stopped.result.diagnostics[0].range.begin).line, 2);
    }
};

QTEST_APPLESS_MAIN(StopParseTest)
#include "stop_parse_test.moc"
