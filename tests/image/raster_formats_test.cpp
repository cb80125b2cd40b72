// SPDX-License-Identifier: GPL-3.0-or-later
// BMP, JPEG and TIFF images: those that other programs write are read, damaged ones are refused.
#include <sys/resource.h>

#include <cstdio>
#include <fstream>
#include <jpeglib.h>
#include <QRandomGenerator>
#include <QTemporaryDir>
#include <QTest>
#include <tiffio.h>

#include "core/image/raster_file.h"

using namespace isoscope;

namespace {

using Bytes = std::vector<std::uint8_t>;

void append(Bytes& bytes, std::uint32_t value, int count) {
    for (int k = 0; k < count; ++k, value >>= 8) bytes.push_back(static_cast<std::uint8_t>(value));
}

/// A BMP of 3 by 2 pixels with channel values 10 * (3 * row + column) + channel, rows from the top.
Bytes bmpImage(int bits, bool fromTop) {
    Bytes bytes{'B', 'M'};
    append(bytes, 0, 12);
    const std::uint32_t palette = bits == 8 ? 256 : 0;
    bytes[10] = static_cast<std::uint8_t>((54 + 4 * palette) & 0xff);
    bytes[11] = static_cast<std::uint8_t>((54 + 4 * palette) >> 8);
    for (const std::uint32_t word : {40u, 3u, fromTop ? 0xfffffffeu : 2u}) append(bytes, word, 4);
    append(bytes, 1, 2);
    append(bytes, static_cast<std::uint32_t>(bits), 2);
    for (int k = 0; k < 6; ++k) append(bytes, 0, 4);
    for (std::uint32_t k = 0; k < palette; ++k) append(bytes, k * 0x010101u, 4);
    for (int stored = 0; stored < 2; ++stored) {
        const int row = fromTop ? stored : 1 - stored;
        const std::size_t start = bytes.size();
        for (int column = 0; column < 3; ++column)
            for (int k = 0; k < bits / 8; ++k)
                bytes.push_back(static_cast<std::uint8_t>(10 * (3 * row + column) + (bits == 8 ? 0 : 2 - k)));
        while ((bytes.size() - start) % 4 != 0) bytes.push_back(0);
    }
    return bytes;
}

/// A BMP of 6 by 2 pixels that is run-length coded, with 16 colours: `data` behind the palette.
Bytes packedBmp(int bits, const Bytes& data) {
    Bytes bytes{'B', 'M'};
    append(bytes, 0, 8);
    append(bytes, 54 + 4 * 16, 4);
    for (const std::uint32_t word : {40u, 6u, 2u}) append(bytes, word, 4);
    append(bytes, 1, 2);
    append(bytes, static_cast<std::uint32_t>(bits), 2);
    append(bytes, bits == 8 ? 1 : 2, 4);
    for (const std::uint32_t word : {0u, 0u, 0u, 16u, 0u}) append(bytes, word, 4);
    for (std::uint32_t k = 0; k < 16; ++k) append(bytes, k * 0x10203u, 4);
    bytes.insert(bytes.end(), data.begin(), data.end());
    return bytes;
}

/// A run of 2, four pixels one by one; then one pixel passed over, a run of 5.
const Bytes runsOfBytes{2, 7, 0, 4, 1, 2, 3, 4, 0, 0, 0, 2, 1, 0, 5, 9, 0, 1};
const Bytes runsOfHalves{2, 0x77, 0, 4, 0x12, 0x34, 0, 0, 0, 2, 1, 0, 5, 0x9a, 0, 1};

Bytes jpegImage(int width, int height, int components) {
    jpeg_compress_struct encoder{};
    jpeg_error_mgr errors{};
    encoder.err = jpeg_std_error(&errors);
    jpeg_create_compress(&encoder);
    unsigned char* memory = nullptr;
    unsigned long size = 0;
    jpeg_mem_dest(&encoder, &memory, &size);
    encoder.image_width = static_cast<JDIMENSION>(width);
    encoder.image_height = static_cast<JDIMENSION>(height);
    encoder.input_components = components;
    encoder.in_color_space = components == 1 ? JCS_GRAYSCALE : JCS_RGB;
    jpeg_set_defaults(&encoder);
    jpeg_set_quality(&encoder, 100, TRUE);
    jpeg_start_compress(&encoder, TRUE);
    for (int row = 0; row < height; ++row) {
        std::vector<JSAMPLE> line(static_cast<std::size_t>(width * components),
                                  static_cast<JSAMPLE>(4 * row));
        JSAMPROW start = line.data();
        jpeg_write_scanlines(&encoder, &start, 1);
    }
    jpeg_finish_compress(&encoder);
    Bytes bytes(memory, memory + size);
    jpeg_destroy_compress(&encoder);
    free(memory);
    return bytes;
}

Bytes contents(const std::string& file) {
    std::ifstream input(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(input), {}};
}

Bytes tiffImage(const QTemporaryDir& folder, int bits, int samples) {
    const std::string file = folder.filePath("image.tif").toStdString();
    TIFF* image = TIFFOpen(file.c_str(), "w");
    TIFFSetField(image, TIFFTAG_IMAGEWIDTH, 5);
    TIFFSetField(image, TIFFTAG_IMAGELENGTH, 4);
    TIFFSetField(image, TIFFTAG_BITSPERSAMPLE, bits);
    TIFFSetField(image, TIFFTAG_SAMPLESPERPIXEL, samples);
    TIFFSetField(image, TIFFTAG_PHOTOMETRIC, samples == 1 ? PHOTOMETRIC_MINISBLACK : PHOTOMETRIC_RGB);
    TIFFSetField(image, TIFFTAG_PLANARCONFIG, PLANARCONFIG_CONTIG);
    TIFFSetField(image, TIFFTAG_ROWSPERSTRIP, 4);
    TIFFSetField(image, TIFFTAG_COMPRESSION, COMPRESSION_LZW);
    for (std::uint32_t row = 0; row < 4; ++row) {
        std::vector<std::uint16_t> wide;
        std::vector<std::uint8_t> narrow;
        for (int k = 0; k < 5 * samples; ++k) {
            wide.push_back(static_cast<std::uint16_t>(1000 * row + k));
            narrow.push_back(static_cast<std::uint8_t>(50 * row + static_cast<std::uint32_t>(k)));
        }
        TIFFWriteScanline(image, bits == 16 ? static_cast<void*>(wide.data()) : narrow.data(), row, 0);
    }
    TIFFClose(image);
    return contents(file);
}

}  // namespace

class RasterFormatsTest : public QObject {
    Q_OBJECT

  private slots:
    void bmpOfEveryDepth() {
        for (const int bits : {8, 24, 32})
            for (const bool fromTop : {false, true}) {
                const auto raster = decodeBmp(bmpImage(bits, fromTop));
                QVERIFY(raster && raster->width == 3 && raster->height == 2);
                QCOMPARE(raster->channels, bits == 8 ? 1 : 3);
                QCOMPARE(raster->indexed, bits == 8);
                for (int row = 0; row < 2; ++row)
                    for (int column = 0; column < 3; ++column)
                        for (int channel = 0; channel < raster->channels; ++channel)
                            QCOMPARE(int(raster->at(column, row, channel)),
                                     10 * (3 * row + column) + channel);
            }
    }

    void bmpOfRuns() {
        for (const int bits : {4, 8}) {
            const Bytes& data = bits == 8 ? runsOfBytes : runsOfHalves;
            const auto raster = decodeBmp(packedBmp(bits, data));
            QVERIFY(raster && raster->width == 6 && raster->height == 2 && raster->indexed);
            QVERIFY((raster->palette.at(3) == std::array<std::uint8_t, 4>{3, 6, 9, 255}));
            const std::uint16_t other = bits == 8 ? 9 : 10;
            const std::vector<std::uint16_t> right{0, 9, other, 9, other, 9, 7, 7, 1, 2, 3, 4};
            QCOMPARE(raster->samples, right);
            // Beyond the side, beyond the last row, and without an end.
            QVERIFY(!decodeBmp(packedBmp(bits, {7, 1, 0, 1})));
            QVERIFY(!decodeBmp(packedBmp(bits, {0, 0, 0, 0, 1, 1, 0, 1})));
            QVERIFY(!decodeBmp(packedBmp(bits, {0, 2, 0, 3, 0, 1})));
            QVERIFY(!decodeBmp(packedBmp(bits, {6, 1})));
        }
    }

    void jpegGreyAndColoured() {
        for (const int components : {1, 3}) {
            const auto raster = decodeJpeg(jpegImage(16, 40, components));
            QVERIFY(raster && raster->width == 16 && raster->height == 40 && raster->channels == components);
            // The format loses a little.
            for (int row = 0; row < 40; ++row) QVERIFY(std::abs(int(raster->at(7, row)) - 4 * row) <= 3);
        }
    }

    void tiffGreyAndColoured() {
        const QTemporaryDir folder;
        const auto narrow = decodeTiff(tiffImage(folder, 8, 1)), wide = decodeTiff(tiffImage(folder, 16, 1)),
                   colored = decodeTiff(tiffImage(folder, 8, 3));
        QVERIFY(narrow && wide && colored);
        QVERIFY(narrow->largest == 255 && wide->largest == 65535 && colored->channels == 3);
        for (int row = 0; row < 4; ++row)
            for (int x = 0; x < 5; ++x) {
                QCOMPARE(int(narrow->at(x, row)), 50 * row + x);
                QCOMPARE(int(wide->at(x, row)), 1000 * row + x);
                for (int channel = 0; channel < 3; ++channel)
                    QCOMPARE(int(colored->at(x, row, channel)), 50 * row + 3 * x + channel);
            }
    }

    void formatIsKnownByItsFirstBytes() {
        const QTemporaryDir folder;
        const std::string file = folder.filePath("image.any").toStdString();
        const auto written = [&](const Bytes& bytes) {
            std::ofstream(file, std::ios::binary)
                .write(reinterpret_cast<const char*>(bytes.data()),
                       static_cast<std::streamsize>(bytes.size()));
            return rasterFormat(file);
        };
        QVERIFY(written(bmpImage(24, false)) == RasterFormat::bmp);
        QVERIFY(written(jpegImage(8, 8, 1)) == RasterFormat::jpeg);
        QVERIFY(written(tiffImage(folder, 8, 1)) == RasterFormat::tiff);
    }

    /// A GIF of 83 bytes that says it has 114 million pixels took 230 MB and half a second with a sanitizer:
    /// found by make fuzz.
    void shortFilesOfManyPixelsTakeNoMemory() {
        const auto peak = [] {
            rusage usage{};
            getrusage(RUSAGE_SELF, &usage);
            return usage.ru_maxrss / 1024;
        };
        const long before = peak();
        using namespace std::string_literals;
        const std::string gif =
            "GIF89a\1\0\1\0\x80\0\0\0\0\0\xfa\xff\xff,\0\0\0\0\0\x32\0\x23\0\2\2\x44\1\0;"s;
        QVERIFY(!decodeGif(std::span(reinterpret_cast<const std::uint8_t*>(gif.data()), gif.size())));
        QVERIFY2(peak() - before < 50, QByteArray::number(qlonglong(peak() - before)) + " MB");
    }

    /// What has more pixels than are read was called damaged.
    void aPictureThatIsTooLargeIsNotCalledDamagedAlone() {
        const QTemporaryDir folder;
        const std::string file = folder.filePath("large.pgm").toStdString();
        std::ofstream(file) << "P5 12000 12000 255\n";
        std::string problem;
        QVERIFY(!readRaster(file, problem));
        QVERIFY2(problem.find("too large") != std::string::npos, problem.c_str());
    }

    /// Whatever is cut off or changed: an image or none, never a crash. (A JPEG may end early and be filled
    /// up.)
    void damageIsHarmless() {
        const quint32 seed = QRandomGenerator::global()->generate();
        qInfo("seed %u", seed);
        QRandomGenerator random(seed);
        const QTemporaryDir folder;
        for (const Bytes& whole :
             {bmpImage(8, false), bmpImage(24, true), packedBmp(8, runsOfBytes), packedBmp(4, runsOfHalves),
              jpegImage(16, 16, 3), tiffImage(folder, 16, 1), tiffImage(folder, 8, 3)})
            for (int round = 0; round < 400; ++round) {
                Bytes bytes = whole;
                if (random.bounded(2)) bytes.resize(random.bounded(quint32(bytes.size())));
                for (int k = 0; k < 3 && !bytes.empty(); ++k)
                    bytes[random.bounded(quint32(bytes.size()))] =
                        static_cast<std::uint8_t>(random.generate());
                for (const auto decode : {decodeBmp, decodeJpeg, decodeTiff})
                    if (const auto raster = decode(bytes))
                        QVERIFY(raster->samples.size() >= static_cast<std::size_t>(raster->width) *
                                                              static_cast<std::size_t>(raster->height));
            }
    }
};

QTEST_APPLESS_MAIN(RasterFormatsTest)
#include "raster_formats_test.moc"
