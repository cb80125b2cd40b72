// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/accuracy/picture_time.h"

#include <QTest>
#include <vector>

#include "tests/support/study_scene.h"

using namespace isoscope;
using namespace isoscope::test;

namespace {

const std::string ball =
    "isosurface { function { x*x + y*y + z*z - 1 } contained_by { sphere { 0, 1.2 } } pigment { rgb 1 } }\n";
constexpr PictureTimeEffort all{0, 1e9, 0, 1'000'000, 1e9};

}  // namespace

/// What is told of the time of pictures. How near it comes to the clock depends on the machine: `isoscope-cli
/// predict --check` tells.
class PictureTimeTest : public QObject {
    Q_OBJECT

  private slots:
    void everySquareIsDrawnOnceWhenAllAreWanted() {
        // 10 x 7 squares, those at the right and below cut off.
        const PictureTime time = predictPictureTime(studyScene(ball, 310, 200), all);
        QVERIFY(time.complete);
        QCOMPARE(time.squares, std::size_t(70));
        QCOMPARE(time.sampled, time.squares);
        QVERIFY(time.cpuSeconds > 0);
        // Nothing is left to guess but the clock.
        QCOMPARE(time.error, timingError);
        QCOMPARE(time.secondsWith(4), time.cpuSeconds / 4);
    }

    void fewSquaresTellOfALargePicture() {
        const PictureTime time = predictPictureTime(studyScene(ball, 16384, 12288), {1e9, 1e9, 1e9, 30, 1e9});
        QVERIFY(time.complete);
        QCOMPARE(time.squares, std::size_t(512 * 384));
        QCOMPARE(time.sampled, std::size_t(30));
        QVERIFY(time.error > timingError);
    }

    void itTellsOnTheWay() {
        std::vector<PictureTime> told;
        const PictureTime last = predictPictureTime(studyScene(ball, 640, 480), {1e9, 1e9, 1e9, 100, 1e9}, {},
                                                    [&](const PictureTime& time) { told.push_back(time); });
        QVERIFY(told.size() > 3);
        QCOMPARE(told.front().sampled, std::size_t(8));
        for (std::size_t i = 0; i + 1 < told.size(); ++i)
            QVERIFY(!told[i].complete && told[i].sampled < told[i + 1].sampled);
        QVERIFY(told.back().complete);
        QCOMPARE(told.back().sampled, last.sampled);
    }

    void whatCannotBeDrawnTakesNoTime() {
        QCOMPARE(predictPictureTime({}).squares, std::size_t(0));
        RenderRequest request = studyScene(ball);
        request.width = 0;
        QCOMPARE(predictPictureTime(request).squares, std::size_t(0));
        std::stop_source stop;
        stop.request_stop();
        QVERIFY(!predictPictureTime(studyScene(ball), {}, stop.get_token()).complete);
    }
};

QTEST_APPLESS_MAIN(PictureTimeTest)
#include "picture_time_test.moc"
