// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/animation/timeline.h"

#include <QTest>
#include <random>

using namespace isoscope;

namespace {

std::string changed(std::string text, const Timeline& wanted) {
    for (const TextEdit& edit : timelineEdits(text, wanted))
        text.replace(edit.begin, edit.end - edit.begin, edit.text);
    return text;
}

}  // namespace

class TimelineTest : public QObject {
    Q_OBJECT

  private slots:
    void commentsAreRead() {
        const Timeline timeline = timelineOf(
            "#declare R = 1;\n  // timeline: frames 10 to 40, clock -1 to 2.5, 24 per second\r\n"
            "// keys \"f_torus (2) Minor Radius\": 40 = 2, 10 = 0.5 slow-end\n// keys \"R\": 0=1e-3 hold");
        QVERIFY(timeline.stated);
        QCOMPARE(timeline.frames.first, 10);
        QCOMPARE(timeline.frames.last, 40);
        QCOMPARE(timeline.frames.firstClock, -1.0);
        QCOMPARE(timeline.frames.finalClock, 2.5);
        QCOMPARE(timeline.rate, 24.0);
        QCOMPARE(timeline.tracks.size(), 2u);
        QCOMPARE(timeline.tracks[0], (KeyTrack{"f_torus (2) Minor Radius",
                                               {{10, 0.5, Easing::slowEnd}, {40, 2, Easing::smooth}}}));
        QCOMPARE(timeline.tracks[1], (KeyTrack{"R", {{0, 0.001, Easing::hold}}}));
        QVERIFY(timeline.any() && !timelineOf("sphere { 0, 1 }").any());
    }

    void otherCommentsAreNone_data() {
        QTest::addColumn<QByteArray>("line");
        for (const char* line :
             {"// keys: the left one", "// keys \"R\"", "// keys \"R\":", "// keys \"R\": 1 = ",
              "// keys \"R\": 1 = 2 bounce", "// keys \"R\": -1 = 2", "// keys \"R\": 1.5 = 2",
              "// keys \"R\": 1 = 2,", "// keys \"R\": 1 = nan", "// keys \"R\": 1 = inf",
              "// keys \"R\": 10000000 = 1", "// timeline: frames 5 to 4", "// timeline: frames 0",
              "// timeline: frames 0 to 9, 0 per second", "// timeline: frames 0 to 9, clock 1",
              "// timeline: frames 0 to 9 and more", "timeline: frames 0 to 9", "/* keys \"R\": 1 = 2 */"})
            QTest::newRow(line) << QByteArray(line);
    }
    void otherCommentsAreNone() {
        QFETCH(QByteArray, line);
        QVERIFY(!timelineOf(line.toStdString()).any());
    }

    void theFirstOfTwoCounts() {
        const Timeline timeline = timelineOf(
            "// keys \"R\": 1 = 2, 1 = 3\n// keys \"R\": 1 = 4\n"
            "// timeline: frames 0 to 5\n// timeline: frames 0 to 6\n");
        QCOMPARE(timeline.tracks, (std::vector<KeyTrack>{{"R", {{1, 2}}}}));
        QCOMPARE(timeline.frames.last, 5);
    }

    void aFirstKeyBeginsABlockAtTheEnd() {
        Timeline timeline;
        timeline.stated = true;
        timeline.putKey("R", {0, 0.5});
        const std::string text = changed("sphere { 0, R }", timeline);
        QCOMPARE(text, std::string("sphere { 0, R }\n// timeline: frames 0 to 119, clock 0 to 1, 30 per "
                                   "second\n// keys \"R\": 0 = 0.5\n"));
        timeline.putKey("camera azimuth", {7, 90, Easing::linear});
        timeline.putKey("R", {60, 1, Easing::hold});
        QCOMPARE(
            changed(text + "// the end\n", timeline),
            std::string("sphere { 0, R }\n// timeline: frames 0 to 119, clock 0 to 1, 30 per second\n"
                        "// keys \"R\": 0 = 0.5, 60 = 1 hold\n// keys \"camera azimuth\": 7 = 90 linear\n"
                        "// the end\n"));
    }

    void theLastKeyTakesTheLineAway() {
        const std::string text = "a\r\n// keys \"R\": 1 = 2, 5 = 3\r\n// keys \"S\": 1 = 2\r\nb";
        Timeline timeline = timelineOf(text);
        QVERIFY(timeline.removeKey("R", 5));
        QCOMPARE(changed(text, timeline),
                 std::string("a\r\n// keys \"R\": 1 = 2\r\n// keys \"S\": 1 = 2\r\nb"));
        QVERIFY(timeline.removeKey("R", 1));
        QVERIFY(!timeline.removeKey("R", 1));
        timeline.putKey("T", {0, 1});
        QCOMPARE(changed(text, timeline),
                 std::string("a\r\n// keys \"S\": 1 = 2\r\n// keys \"T\": 0 = 1\r\nb"));
        QCOMPARE(changed(text, Timeline()), std::string("a\r\nb"));
    }

    void framesOfTheClockAreWhole() {
        Timeline timeline;
        timeline.frames = {3, 122, -1, 0.7, {}};
        for (int frame = 3; frame <= 122; ++frame)
            QCOMPARE(timeline.frameAt(timeline.frames.clock(frame)), double(frame));
        QVERIFY(std::abs(timeline.frameAt(-1 + 1.7 * 0.5) - 62.5) < 1e-9);
        // POV-Ray's clock has single precision.
        timeline.frames = {0, 2000, 0, 1, {}};
        for (int frame = 0; frame <= 2000; ++frame)
            QCOMPARE(timeline.frameAt(static_cast<float>(timeline.frames.clock(frame))), double(frame));
        timeline.frames.first = 3;
        timeline.frames.finalClock = 0;
        QCOMPARE(timeline.frameAt(5), 3.0);
    }

    /// Any change of any timeline is what the changed text says, and other lines stay.
    void changesAreReadBack() {
        const unsigned seed = std::random_device()();
        qInfo("seed %u", seed);
        std::mt19937 random(seed);
        const auto upTo = [&](int most) { return static_cast<int>(random() % (most + 1)); };
        const char* names[] = {"R", "S", "camera azimuth", "f_torus (2) Minor Radius"};
        std::string text = "one\ntwo";
        Timeline timeline;
        for (int i = 0; i < 300; ++i) {
            const std::string name = names[upTo(3)];
            switch (upTo(4)) {
                case 0: timeline.removeKey(name, upTo(5)); break;
                case 1:
                    timeline.stated = upTo(3) > 0;
                    if (!timeline.stated)
                        timeline = {{0, usualLastFrame, 0, 1, {}}, usualFrameRate, timeline.tracks, false};
                    else
                        timeline.frames.last = upTo(1000);
                    break;
                default: timeline.putKey(name, {upTo(5), upTo(1000) / 7.0, allEasings[upTo(5)]});
            }
            text = changed(text, timeline);
            const Timeline read = timelineOf(text);
            QCOMPARE(read.tracks.size(), timeline.tracks.size());
            for (const KeyTrack& track : timeline.tracks)
                QVERIFY(read.track(track.name) && *read.track(track.name) == track);
            QCOMPARE(read.stated, timeline.stated);
            QCOMPARE(read.frames.last, timeline.frames.last);
            QVERIFY(text.starts_with("one\ntwo"));
            QVERIFY(timelineEdits(text, read).empty());
        }
    }
};

QTEST_GUILESS_MAIN(TimelineTest)
#include "timeline_test.moc"
