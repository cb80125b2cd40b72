// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/render/progressive/block_passes.h"

#include <QTest>

using namespace isoscope;
using Which = BlockPasses::Which;

namespace {

/// How often each pixel would be traced, and how often each pass's tiles cover it.
struct Count {
    Count(const BlockPasses& passes, int width, int height)
        : traced(static_cast<std::size_t>(width * height)), covered(traced.size()) {
        for (std::size_t pass = 0; pass < passes.count(); ++pass)
            for (std::size_t i = 0; i < passes.tileCount(pass); ++i)
                add(passes, pass, passes.tile(pass, i), width);
    }
    void add(const BlockPasses& passes, std::size_t pass, const PixelRectangle& tile, int width) {
        const int block = passes.block(pass);
        for (int y = tile.y; y < tile.y + tile.height; ++y) {
            for (int x = tile.x; x < tile.x + tile.width; ++x) {
                ++covered[static_cast<std::size_t>(y * width + x)];
                if (x % block != 0 || y % block != 0) continue;
                const PixelIndex sample = passes.sample(pass, x, y);
                inside = inside && sample.x >= tile.x && sample.x < tile.x + tile.width &&
                         sample.y >= tile.y && sample.y < tile.y + tile.height;
                if (!passes.drawnBefore(pass, sample.x, sample.y))
                    ++traced[static_cast<std::size_t>(sample.y * width + sample.x)];
            }
        }
    }

    std::vector<int> traced, covered;
    bool inside = true;
};

}  // namespace

class BlockPassesTest : public QObject {
    Q_OBJECT

  private slots:
    void everyPixelIsTracedOnceAndCoveredInEachPass() {
        for (int width : {1, 2, 5, 8, 9, 31, 64, 129, 200})
            for (int height : {1, 3, 4, 12, 70}) {
                for (int second : {2, 4}) {
                    const BlockPasses passes(width, height, 1, second);
                    const Count count(passes, width, height);
                    QVERIFY(count.inside);
                    for (int times : count.traced) QCOMPARE(times, 1);
                    for (int times : count.covered) QCOMPARE(times, 3);
                }
            }
    }

    void onePassIsTheLastOfThem() {
        for (const int finest : {1, 2, 4, 8}) {
            const BlockPasses all(70, 31, finest), one(70, 31, finest, 2, Which::last);
            QCOMPARE(one.count(), std::size_t{1});
            QCOMPARE(one.block(0), all.block(all.count() - 1));
            for (int times : Count(one, 70, 31).covered) QCOMPARE(times, 1);
        }
        for (int times : Count(BlockPasses(70, 31, 1, 2, Which::last), 70, 31).traced) QCOMPARE(times, 1);
        // It is not seen to grow.
        QCOMPARE(BlockPasses(960, 540, 1, 2, Which::lastInLargeTiles).tileCount(0), std::size_t(15 * 9));
        QCOMPARE(BlockPasses(960, 540, 1).tileCount(2), std::size_t(30 * 17));
    }

    void coarsePassesTakeTheMiddleOfTheBlock() {
        const BlockPasses passes(100, 100, 1);
        QCOMPARE(passes.block(0), 8);
        QCOMPARE(passes.sample(0, 17, 23).x, 20);
        QCOMPARE(passes.sample(0, 17, 23).y, 20);
        QCOMPARE(passes.sample(0, 99, 99).x, 99);  // the block is cut off by the edge
        QVERIFY(passes.drawnBefore(1, 20, 20));
        QVERIFY(!passes.drawnBefore(0, 20, 20));
        QVERIFY(!passes.drawnBefore(1, 22, 20));
    }
};

QTEST_APPLESS_MAIN(BlockPassesTest)
#include "block_passes_test.moc"
