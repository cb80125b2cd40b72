// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/exchange/sheets/picture_sheet.h"

#include <QTest>

using namespace isoscope;

namespace {

Image plain(int width, int height, float red) {
    Image image(width, height);
    for (auto& pixel : image.pixels) pixel = {red, 0, 0};
    return image;
}

float redAt(const Image& image, int x, int y) {
    return image.pixels[static_cast<std::size_t>(y * image.width + x)][0];
}

}  // namespace

class PictureSheetTest : public QObject {
    Q_OBJECT

  private slots:
    void picturesStandInRowsAndColumns() {
        PictureSheet sheet(3, 2, 40, 30);
        // Labels of one pixel a dot, and four pixels between the pictures.
        QCOMPARE(sheet.width(), 3 * 44 - 4);
        QCOMPARE(sheet.height(), 2 * (30 + 7 + 4) - 4);
        QCOMPARE(PictureSheet::pixels(3, 2, 40, 30), double(sheet.width() * sheet.height()));
        sheet.put(2, 1, plain(40, 30, 0.5f), "");
        QCOMPARE(redAt(sheet.image(), 88, 41), 0.5f);
        QCOMPARE(redAt(sheet.image(), 127, 70), 0.5f);
        QVERIFY(redAt(sheet.image(), 87, 41) < 0.1f && redAt(sheet.image(), 88, 40) < 0.1f);
        QVERIFY(redAt(sheet.image(), 100, 72) < 0.1f);
    }

    void labelsAreReadable() {
        PictureSheet sheet(1, 1, 40, 30);
        sheet.put(0, 0, {}, "1");
        // The glyph, in the middle below the picture.
        const char* const rows[] = {".#.", "##.", ".#.", ".#.", "###"};
        for (int y = 0; y < 5; ++y)
            for (int x = 0; x < 3; ++x)
                QCOMPARE(redAt(sheet.image(), 18 + x, 31 + y) > 0.5f, rows[y][x] == '#');
        // Larger pictures have larger labels.
        PictureSheet large(1, 1, 400, 300);
        QCOMPARE(large.height(), 300 + 7 * 6);
    }

    void placesKnowTheirPixels() {
        const PictureSheet sheet(3, 2, 40, 30);
        QVERIFY(sheet.placeAt(0, 0) == std::pair(0, 0));
        QVERIFY(sheet.placeAt(88, 41) == std::pair(2, 1));
        QVERIFY(sheet.placeAt(20, 33) == std::pair(0, 0));  // its label
        for (const auto& [x, y] :
             {std::pair(41, 5), std::pair(5, 38), std::pair(-1, 0), std::pair(128, 0), std::pair(0, 78)})
            QVERIFY(!sheet.placeAt(x, y));
    }

    void whatDoesNotFitIsCut() {
        PictureSheet sheet(2, 1, 20, 10);
        sheet.put(0, 0, plain(100, 100, 1), "0.123456789");
        QVERIFY(redAt(sheet.image(), 21, 5) < 0.1f);
        sheet.put(7, 0, plain(10, 10, 1), "1");
        sheet.put(-1, 0, plain(10, 10, 1), "1");
        QCOMPARE(sheet.image().pixels.size(), std::size_t(sheet.width() * sheet.height()));
    }
};

QTEST_APPLESS_MAIN(PictureSheetTest)
#include "picture_sheet_test.moc"
