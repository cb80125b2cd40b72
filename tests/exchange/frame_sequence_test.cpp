// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/exchange/frame_sequence.h"

#include <chrono>
#include <fstream>
#include <QTemporaryDir>
#include <QTest>
#include <set>

#include "core/exchange/png.h"

using namespace isoscope;
namespace fs = std::filesystem;

class FrameSequenceTest : public QObject {
    Q_OBJECT

  private slots:
    void partsAreRead() {
        QVERIFY(readWorkPart("3/16") && readWorkPart("3/16")->number == 3 &&
                readWorkPart("3/16")->count == 16);
        for (const char* text : {"", "3", "/", "0/4", "5/4", "-1/4", "1/0", "1/4x", "a/b", "1 / 4"})
            QVERIFY2(!readWorkPart(text), text);
    }

    void allPartsAreAllFramesOnce() {
        const FrameSequence frames{3, 41, 0, 1, "f"};
        for (const int count : {1, 2, 7, 39, 50}) {
            std::multiset<int> all;
            for (int number = 1; number <= count; ++number) {
                const std::vector<int> part = frames.framesOf({number, count});
                all.insert(part.begin(), part.end());
                // As many as the others, give or take one.
                QVERIFY(part.size() == std::size_t(39 / count) || part.size() == std::size_t(39 / count + 1));
            }
            QCOMPARE(all.size(), std::size_t(39));
            QCOMPARE(*all.begin(), 3);
            QCOMPARE(*all.rbegin(), 41);
            for (const int frame : all) QCOMPARE(all.count(frame), std::size_t(1));
        }
        const FrameSequence last{2147483640, 2147483647, 0, 1, "f"};
        QCOMPARE(last.framesOf({8, 8}), std::vector<int>{2147483647});
    }

    void theClockRunsEvenly() {
        const FrameSequence frames{10, 20, -1, 1.1, "f"};
        QCOMPARE(frames.clock(10), -1.0);
        QCOMPARE(frames.clock(15), 0.05);
        QCOMPARE(frames.clock(20), 1.1);
        QCOMPARE((FrameSequence{5, 5, 0.25, 1, "f"}.clock(5)), 0.25);
    }

    void namesHaveTheDigitsOfTheLast() {
        const FrameSequence frames{0, 239, 0, 1, "out/torus"};
        QCOMPARE(frames.file(0), fs::path("out/torus000.png"));
        QCOMPARE(frames.file(239), fs::path("out/torus239.png"));
        QCOMPARE((FrameSequence{0, 9, 0, 1, "f"}.file(9)), fs::path("f9.png"));
    }

    void aFrameIsDrawnWhenItsPictureIsThereAndNewer() {
        QTemporaryDir folder;
        const fs::path scene = folder.filePath("s.pov").toStdString(),
                       file = folder.filePath("s0.png").toStdString();
        std::ofstream(scene) << "sphere {}";
        QVERIFY(!isDrawn(file, 300, 2, scene));
        std::ofstream(file, std::ios::binary) << encodePng(Image(300, 2), 1);
        QVERIFY(isDrawn(file, 300, 2, scene));
        QVERIFY(!isDrawn(file, 2, 300, scene));
        fs::last_write_time(scene, fs::last_write_time(file) + std::chrono::seconds(5));
        QVERIFY(!isDrawn(file, 300, 2, scene));
        fs::last_write_time(scene, fs::last_write_time(file));
        QVERIFY(isDrawn(file, 300, 2, scene));
        std::ofstream(file, std::ios::binary) << "no picture, but long enough to be one";
        QVERIFY(!isDrawn(file, 300, 2, scene));
        QVERIFY(!isDrawn(file, 300, 2, folder.filePath("gone.pov").toStdString()));
    }
};

QTEST_APPLESS_MAIN(FrameSequenceTest)
#include "frame_sequence_test.moc"
