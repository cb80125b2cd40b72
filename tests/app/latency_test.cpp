// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <QDir>
#include <QElapsedTimer>
#include <QtTest>

#include "app/desktop/actions.h"
#include "tests/app/window_driver.h"
#include "tests/support/csv_table.h"
#include "widgets/parameter_panel.h"
#include "widgets/parameter_slider.h"
#include "widgets/section_panel.h"
#include "widgets/viewport.h"

using namespace isoscope;
using namespace isoscope::test;

namespace {

constexpr int moves = 12;

void report(const char* what, std::vector<double> milliseconds) {
    std::sort(milliseconds.begin(), milliseconds.end());
    qInfo("%s: median %.0f ms, worst %.0f ms", what, milliseconds[milliseconds.size() / 2],
          milliseconds.back());
}

QStringList tutorialScenes() {
    const QDir folder = QFileInfo(dataFile(QStringLiteral("spec/examples/iso_sum_noise.pov"))).dir();
    QStringList scenes;
    for (const QFileInfo& file : folder.entryInfoList({QStringLiteral("iso_*.pov")}))
        scenes << file.filePath();
    return scenes;
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
        QVERIFY(QTest::qWaitFor([&] { return !d->viewport()->picture().isNull(); }, 20000));
        qInfo("window with the first picture: %lld ms", since.elapsed());
        QVERIFY(d.rests());
        qInfo("everything at rest: %lld ms", since.elapsed());
    }

    /// The example at start, and every scene of the tutorial that has isosurfaces.
    void sliderMove_data() {
        QTest::addColumn<QString>("file");
        QTest::addColumn<QString>("name");
        QTest::addColumn<bool>("certified");
        for (const bool certified : {true, false}) {
            const char* finder = certified ? "certified" : "POV-Ray";
            QTest::addRow("with a slot, %s", finder) << ""
                                                     << "Radius" << certified;
            QTest::addRow("by a parse, %s", finder) << ""
                                                    << "max_gradient" << certified;
            for (const QString& file : tutorialScenes())
                QTest::addRow("%s, %s", qPrintable(QFileInfo(file).baseName()), finder)
                    << file << "max_gradient" << certified;
        }
    }
    void sliderMove() {
        QFETCH(QString, file);
        QFETCH(QString, name);
        QFETCH(bool, certified);
        WindowDriver d;
        (certified ? d->actions()->certified : d->actions()->povray)->trigger();
        d->resize(1600, 1200);
        if (!file.isEmpty()) QVERIFY(d->openFile(file));
        d.rests();
        // 800 x 600 for the viewport, whatever the docks take.
        d->viewport()->setFixedSize(800, 600);
        QVERIFY(QTest::qWaitFor([&] { return d->viewport()->picture().size() == QSize(800, 600); }, 20000));
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
            QVERIFY(QTest::qWaitFor([&] { return d->viewport()->picture().cacheKey() != before; }, 20000));
            coarse.push_back(static_cast<double>(since.nsecsElapsed()) / 1e6);
            QVERIFY(QTest::qWaitFor([&] { return finishedAfter > 0; }, 20000));
            full.push_back(finishedAfter);
            QVERIFY(d.rests());
        }
        report("first coarse picture", coarse);
        report("full picture", full);
    }

    void section() {
        WindowDriver d;
        QVERIFY(d.rests());
        std::vector<double> times;
        connect(d->section(), &SectionPanel::sampled, d->section(), [&](double ms) { times.push_back(ms); });
        for (int i = 0; i < moves; ++i) {
            d->section()->setPosition(-0.5 + i * 0.05);
            QVERIFY(d.rests());
        }
        QVERIFY(!times.empty());
        report("sampling the cross-section", times);
    }
};

QTEST_MAIN(LatencyTest)
#include "latency_test.moc"
