// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/exchange/png.h"

#include <cmath>
#include <QFile>
#include <QTemporaryDir>
#include <QTest>

using namespace isoscope;

namespace {

Image allGreys() {
    Image image(16, 16);
    for (int i = 0; i < 256; ++i) {
        const float grey = decodeChannel(i / 255.0);
        image.pixels[static_cast<std::size_t>(i)] = {grey, decodeChannel((255 - i) / 255.0), 0.5f};
    }
    return image;
}

QByteArray bytesOf(const std::filesystem::path& path) {
    QFile file(QString::fromStdString(path.string()));
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

}  // namespace

class PngTest : public QObject {
    Q_OBJECT

  private slots:
    void encodesAsPovrayDoes() {
        // Values and bytes seen in POV-Ray's PNG files of a plain colour.
        QCOMPARE(encodePixel({0.5f, 0.2f, 0.8f}), 0xffbc7ce7u);
        QCOMPARE(encodePixel({std::nanf(""), -1.0f, 7.0f}), 0xff0000ffu);
        QCOMPARE(encodePixel({HUGE_VALF, -HUGE_VALF, 1.0f}), 0xffff00ffu);
    }

    void everyByteSurvivesTheCurve() {
        for (int i = 0; i < 256; ++i) {
            const float linear = decodeChannel(i / 255.0);
            QCOMPARE(encodePixel({linear, 0, 0}) >> 16 & 0xff, static_cast<unsigned>(i));
        }
    }

    void readsBackWhatItWrote() {
        QTemporaryDir folder;
        const std::filesystem::path file = folder.filePath("a.png").toStdString();
        const Image image = allGreys();
        QVERIFY(writePng(file, image));
        const Image back = readPng(file);
        QCOMPARE(back.width, 16);
        QCOMPARE(back.height, 16);
        for (std::size_t i = 0; i < 256; ++i)
            QCOMPARE(encodePixel(back.pixels[i]), encodePixel(image.pixels[i]));
    }

    void writesTheSameBytesEachTime() {
        QTemporaryDir folder;
        const std::filesystem::path a = folder.filePath("a.png").toStdString();
        const std::filesystem::path b = folder.filePath("b.png").toStdString();
        QVERIFY(writePng(a, allGreys()));
        QTest::qWait(1100);  // a time stamp in the file would differ by now
        QVERIFY(writePng(b, allGreys()));
        QVERIFY(!bytesOf(a).isEmpty());
        QCOMPARE(bytesOf(a), bytesOf(b));
        QVERIFY(bytesOf(a).contains("sRGB"));
    }

    void leavesNothingBehindWhenItFails() {
        QTemporaryDir folder;
        const std::filesystem::path missing = folder.filePath("no/such/folder/a.png").toStdString();
        QVERIFY(!writePng(missing, allGreys()));
        const std::filesystem::path empty = folder.filePath("empty.png").toStdString();
        QVERIFY(!writePng(empty, Image()));
        const std::filesystem::path directory = folder.path().toStdString();
        QVERIFY(!writePng(directory, allGreys()));
        QVERIFY(std::filesystem::is_empty(directory));
    }

    void aBrokenFileIsAnEmptyImage() {
        QTemporaryDir folder;
        const std::filesystem::path file = folder.filePath("a.png").toStdString();
        QVERIFY(readPng(file).pixels.empty());
        QVERIFY(writePng(file, allGreys()));
        const QByteArray whole = bytesOf(file);
        for (int length : {0, 4, 20, 60, static_cast<int>(whole.size()) / 2}) {
            QFile cut(QString::fromStdString(file.string()));
            QVERIFY(cut.open(QIODevice::WriteOnly | QIODevice::Truncate));
            cut.write(whole.left(length));
            cut.close();
            QVERIFY2(readPng(file).pixels.empty(), std::to_string(length).c_str());
        }
    }
};

QTEST_GUILESS_MAIN(PngTest)
#include "png_test.moc"
