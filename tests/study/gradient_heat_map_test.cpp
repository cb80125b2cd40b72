// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/gradient/gradient_heat_map.h"

#include <algorithm>
#include <cmath>
#include <QTest>

#include "tests/support/study_scene.h"

using namespace isoscope;
using namespace isoscope::test;

class GradientHeatMapTest : public QObject {
    Q_OBJECT

  private slots:
    void aSphereIsEquallySteepEverywhere() {
        // |grad| = 2 r, whatever the isosurface's size in the world.
        const GradientHeatMap map = gradientHeatMap(
            studyScene("isosurface { function { x*x + y*y + z*z - 1 } contained_by { sphere { 0, 1.2 } } "
                       "max_gradient 4 scale 0.8 }\n",
                       48, 36));
        QVERIFY(map.complete && map.seen > 100);
        QCOMPARE(map.over, std::uint64_t(0));
        std::uint64_t seen = 0;
        for (const float share : map.shares) {
            if (std::isnan(share)) continue;
            ++seen;
            QVERIFY(std::abs(share - 0.5) < 1e-5);
        }
        QCOMPARE(seen, map.seen);
    }

    void whatIsOverTheSettingIsCounted() {
        const GradientHeatMap map = gradientHeatMap(
            studyScene("isosurface { function { x*x + 4*y*y + z*z - 1 } contained_by { box { -1.1, 1.1 } } "
                       "max_gradient 3 }\n",
                       48, 36));
        const auto over =
            std::count_if(map.shares.begin(), map.shares.end(), [](float share) { return share > 1; });
        QVERIFY(over > 10);
        QCOMPARE(map.over, static_cast<std::uint64_t>(over));
        QVERIFY(map.over < map.seen);
        // The steepest place of that ellipsoid is its pole at y = 1/2, where it is 4.
        QVERIFY(map.largest > 1 && map.largest <= 4.0 / 3 + 1e-6);
    }

    void otherObjectsHaveNoGradient() {
        const GradientHeatMap map = gradientHeatMap(studyScene("sphere { 0, 1 }\n", 24, 18));
        QVERIFY(map.complete);
        QCOMPARE(map.seen, std::uint64_t(0));
        QVERIFY(std::all_of(map.shares.begin(), map.shares.end(), [](float s) { return std::isnan(s); }));
    }

    void aStoppedMapIsEmpty() {
        std::stop_source stop;
        stop.request_stop();
        const GradientHeatMap map = gradientHeatMap(
            studyScene("isosurface { function { x } contained_by { box { -1, 1 } } }\n", 24, 18), 0,
            stop.get_token());
        QVERIFY(!map.complete && map.shares.empty());
    }

    void progressEndsAtOne() {
        double last = 0;
        bool backwards = false;
        gradientHeatMap(studyScene("isosurface { function { x } contained_by { box { -1, 1 } } }\n", 100, 80),
                        1, {}, [&](double share) {
                            backwards = backwards || share < last;
                            last = share;
                        });
        QVERIFY(!backwards);
        QCOMPARE(last, 1.0);
    }
};

QTEST_APPLESS_MAIN(GradientHeatMapTest)
#include "gradient_heat_map_test.moc"
