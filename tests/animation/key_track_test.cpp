// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/animation/key_track.h"

#include <cmath>
#include <QTest>

using namespace isoscope;

class KeyTrackTest : public QObject {
    Q_OBJECT

    static KeyTrack two(Easing easing) { return {"R", {{10, 2, easing}, {20, 4, Easing::smooth}}}; }

  private slots:
    void valuesStayOutsideTheKeys() {
        const KeyTrack track = two(Easing::linear);
        QCOMPARE(track.value(-1e9), 2.0);
        QCOMPARE(track.value(10), 2.0);
        QCOMPARE(track.value(20), 4.0);
        QCOMPARE(track.value(1e9), 4.0);
        QCOMPARE(track.value(std::nan("")), 2.0);
        QCOMPARE(KeyTrack().value(3), 0.0);
    }

    void easings_data() {
        QTest::addColumn<QString>("word");
        QTest::addColumn<double>("quarter");
        QTest::addColumn<double>("half");
        QTest::newRow("linear") << "linear" << 2.5 << 3.0;
        QTest::newRow("smooth") << "smooth" << 2 + 2 * (3.0 / 16 - 2.0 / 64) << 3.0;
        QTest::newRow("slow-start") << "slow-start" << 2.125 << 2.5;
        QTest::newRow("slow-end") << "slow-end" << 2.875 << 3.5;
        QTest::newRow("hold") << "hold" << 2.0 << 2.0;
        // Between two keys alone there is no slope at either.
        QTest::newRow("curve") << "curve" << 2 + 2 * (3.0 / 16 - 2.0 / 64) << 3.0;
    }
    void easings() {
        QFETCH(QString, word);
        const auto easing = easingOf(word.toStdString());
        QVERIFY(easing);
        QCOMPARE(easingWord(*easing), std::string_view(word.toStdString()));
        const KeyTrack track = two(*easing);
        QTEST(track.value(12.5), "quarter");
        QTEST(track.value(15), "half");
        QVERIFY(!easingOf("bounce"));
    }

    /// The ways of a curve meet with one slope, and never leave the range of their keys.
    void curvesPassTheirKeysWithoutRestOrOvershoot() {
        KeyTrack track{"R", {}};
        const double values[] = {0, 1, 5, 5.5, 2, 2, -3};
        for (int i = 0; i < 7; ++i) track.put({i * i, values[i], Easing::curve});
        for (std::size_t i = 0; i + 2 < track.keys.size(); ++i) {
            const KeyWay before = track.way(i), behind = track.way(i + 1);
            const double length = track.keys[i + 1].frame - track.keys[i].frame;
            const double next = track.keys[i + 2].frame - track.keys[i + 1].frame;
            const double end = (before.c[1] + 2 * before.c[2] + 3 * before.c[3]) / length;
            QVERIFY(std::abs(end - behind.c[1] / next) < 1e-12);
            QVERIFY(std::abs(before.at(1) - track.keys[i + 1].value) < 1e-12);
        }
        QVERIFY(track.way(1).c[1] > 0);    // 0, 1, 5 goes on rising
        QCOMPARE(track.way(3).c[1], 0.0);  // 5.5 is the top
        for (std::size_t i = 0; i + 1 < track.keys.size(); ++i)
            for (double u = 0; u <= 1; u += 0.01) {
                const auto [low, high] = std::minmax(track.keys[i].value, track.keys[i + 1].value);
                const double value = track.way(i).at(u);
                QVERIFY(value >= low - 1e-12 && value <= high + 1e-12);
            }
    }

    void keysHaveTheirOrder() {
        KeyTrack track{"R", {}};
        track.put({5, 1});
        track.put({0, 2});
        track.put({9, 3});
        track.put({5, 4, Easing::hold});
        QCOMPARE(track.keys, (std::vector<Key>{{0, 2}, {5, 4, Easing::hold}, {9, 3}}));
        QVERIFY(track.at(5) && track.at(5)->value == 4 && !track.at(4));
        QVERIFY(track.remove(0) && !track.remove(0));
        QCOMPARE(track.keys.size(), 2u);
        QCOMPARE(track.value(8.5), 4.0);
        QCOMPARE(track.value(9), 3.0);
    }
};

QTEST_GUILESS_MAIN(KeyTrackTest)
#include "key_track_test.moc"
