// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <ctime>
#include <functional>
#include <QDir>
#include <QElapsedTimer>
#include <QtTest>

#include "app/desktop/window/actions.h"
#include "tests/app/window_driver.h"
#include "tests/support/csv_table.h"
#include "widgets/parameters/parameter_panel.h"
#include "widgets/parameters/parameter_slider.h"
#include "widgets/section/section_panel.h"
#include "widgets/section/section_view.h"
#include "widgets/studies/accuracy_panel.h"
#include "widgets/viewport/viewport.h"

using namespace isoscope;
using namespace isoscope::test;

namespace {

constexpr int moves = 7;

void report(const char* what, std::vector<double> milliseconds) {
    std::sort(milliseconds.begin(), milliseconds.end());
    qInfo("%s: median %.0f ms, worst %.0f ms", what, milliseconds[milliseconds.size() / 2],
          milliseconds.back());
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

QStringList scenesOf(const QDir& folder, const QString& pattern) {
    QStringList scenes;
    for (const QFileInfo& file : folder.entryInfoList({pattern})) scenes << file.filePath();
    return scenes;
}

QStringList tutorialScenes() {
    return scenesOf(QFileInfo(dataFile(QStringLiteral("spec/examples/iso_sum_noise.pov"))).dir(),
                    QStringLiteral("iso_*.pov"));
}

QStringList benchScenes() {
    return scenesOf(QDir(QStringLiteral(ISOSCOPE_SOURCE_DIR "/tests/bench")), QStringLiteral("*.pov"));
}

}  // namespace

/// Prints how long the window takes to answer; asserts only that it does, since the machine may be busy.
class LatencyTest : public QObject {
    Q_OBJECT

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

    /// The example at start, every scene of the tutorial that has isosurfaces, and the scenes of `make
    /// bench`.
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
            for (const QString& file : tutorialScenes())
                QTest::addRow("%s, %s", qPrintable(QFileInfo(file).baseName()), finder)
                    << file << "max_gradient" << certified << size;
        }
        for (const QSize& benchSize : {QSize(480, 270), QSize(960, 540)})
            for (const QString& file : benchScenes())
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
        std::vector<double> coarse, full;
        QElapsedTimer since;
        double finishedAfter = 0;
        connect(d->viewport(), &Viewport::pictureFinished, this, [&] {
            if (finishedAfter == 0) finishedAfter = static_cast<double>(since.nsecsElapsed()) / 1e6;
        });
        for (int i = 1; i <= moves; ++i) {
            const qint64 before = d->viewport()->picture().cacheKey();
            since.start();
            finishedAfter = 0;
            emit d->parameters()->valueChanged(index, first * (1 + 0.02 * i));
            QVERIFY(handlesEventsUntil([&] { return d->viewport()->picture().cacheKey() != before; }));
            coarse.push_back(static_cast<double>(since.nsecsElapsed()) / 1e6);
            QVERIFY(handlesEventsUntil([&] { return finishedAfter > 0; }));
            full.push_back(finishedAfter);
            QVERIFY(d.rests());
        }
        report("first coarse picture", coarse);
        report("full picture", full);
    }

    /// A whole study of the Accuracy panel, planning included, and how soon its stop button acts.
    void accuracyStudy_data() {
        QTest::addColumn<QString>("file");
        QTest::addRow("our example") << "";
        for (const QString& file : tutorialScenes())
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
            for (const QString& file : tutorialScenes())
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
};

QTEST_MAIN(LatencyTest)
#include "latency_test.moc"
