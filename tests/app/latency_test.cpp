// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <ctime>
#include <functional>
#include <QDir>
#include <QDockWidget>
#include <QElapsedTimer>
#include <QEventLoop>
#include <QFileInfo>
#include <QTest>
#include <QThread>
#include <QTimer>

#include "app/desktop/studies/study_controller.h"
#include "app/desktop/studies/verdict_controller.h"
#include "app/desktop/window/actions.h"
#include "app/desktop/window/docks.h"
#include "test_folders.h"
#include "tests/app/window_driver.h"
#include "tests/support/builtin_scene.h"
#include "tests/support/csv_table.h"
#include "tests/support/study_scene.h"
#include "widgets/parameters/parameter_panel.h"
#include "widgets/parameters/parameter_slider.h"
#include "widgets/parameters/slider_player.h"
#include "widgets/section/section_panel.h"
#include "widgets/section/section_view.h"
#include "widgets/editor/scene_editor.h"
#include "widgets/studies/accuracy_panel.h"
#include "widgets/verdicts/verdict_study.h"
#include "widgets/viewport/viewport.h"

using namespace isoscope;
using namespace isoscope::test;

namespace {

constexpr int moves = 7;

/// Whether all scenes are timed, not only the first of each kind.
bool timesEverything() { return qEnvironmentVariableIsSet("ISOSCOPE_ALL_LATENCIES"); }

void report(const char* what, std::vector<double> milliseconds) {
    std::sort(milliseconds.begin(), milliseconds.end());
    qInfo("%s: median %.1f ms, least %.1f ms, worst %.1f ms", what, milliseconds[milliseconds.size() / 2],
          milliseconds.front(), milliseconds.back());
}

/// Handles events until `done`. QTest::qWaitFor() would nap for up to 10 ms between them, in the thread that
/// is to be timed.
bool handlesEventsUntil(const std::function<bool()>& done) {
    QTimer limit;
    limit.start(20000);
    while (!done()) {
        if (limit.remainingTime() == 0) return false;
        QCoreApplication::processEvents(QEventLoop::WaitForMoreEvents);
    }
    return true;
}

/// The first number that is neither a setting of the root finder nor fixed; -1 without one.
int rowToPlay(const ParameterPanel* panel) {
    for (int i = 0; i < panel->count(); ++i) {
        const ParameterSlider* row = panel->slider(i);
        const ParameterRole role = row->parameter().role;
        const bool shapes = role == ParameterRole::argument || role == ParameterRole::container ||
                            role == ParameterRole::threshold;
        if (shapes && row->canPlay()) return i;
    }
    return -1;
}

QStringList scenesOf(const QDir& folder, const QString& pattern) {
    QStringList scenes;
    for (const QFileInfo& file : folder.entryInfoList({pattern})) scenes << file.filePath();
    return scenes;
}

/// What is only timed: all of `scenes`, or the first.
QStringList timed(const QStringList& scenes) { return timesEverything() ? scenes : scenes.mid(0, 1); }

QStringList tutorialScenes() {
    return scenesOf(QFileInfo(dataFile(QStringLiteral("spec/examples/iso_sum_noise.pov"))).dir(),
                    QStringLiteral("iso_*.pov"));
}

QStringList benchScenes() {
    return scenesOf(QDir(QStringLiteral(ISOSCOPE_SOURCE_DIR "/tests/bench")), QStringLiteral("*.pov"));
}

/// Twenty rough balls, whose proofs take many seconds.
QString manyIsosurfaces() {
    QString text = QStringLiteral(
        "#version 3.7;\n#include \"functions.inc\"\ncamera { location <0, 0, -14> look_at 0 angle 40 }\n"
        "light_source { <4, 6, -9> rgb 1 }\n");
    for (int i = 0; i < 20; ++i)
        text += QStringLiteral(
                    "isosurface {\n  function { x*x + y*y + z*z - 0.6 + 0.2*f_noise3d(%1 + 6*x, 6*y, 6*z) }\n"
                    "  contained_by { sphere { 0, 1 } }\n  max_gradient 5\n  pigment { rgb 0.8 }\n"
                    "  translate <%2, %3, 0>\n}\n")
                    .arg(7 * i)
                    .arg(2 * (i % 5) - 4)
                    .arg(2 * (i / 5) - 3);
    return text;
}

/// A built-in as a whole scene, seen from as far as its container asks for.
QString builtinView(const Builtin& builtin) {
    const std::string statement =
        builtinStatement(builtin, "max_gradient 10 pigment { rgb <0.9, 0.7, 0.3> }");
    const RenderRequest request = studyScene(statement, 48, 27);
    const Bounds bounds = request.scene->objects.front().shape->bounds();
    const glm::dvec3 middle = 0.5 * (bounds.low + bounds.high);
    const double reach = 0.5 * glm::distance(bounds.low, bounds.high), away = 3.2 * reach;
    const auto vectorOf = [](const glm::dvec3& v) {
        return QStringLiteral("<%1, %2, %3>").arg(v.x).arg(v.y).arg(v.z);
    };
    return QStringLiteral("#version 3.7;\n#include \"functions.inc\"\n") +
           QStringLiteral("camera { location %1 look_at %2 angle 40 right x*16/9 }\n")
               .arg(vectorOf(middle + away * glm::dvec3(0.8, 0.6, -1)), vectorOf(middle)) +
           QStringLiteral("light_source { %1 rgb 1 shadowless }\n")
               .arg(vectorOf(4 * reach * glm::dvec3(-3, 5, -6))) +
           QString::fromStdString(statement);
}

/// Processor time of the window's thread, whatever else the machine does.
double windowSeconds() {
    std::timespec now{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
    return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

double medianOf(std::vector<double> values) {
    std::sort(values.begin(), values.end());
    return values[values.size() / 2];
}

}  // namespace

/// Prints how long the window takes to answer; asserts only that it does, since the machine may be busy.
class LatencyTest : public QObject {
    Q_OBJECT

    /// Milliseconds from each step of the mouse to its picture. No slice of a proof begins meanwhile.
    static std::vector<double> frameTimesOfDrag(Viewport& viewport, int steps, const VerdictStudy* study) {
        std::vector<double> times;
        QPoint at = viewport.rect().center();
        QTest::mousePress(&viewport, Qt::LeftButton, {}, at);
        QElapsedTimer since;
        std::uint64_t slices = 0;
        for (int i = 0; i <= steps; ++i) {
            const qint64 before = viewport.picture().cacheKey();
            at += QPoint(4, i % 2);
            since.start();
            QTest::mouseMove(&viewport, at);
            if (!handlesEventsUntil([&] { return viewport.picture().cacheKey() != before; })) return {};
            // With the first step the drag begins, and what was under way ends.
            if (i == 0)
                slices = study->slices();
            else
                times.push_back(static_cast<double>(since.nsecsElapsed()) / 1e6);
        }
        const bool heldStill = study->slices() == slices;
        QTest::mouseRelease(&viewport, Qt::LeftButton, {}, at);
        return heldStill ? times : std::vector<double>();
    }

  private slots:
    void windowWithPicture() {
        QElapsedTimer since;
        since.start();
        WindowDriver d;
        QVERIFY(handlesEventsUntil([&] { return !d->viewport()->picture().isNull(); }));
        qInfo("window with the first picture: %lld ms", since.elapsed());
        QVERIFY(d.rests());
        qInfo("everything at rest: %lld ms", since.elapsed());
    }

    /// The example at start, the tutorial's scenes that have isosurfaces, and the scenes of `make bench`.
    void sliderMove_data() {
        QTest::addColumn<QString>("file");
        QTest::addColumn<QString>("name");
        QTest::addColumn<bool>("certified");
        QTest::addColumn<QSize>("size");
        const QSize size(800, 600);
        for (const bool certified : {true, false}) {
            const char* finder = certified ? "certified" : "POV-Ray";
            QTest::addRow("with a slot, %s", finder) << ""
                                                     << "Radius" << certified << size;
            QTest::addRow("by a parse, %s", finder) << ""
                                                    << "max_gradient" << certified << size;
            for (const QString& file : timed(tutorialScenes()))
                QTest::addRow("%s, %s", qPrintable(QFileInfo(file).baseName()), finder)
                    << file << "max_gradient" << certified << size;
        }
        for (const QSize& benchSize : {QSize(480, 270), QSize(960, 540)})
            for (const QString& file : timed(benchScenes()))
                QTest::addRow("%s, %dx%d", qPrintable(QFileInfo(file).baseName()), benchSize.width(),
                              benchSize.height())
                    << file << "max_gradient" << true << benchSize;
    }
    void sliderMove() {
        QFETCH(QString, file);
        QFETCH(QString, name);
        QFETCH(bool, certified);
        QFETCH(QSize, size);
        WindowDriver d;
        (certified ? d->actions()->certified : d->actions()->povray)->trigger();
        d->resize(1600, 1200);
        if (!file.isEmpty()) QVERIFY(d->openFile(file));
        d.rests();
        // The viewport's own size, whatever the docks take.
        d->viewport()->setFixedSize(size);
        QVERIFY(QTest::qWaitFor([&] { return d->viewport()->picture().size() == size; }, 20000));
        QVERIFY(d.rests());
        const int index = d.parameter(name);
        QVERIFY(index >= 0);
        const double first = d->parameters()->slider(index)->value();
        std::vector<double> coarse, full, work;
        QElapsedTimer since;
        double finishedAfter = 0;
        std::clock_t begin = 0;
        connect(d->viewport(), &Viewport::pictureFinished, this, [&] {
            if (finishedAfter != 0) return;
            finishedAfter = static_cast<double>(since.nsecsElapsed()) / 1e6;
            work.push_back(1e3 * static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC);
        });
        for (int i = 1; i <= moves; ++i) {
            const qint64 before = d->viewport()->picture().cacheKey();
            since.start();
            finishedAfter = 0;
            begin = std::clock();
            emit d->parameters()->valueChanged(index, first * (1 + 0.02 * i));
            QVERIFY(handlesEventsUntil([&] { return d->viewport()->picture().cacheKey() != before; }));
            coarse.push_back(static_cast<double>(since.nsecsElapsed()) / 1e6);
            QVERIFY(handlesEventsUntil([&] { return finishedAfter > 0; }));
            full.push_back(finishedAfter);
            QVERIFY(d.rests());
        }
        qInfo("picture of %d x %d", d->viewport()->picture().width(), d->viewport()->picture().height());
        report("first coarse picture", coarse);
        report("full picture", full);
        report("processor time for it, all threads", work);
    }

    /// A table of all built-ins at 480 x 270, from a step of a slider to the whole picture; without
    /// ISOSCOPE_ALL_LATENCIES of some.
    void everyBuiltinBySlider() {
        const QSize size(480, 270);
        WindowDriver d;
        d->actions()->certified->trigger();
        d->resize(1600, 1200);
        d->viewport()->setFixedSize(size);
        std::vector<double> rows;
        for (const Builtin& builtin : builtins()) {
            if (builtin.name.empty() || builtin.pointArguments != 3) continue;
            if (!timesEverything() && rows.size() == 3) break;
            d->editor()->setSceneText(builtinView(builtin));
            QVERIFY(d.rests());
            const int index = rowToPlay(d->parameters());
            if (index < 0) continue;
            const double first = d->parameters()->slider(index)->value();
            std::vector<double> times;
            QElapsedTimer since;
            double finishedAfter = 0;
            const auto finished = connect(d->viewport(), &Viewport::pictureFinished, this, [&] {
                if (finishedAfter == 0) finishedAfter = static_cast<double>(since.nsecsElapsed()) / 1e6;
            });
            for (int i = 1; i <= moves; ++i) {
                finishedAfter = 0;
                since.start();
                emit d->parameters()->valueChanged(index, first + 0.004 * i * std::max(std::abs(first), 0.1));
                QVERIFY(handlesEventsUntil([&] { return finishedAfter > 0; }));
                times.push_back(finishedAfter);
                QVERIFY(d.rests());
            }
            disconnect(finished);
            report(builtin.name.c_str(), times);
            rows.push_back(medianOf(times));
        }
        report("medians of the rows", rows);
        QVERIFY(rows.size() >= 3);
    }

    /// A whole study of the Accuracy panel, planning included, and how soon its stop button acts.
    void accuracyStudy_data() {
        QTest::addColumn<QString>("file");
        QTest::addRow("our example") << "";
        for (const QString& file : timed(tutorialScenes()))
            QTest::addRow("%s", qPrintable(QFileInfo(file).baseName())) << file;
    }
    void accuracyStudy() {
        QFETCH(QString, file);
        WindowDriver d;
        if (!file.isEmpty()) QVERIFY(d->openFile(file));
        QVERIFY(d.rests());
        for (const StudiedSetting setting : {StudiedSetting::accuracy, StudiedSetting::maxGradient}) {
            d->study<AccuracyPanel>()->setStudied(setting);
            QElapsedTimer since;
            since.start();
            const std::clock_t begin = std::clock();
            d->study<AccuracyPanel>()->measure();
            QVERIFY(QTest::qWaitFor([&] { return !d->study<AccuracyPanel>()->measuring(); }, 120000));
            qInfo("study of %s: %.1f s, %.1f s of processor time, %zu points",
                  setting == StudiedSetting::accuracy ? "accuracy" : "max_gradient",
                  static_cast<double>(since.elapsed()) / 1e3,
                  static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC,
                  d->study<AccuracyPanel>()->points().size());
        }
    }

    /// Whether a drag of the view is as fluent while twenty isosurfaces are being judged as without.
    void dragWhileVerdicts() {
        constexpr int rounds = 5, steps = 30;
        std::vector<double> with, without;
        for (int round = 0; round < 2 * rounds; ++round) {
            const bool judged = round % 2 == 0;
            WindowDriver d;
            d->resize(1600, 1200);
            d->viewport()->setFixedSize(640, 480);
            d->editor()->setSceneText(manyIsosurfaces());
            QVERIFY(d.rests());
            VerdictStudy* study = d->studies()->verdicts()->study();
            if (!judged) study->setScene({});
            if (judged) {
                QTRY_VERIFY(study->busy() && study->slices() > 0);
                // Not in the window's thread: it goes on while that one handles no event.
                const std::uint64_t before = study->slices();
                QThread::msleep(200);
                QVERIFY(study->slices() > before);
            }
            const std::vector<double> times = frameTimesOfDrag(*d->viewport(), steps, study);
            QCOMPARE(times.size(), std::size_t(steps));
            (judged ? with : without).push_back(medianOf(times));
            if (!judged) continue;
            // Nothing is forgotten: it goes on at rest.
            const std::uint64_t rested = study->slices();
            QTRY_VERIFY(study->slices() > rested || !study->busy());
        }
        report("frame of a drag while 20 isosurfaces are judged", with);
        report("frame of a drag without", without);
        qInfo("ratio of the medians: %.3f", medianOf(with) / medianOf(without));
    }

    void section() {
        WindowDriver d;
        QVERIFY(d.rests());
        std::vector<double> times;
        connect(d->study<SectionPanel>(), &SectionPanel::sampled, d->study<SectionPanel>(),
                [&](double ms) { times.push_back(ms); });
        for (int i = 0; i < moves; ++i) {
            d->study<SectionPanel>()->setPosition(-0.5 + i * 0.05);
            QVERIFY(d.rests());
        }
        QVERIFY(!times.empty());
        report("sampling the cross-section", times);
    }

    /// From a move of the slider to the new section on the screen, at 512 x 512 samples, while it goes on.
    void sectionSlider_data() {
        QTest::addColumn<QString>("file");
        QTest::addColumn<bool>("free");
        for (const bool free : {false, true}) {
            QTest::addRow("our example%s", free ? ", free plane" : "") << "" << free;
            for (const QString& file : timed(tutorialScenes()))
                QTest::addRow("%s%s", qPrintable(QFileInfo(file).baseName()), free ? ", free plane" : "")
                    << file << free;
        }
    }
    void sectionSlider() {
        QFETCH(QString, file);
        QFETCH(bool, free);
        WindowDriver d;
        if (!file.isEmpty()) QVERIFY(d->openFile(file));
        QVERIFY(d.rests());
        SectionPanel* section = d->study<SectionPanel>();
        if (free) section->turn(30, 20);
        QVERIFY(d.rests());
        const SectionTravel travel = travelOf(section->plane(), section->view()->field().container);
        std::vector<double> times, work;
        std::size_t samples = 0;
        QElapsedTimer since;
        connect(section, &SectionPanel::sampled, section,
                [&] { samples = section->view()->field().values.size(); });
        for (int i = 1; i <= 2 * moves; ++i) {
            const qint64 before = section->view()->frame().cacheKey();
            samples = 0;
            since.start();
            const std::clock_t begin = std::clock();
            section->setPosition(travel.low + (travel.high - travel.low) * i / (2 * moves + 1));
            // No polling, which would add up to 10 ms.
            while (samples == 0 || section->view()->frame().cacheKey() == before)
                QCoreApplication::processEvents(QEventLoop::WaitForMoreEvents);
            times.push_back(static_cast<double>(since.nsecsElapsed()) / 1e6);
            work.push_back(1e3 * static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC);
        }
        qInfo("%zu samples, panel of %d x %d", samples, section->view()->width(), section->view()->height());
        report("section on the screen", times);
        report("processor time for it, all threads", work);
    }

    /// How many pictures a second a slider shows that plays, at 480 x 270; every value has its own. Panels
    /// beside each other are all painted, those behind tabs are not.
    void playedPicturesASecond_data() {
        QTest::addColumn<QString>("scene");
        QTest::addColumn<bool>("allPanels");
        for (const QString& scene : benchScenes())
            QTest::addRow("%s", qPrintable(QFileInfo(scene).baseName())) << scene << false;
        for (const QString& scene : timed(benchScenes()))
            QTest::addRow("%s, all panels", qPrintable(QFileInfo(scene).baseName())) << scene << true;
    }
    void playedPicturesASecond() {
        QFETCH(QString, scene);
        QFETCH(bool, allPanels);
        WindowDriver d;
        QVERIFY(d->openFile(scene));
        d->viewport()->setFixedSize(480, 270);
        for (QDockWidget* dock : allPanels ? d->docks()->all() : QList<QDockWidget*>()) {
            dock->setFloating(true);
            d->docks()->bringUp(dock);
        }
        QVERIFY(d.rests(60000));
        const int row = rowToPlay(d->parameters());
        if (row < 0) QSKIP("nothing to play");
        SliderPlayer* player = d->parameters()->player();
        int values = 0, pictures = 0;
        double seconds = 0;
        connect(player, &SliderPlayer::played, &d.window(), [&] { ++values; });
        connect(d->viewport(), &Viewport::progressed, &d.window(), [&](const RenderProgress& progress) {
            if (!progress.finished) return;
            ++pictures;
            seconds += progress.seconds;
        });
        d->parameters()->slider(row)->setPlay({PlayMode::pingPong, 2});
        QElapsedTimer time;
        time.start();
        const double begin = windowSeconds();
        player->start(row);
        QVERIFY(handlesEventsUntil([&] { return time.elapsed() >= 2000; }));
        const double took = static_cast<double>(time.nsecsElapsed()) * 1e-9, window = windowSeconds() - begin;
        qInfo("%s: %.1f pictures a second, of %.1f ms each; %.1f ms each of the window's thread",
              qPrintable(d->parameters()->slider(row)->fullName()), pictures / took,
              1000 * seconds / std::max(1, pictures), 1000 * window / std::max(1, pictures));
        QVERIFY(std::abs(values - pictures) <= 1);
        player->stop();
        QVERIFY(d.rests(60000));
    }
};

QTEST_MAIN(LatencyTest)
#include "latency_test.moc"
