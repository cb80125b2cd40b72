// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/language/sliders/slider_play.h"

#include <QTest>

using namespace isoscope;

class SliderPlayTest : public QObject {
    Q_OBJECT

  private slots:
    void goesWithTheClock_data() {
        QTest::addColumn<int>("mode");
        QTest::addColumn<double>("start");
        QTest::addColumn<double>("elapsed");
        QTest::addColumn<double>("share");
        QTest::addColumn<bool>("ended");
        const auto row = [](const char* name, PlayMode mode, double start, double elapsed, double share,
                            bool ended) {
            QTest::newRow(name) << static_cast<int>(mode) << start << elapsed << share << ended;
        };
        row("begins where it is", PlayMode::loop, 0.25, 0, 0.25, false);
        row("moves", PlayMode::loop, 0.25, 1, 0.5, false);
        row("begins anew", PlayMode::loop, 0.25, 3.5, 0.125, false);
        row("many rounds", PlayMode::loop, 0, 41, 0.25, false);
        row("turns", PlayMode::pingPong, 0.25, 4, 0.75, false);
        row("turns again", PlayMode::pingPong, 0, 9, 0.25, false);
        row("turns at the end", PlayMode::pingPong, 1, 1, 0.75, false);
        row("once", PlayMode::once, 0.5, 1, 0.75, false);
        row("once, behind the end", PlayMode::once, 0.5, 7, 1, true);
        row("once, at the end", PlayMode::once, 0.5, 2, 1, true);
        row("once, from the end", PlayMode::once, 1, 1, 0.25, false);
    }
    void goesWithTheClock() {
        QFETCH(int, mode);
        QFETCH(double, start);
        QFETCH(double, elapsed);
        QFETCH(double, share);
        QFETCH(bool, ended);
        const PlayPlace place = playPlace({static_cast<PlayMode>(mode), 4}, start, elapsed);
        QCOMPARE(place.share, share);
        QCOMPARE(place.ended, ended);
    }
};

QTEST_APPLESS_MAIN(SliderPlayTest)
#include "slider_play_test.moc"
