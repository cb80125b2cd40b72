// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/exchange/png.h"

#include <cmath>
#include <QFile>
#include <QTemporaryDir>
#include <QTest>

#include "tests/support/png_channels.h"

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

    /// Bands of rows, by several threads: one picture, and the same bytes for any number of threads.
    void largePicturesAreMadeInBands() {
        QTemporaryDir folder;
        Image image(700, 1100);
        for (std::size_t i = 0; i < image.pixels.size(); ++i) {
            const auto x = static_cast<float>(i % 700), y = static_cast<float>(i / 700);
            image.pixels[i] = {x / 700, y / 1100, 0.5f + 0.5f * std::sin(x * y * 1e-3f)};
        }
        const std::string bytes = encodePng(image, 1);
        QCOMPARE(encodePng(image, 3), bytes);
        QVERIFY(QByteArray::fromStdString(bytes).count("IDAT") >= 3);
        const std::filesystem::path file = folder.filePath("a.png").toStdString();
        QVERIFY(writePng(file, image));
        const Image back = readPng(file);
        QCOMPARE(back.pixels.size(), image.pixels.size());
        for (std::size_t i = 0; i < image.pixels.size(); ++i)
            QCOMPARE(encodePixel(back.pixels[i]), encodePixel(image.pixels[i]));
    }

    /// Strips of any height: the picture, though not the bytes, of one piece.
    void stripsMakeOnePicture() {
        QTemporaryDir folder;
        const Image image = allGreys();
        std::string bytes;
        const auto take = [&bytes](std::string_view some) {
            bytes += some;
            return true;
        };
        PngStream stream({16, 16}, take);
        for (const auto& [first, rows] : {std::pair{0, 5}, {5, 1}, {6, 10}}) {
            Image strip(16, rows);
            std::copy_n(image.pixels.begin() + 16 * first, 16 * rows, strip.pixels.begin());
            QVERIFY(stream.add(strip));
        }
        QVERIFY(!stream.add(Image(16, 1)));
        QFile file(folder.filePath("strips.png"));
        QVERIFY(file.open(QIODevice::WriteOnly));
        file.write(bytes.data(), static_cast<qint64>(bytes.size()));
        file.close();
        const Image back = readPng(folder.filePath("strips.png").toStdString());
        QCOMPARE(back.pixels.size(), image.pixels.size());
        for (std::size_t i = 0; i < 256; ++i)
            QCOMPARE(encodePixel(back.pixels[i]), encodePixel(image.pixels[i]));
        QVERIFY(!PngStream({16, 16}, take).add(Image(15, 16)));
        QVERIFY(!PngStream({16, 16, 12}, take).add(Image(16, 16)));
        QVERIFY(!PngStream({16, 16}, [](std::string_view) { return false; }).add(image));
    }

    /// The rest of a picture that was cut off, in several bands.
    void blackRowsEndAPicture() {
        QTemporaryDir folder;
        const std::filesystem::path path = folder.filePath("black.png").toStdString();
        for (const bool opacity : {false, true})
            for (const int bits : {8, 16}) {
                Image image(700, 1500);
                std::fill_n(image.pixels.begin(), 700 * 100, std::array{1.0f, 0.5f, 0.2f});
                if (opacity) {
                    image.opacity.assign(image.pixels.size(), 0);
                    std::fill_n(image.opacity.begin(), 700 * 100, 1.0f);
                }
                std::string bytes;
                const auto take = [&bytes](std::string_view some) {
                    bytes += some;
                    return true;
                };
                PngStream stream({700, 1500, bits, opacity}, take);
                Image strip(700, 100);
                std::copy_n(image.pixels.begin(), strip.pixels.size(), strip.pixels.begin());
                if (opacity) strip.opacity.assign(strip.pixels.size(), 1);
                QVERIFY(stream.add(strip));
                QVERIFY(stream.addBlack(900));
                QVERIFY(stream.addBlack(500));
                QVERIFY(!stream.addBlack(1));
                QVERIFY(QByteArray::fromStdString(bytes).count("IDAT") >= 5);
                QFile file(folder.filePath("black.png"));
                QVERIFY(file.open(QIODevice::WriteOnly));
                file.write(bytes.data(), static_cast<qint64>(bytes.size()));
                file.close();
                const test::PngChannels back = test::readPngChannels(path);
                QCOMPARE(back.bits, bits);
                QCOMPARE(back.channels, opacity ? 4 : 3);
                file.setFileName(folder.filePath("whole.png"));
                QVERIFY(file.open(QIODevice::WriteOnly));
                const std::string whole = encodePng(image, 1, bits);
                file.write(whole.data(), static_cast<qint64>(whole.size()));
                file.close();
                QVERIFY(test::readPngChannels(folder.filePath("whole.png").toStdString()).samples ==
                        back.samples);
            }
        // Nothing before it, and a sink that refuses.
        QVERIFY(PngStream({16, 16}, [](std::string_view) { return true; }).addBlack(16));
        QVERIFY(!PngStream({16, 16}, [](std::string_view) { return false; }).addBlack(16));
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
