// SPDX-License-Identifier: GPL-3.0-or-later
#include <QTest>

#include "widgets/viewport/picture_buffer.h"

using namespace isoscope;

namespace {

constexpr QRgb red = 0xffff0000, green = 0xff00ff00, blue = 0xff0000ff;

FinishedTile tile(std::uint64_t job, int x, int y, int width, int height, QRgb color) {
    return {job,   x,      y,
            width, height, std::vector<std::uint32_t>(static_cast<std::size_t>(width) * height, color)};
}

}  // namespace

class PictureBufferTest : public QObject {
    Q_OBJECT

  private slots:
    void nothingIsShownBeforeTheFirstPassIsComplete() {
        PictureBuffer buffer;
        buffer.expect(1, {4, 2});
        QVERIFY(!buffer.add({tile(1, 0, 0, 2, 2, red)}));
        QVERIFY(buffer.picture().isNull());
        QVERIFY(buffer.add({tile(1, 2, 0, 2, 2, green)}));
        QCOMPARE(buffer.picture().size(), QSize(4, 2));
        QCOMPARE(buffer.picture().pixel(1, 1), red);
        QCOMPARE(buffer.picture().pixel(2, 0), green);
    }

    void laterPassesSharpenTheShownPicture() {
        PictureBuffer buffer;
        buffer.expect(1, {2, 1});
        buffer.add({tile(1, 0, 0, 2, 1, red)});
        QVERIFY(buffer.add({tile(1, 1, 0, 1, 1, blue)}));
        QCOMPARE(buffer.picture().pixel(0, 0), red);
        QCOMPARE(buffer.picture().pixel(1, 0), blue);
    }

    void previousPictureStaysUntilTheNextIsCovered() {
        PictureBuffer buffer;
        buffer.expect(1, {2, 2});
        buffer.add({tile(1, 0, 0, 2, 2, red)});
        buffer.expect(2, {3, 3});
        QVERIFY(!buffer.add({tile(2, 0, 0, 3, 2, green)}));
        QCOMPARE(buffer.picture().size(), QSize(2, 2));
        QCOMPARE(buffer.picture().pixel(0, 0), red);
        QVERIFY(buffer.add({tile(2, 0, 2, 3, 1, green)}));
        QCOMPARE(buffer.picture().size(), QSize(3, 3));
        QCOMPARE(buffer.shownJob(), 2u);
    }

    void lateTilesOfOldJobsAreDropped() {
        PictureBuffer buffer;
        buffer.expect(1, {2, 1});
        buffer.expect(2, {2, 1});
        buffer.add({tile(2, 0, 0, 2, 1, green)});
        QVERIFY(!buffer.add({tile(1, 0, 0, 2, 1, red)}));
        QCOMPARE(buffer.picture().pixel(0, 0), green);
    }

    void jobsThatNeverBeganAreSkipped() {
        PictureBuffer buffer;
        for (std::uint64_t job = 1; job <= 50; ++job) buffer.expect(job, {2, 1});
        QVERIFY(buffer.add({tile(37, 0, 0, 2, 1, red)}));
        QVERIFY(buffer.add({tile(50, 0, 0, 2, 1, blue)}));
        QCOMPARE(buffer.picture().pixel(0, 0), blue);
    }

    void unknownJobsAreDropped() {
        PictureBuffer buffer;
        QVERIFY(!buffer.add({tile(7, 0, 0, 2, 1, red)}));
        QVERIFY(buffer.picture().isNull());
    }

    void samePictureIsRevealedOnlyWhenComplete() {
        PictureBuffer buffer;
        buffer.expect(1, {2, 1});
        buffer.add({tile(1, 0, 0, 2, 1, red)});
        buffer.expect(2, {2, 1}, PictureBuffer::Reveal::whenComplete);
        QVERIFY(!buffer.add({tile(2, 0, 0, 2, 1, green)}));
        QVERIFY(!buffer.add({tile(2, 0, 0, 2, 1, blue)}));
        QCOMPARE(buffer.picture().pixel(0, 0), red);
        QVERIFY(buffer.complete(2));
        QCOMPARE(buffer.picture().pixel(0, 0), blue);
    }

    void stoppedBeforeCoverageShowsNothingNew() {
        PictureBuffer buffer;
        buffer.expect(1, {2, 1}, PictureBuffer::Reveal::whenComplete);
        buffer.add({tile(1, 0, 0, 1, 1, green)});
        QVERIFY(!buffer.complete(1));
        QVERIFY(buffer.picture().isNull());
    }

    void tilesBeyondThePictureAreCut() {
        PictureBuffer buffer;
        buffer.expect(1, {3, 2});
        buffer.add({tile(1, 0, 0, 3, 2, red)});
        buffer.add({tile(1, 2, 1, 5, 5, blue), tile(1, -2, -2, 3, 3, green), tile(1, 9, 9, 2, 2, blue)});
        QCOMPARE(buffer.picture().pixel(2, 1), blue);
        QCOMPARE(buffer.picture().pixel(0, 0), green);
        QCOMPARE(buffer.picture().pixel(1, 0), red);
    }

    /// D36: coarse passes were bare blocks.
    void coarsePassesAreDrawnSmoothly() {
        PictureBuffer buffer;
        buffer.expect(1, {64, 16});
        FinishedTile coarse = tile(1, 0, 0, 64, 16, 0xff000000);
        coarse.block = 8;
        for (int y = 0; y < 16; ++y)
            for (int x = 0; x < 64; ++x)
                coarse.pixels[static_cast<std::size_t>(y * 64 + x)] =
                    0xff000000u | static_cast<QRgb>(x / 8 * 32) << 16;
        QVERIFY(buffer.add({coarse}));
        int greatest = 0;
        for (int x = 1; x < 64; ++x)
            greatest = std::max(greatest,
                                qRed(buffer.picture().pixel(x, 7)) - qRed(buffer.picture().pixel(x - 1, 7)));
        QVERIFY2(greatest > 0 && greatest <= 5, qPrintable(QString::number(greatest)));
        // In the middle of a block stands its colour, and a block of one colour among others of the same
        // keeps it.
        QVERIFY(std::abs(qRed(buffer.picture().pixel(20, 7)) - 2 * 32) <= 4);
        // A finer pass of a part replaces that part, and joins the rest.
        FinishedTile finer = tile(1, 32, 0, 32, 16, 0xffffffff);
        finer.block = 2;
        QVERIFY(buffer.add({finer}));
        QCOMPARE(buffer.picture().pixel(50, 7), 0xffffffffu);
        QVERIFY(std::abs(qRed(buffer.picture().pixel(20, 7)) - 2 * 32) <= 4);
        FinishedTile full = tile(1, 0, 0, 64, 16, blue);
        QVERIFY(buffer.add({full}));
        QCOMPARE(buffer.picture().pixel(13, 3), blue);
    }

    void coarseTilesThatAreBrokenAreIgnored() {
        PictureBuffer buffer;
        buffer.expect(1, {5, 3});
        buffer.add({tile(1, 0, 0, 5, 3, red)});
        FinishedTile broken = tile(1, 0, 0, 5, 3, green);
        broken.block = 4;
        broken.pixels.resize(2);
        FinishedTile beyond = tile(1, 4, 0, 40, 40, green);
        beyond.block = 4;
        buffer.add({broken, beyond});
        QCOMPARE(buffer.picture().pixel(0, 0), red);
    }

    void tilesWithTooFewPixelsAreIgnored() {
        PictureBuffer buffer;
        buffer.expect(1, {2, 1});
        buffer.add({tile(1, 0, 0, 2, 1, red)});
        FinishedTile broken = tile(1, 0, 0, 2, 1, blue);
        broken.pixels.resize(1);
        buffer.add({broken});
        QCOMPARE(buffer.picture().pixel(0, 0), red);
    }
};

QTEST_APPLESS_MAIN(PictureBufferTest)
#include "picture_buffer_test.moc"
