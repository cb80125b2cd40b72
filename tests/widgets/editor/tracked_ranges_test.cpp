// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/editor/tracked_ranges.h"

#include <QRandomGenerator>
#include <QTest>

using namespace isoscope;
using Range = TrackedRanges::Range;

class TrackedRangesTest : public QObject {
    Q_OBJECT

  private slots:
    void movesWithTextBefore() {
        TrackedRanges ranges;
        ranges.set({{10, 12}, {20, 25}});
        ranges.inserted(3, 4);
        QCOMPARE(*ranges.range(0), (Range{14, 16}));
        QCOMPARE(*ranges.range(1), (Range{24, 29}));
        ranges.removed(18, 3);
        QCOMPARE(*ranges.range(0), (Range{14, 16}));
        QCOMPARE(*ranges.range(1), (Range{21, 26}));
    }

    void losesWhatIsTouched() {
        TrackedRanges ranges;
        ranges.set({{10, 12}});
        ranges.inserted(12, 1);  // a digit behind it makes another number
        QVERIFY(!ranges.range(0));
        ranges.set({{10, 12}});
        ranges.removed(8, 2);  // nothing separates it from what is before
        QVERIFY(!ranges.range(0));
        ranges.set({{10, 12}});
        ranges.removed(13, 5);
        QCOMPARE(*ranges.range(0), (Range{10, 12}));
    }

    void followsItsOwnRewriting() {
        TrackedRanges ranges;
        ranges.set({{0, 30}, {10, 12}, {12, 15}, {20, 25}, {11, 13}});
        ranges.rewritten(10, 12, 16);
        QCOMPARE(*ranges.range(0), (Range{0, 34}));   // around it
        QCOMPARE(*ranges.range(1), (Range{10, 16}));  // itself
        QCOMPARE(*ranges.range(2), (Range{16, 19}));  // right behind it
        QCOMPARE(*ranges.range(3), (Range{24, 29}));
        QVERIFY(!ranges.range(4));  // cut
    }

    void findsExactRangesOnly() {
        TrackedRanges ranges;
        ranges.set({{0, 30}, {10, 12}});
        QCOMPARE(ranges.indexOf({10, 12}), 1);
        QCOMPARE(ranges.indexOf({10, 13}), -1);
        QVERIFY(!ranges.range(-1));
        QVERIFY(!ranges.range(2));
    }

    /// The marked words of a random text must stay the same words through random edits.
    void keepsPointingAtTheSameText() {
        const quint32 seed = QRandomGenerator::global()->generate();
        QRandomGenerator random(seed);
        for (int round = 0; round < 200; ++round) {
            std::string text(60, '.');
            std::vector<Range> set;
            for (int i = 0; i < 4; ++i) {
                const int begin = 5 + i * 13;
                text.replace(begin, 3, std::string(3, static_cast<char>('a' + i)));
                set.push_back({begin, begin + 3});
            }
            TrackedRanges ranges;
            ranges.set(set);
            for (int edit = 0; edit < 20; ++edit) {
                const int at = random.bounded(static_cast<int>(text.size()));
                const int length = 1 + random.bounded(3);
                if (random.bounded(2)) {
                    text.insert(at, length, '-');
                    ranges.inserted(at, length);
                } else {
                    const int removed = std::min<int>(length, static_cast<int>(text.size()) - at);
                    text.erase(at, removed);
                    ranges.removed(at, removed);
                }
                for (int i = 0; i < 4; ++i) {
                    const auto range = ranges.range(i);
                    if (!range) continue;
                    QVERIFY2(text.substr(range->begin, range->end - range->begin) ==
                                 std::string(3, static_cast<char>('a' + i)),
                             qPrintable(QString("seed %1, round %2").arg(seed).arg(round)));
                }
            }
        }
    }
};

QTEST_APPLESS_MAIN(TrackedRangesTest)
#include "tracked_ranges_test.moc"
