// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/shapes/patches/height_field.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <QProcess>
#include <QStandardPaths>
#include <QTemporaryDir>
#include <QTest>

#include "core/language/parse.h"

using namespace isoscope;

namespace {

constexpr int side = 5;

/// The pixels of the test's images, 8 bits each.
int redOf(int x, int y) { return (37 * x + 91 * y + 5) % 256; }
int greenOf(int x, int y) { return (53 * x + 29 * y + 200) % 256; }
int blueOf(int x, int y) { return (11 * x + 17 * y) % 256; }

QByteArray greyImage() {
    QByteArray text = "P2 5 5 255\n";
    for (int y = 0; y < side; ++y)
        for (int x = 0; x < side; ++x) text += QByteArray::number(redOf(x, y)) + ' ';
    return text;
}

QByteArray colorImage() {
    QByteArray text = "P3 5 5 255\n";
    for (int y = 0; y < side; ++y)
        for (int x = 0; x < side; ++x)
            for (const int value : {redOf(x, y), greenOf(x, y), blueOf(x, y)})
                text += QByteArray::number(value) + ' ';
    return text;
}

QByteArray deepImage() {
    QByteArray text = "P2 5 5 65535\n";
    for (int y = 0; y < side; ++y)
        for (int x = 0; x < side; ++x) text += QByteArray::number(256 * redOf(x, y) + greenOf(x, y)) + ' ';
    return text;
}

void write(const QString& file, const QByteArray& bytes) {
    std::ofstream(file.toStdString(), std::ios::binary).write(bytes.data(), bytes.size());
}

}  // namespace

class HeightFieldTest : public QObject {
    Q_OBJECT

  private slots:
    /// Rounding may put a hit on flat ground at height 0 just below it.
    void groundAtHeightZeroIsMet() {
        HeightGrid grid;
        grid.columns = grid.rows = 2;
        grid.heights = {0, 0, 0, 0};
        const HeightField field(grid, 0, false);
        TraceContext context;
        int met = 0;
        for (int i = 0; i < 1000; ++i) {
            const Ray ray{{0.1 + 0.0003 * i, 3.1 + 0.0007 * i, 0.2}, {0.05, -1.03 - 0.001 * i, 0.1}};
            NearestHit hit;
            field.nearest({&ray, 1}, context, {&hit, 1});
            met += hit.found;
        }
        QCOMPARE(met, 1000);
    }

    /// What POV-Ray's trace() says of such images: grey values spread over 16 bits, colours as 256 red +
    /// green, palettes as 256 index; a 16-bit TIFF, of which it drops half the bits, keeps them here.
    void imagesOfAllKinds_data() {
        QTest::addColumn<QByteArray>("source");
        QTest::addColumn<QStringList>("options");
        QTest::addColumn<QString>("name");
        QTest::addColumn<int>("kind");
        const auto row = [](const char* name, const QByteArray& source, const QStringList& options,
                            int kind) { QTest::newRow(name) << source << options << QString(name) << kind; };
        row("grey.png", greyImage(), {}, 0);
        row("grey.jpg", greyImage(), {"-quality", "100"}, 3);
        row("color.jpg", colorImage(), {"-quality", "100", "-sampling-factor", "1x1"}, 4);
        row("grey.tif", greyImage(), {"-compress", "none"}, 0);
        row("packed.tif", greyImage(), {"-compress", "lzw"}, 0);
        row("color.tif", colorImage(), {"-compress", "none"}, 1);
        row("zipped.tif", colorImage(), {"-compress", "zip"}, 1);
        row("deep.tif", deepImage(), {"-compress", "none", "-depth", "16"}, 2);
        row("color.png", colorImage(), {"-define", "png:color-type=2"}, 1);
        row("color.ppm", colorImage(), {}, 1);
    }
    void imagesOfAllKinds() {
        QFETCH(QByteArray, source);
        QFETCH(QStringList, options);
        QFETCH(QString, name);
        QFETCH(int, kind);
        const QString converter = QStandardPaths::findExecutable("convert");
        if (converter.isEmpty()) QSKIP("ImageMagick's convert, which makes the images, is not installed");
        const QTemporaryDir folder;
        const QString made = folder.filePath("source.pnm"), image = folder.filePath(name);
        write(made, source);
        QCOMPARE(QProcess::execute(converter, QStringList{made} + options + QStringList{image}), 0);
        std::string problem;
        const std::optional<Raster> raster = readRaster(image.toStdString(), problem);
        QVERIFY2(raster, problem.c_str());
        const HeightGrid grid = heightGrid(*raster);
        QCOMPARE(grid.columns, side);
        QCOMPARE(grid.rows, side);
        for (int y = 0; y < side; ++y)
            for (int x = 0; x < side; ++x) {
                const int red = redOf(x, y), green = greenOf(x, y);
                const double height = 65536 * grid.at(x, side - 1 - y);
                // JPEG changes values by a few steps.
                if (kind == 0) QCOMPARE(height, 257.0 * red);
                if (kind == 1 || kind == 2) QCOMPARE(height, 256.0 * red + green);
                if (kind == 3) QVERIFY(std::abs(height - 257 * red) <= 3 * 257);
                if (kind == 4) QVERIFY(std::abs(height - 256 * red) <= 4 * 256 + 255);
            }
    }

    /// Of POV-Ray's trace(): it makes colours of the grey values of 8-bit PNG images, and of some a
    /// brightness just below them. Of other images each grey keeps its value.
    void greysOfPngImagesLoseStepsAsInPovray() {
        const QString converter = QStandardPaths::findExecutable("convert");
        if (converter.isEmpty()) QSKIP("ImageMagick's convert, which makes the images, is not installed");
        constexpr std::array greys{1, 3, 4, 5, 20, 64, 100, 120, 128, 200, 201, 254};
        constexpr std::array inPovray{1, 2, 4, 4, 19, 64, 99, 120, 128, 199, 201, 253};
        QByteArray image = "P2 " + QByteArray::number(int(greys.size())) + " 2 255\n";
        for (int row = 0; row < 2; ++row)
            for (const int grey : greys) image += QByteArray::number(grey) + ' ';
        const QTemporaryDir folder;
        write(folder.filePath("grey.pgm"), image);
        QCOMPARE(QProcess::execute(converter, {folder.filePath("grey.pgm"), folder.filePath("grey.png")}), 0);
        for (const auto& [statement, heights] :
             {std::pair{"png \"grey.png\"", inPovray}, std::pair{"pgm \"grey.pgm\"", greys}}) {
            ParseOptions options;
            options.file = folder.filePath("scene.pov").toStdString();
            const ParseResult parsed = parseScene(std::string("height_field { ") + statement + " }", options);
            QVERIFY(parsed.ok() && parsed.scene->objects.size() == 1);
            for (std::size_t i = 0; i < greys.size(); ++i) {
                const double x = static_cast<double>(i) / (greys.size() - 1);
                const Ray ray{{std::clamp(x, 1e-9, 1 - 1e-9), 2, 0.5}, {0, -1, 0}};
                TraceContext context;
                NearestHit hit;
                parsed.scene->objects[0].shape->nearest({&ray, 1}, context, {&hit, 1});
                QVERIFY(hit.found);
                const double height = 65536 * hit.hit.point.y;
                QVERIFY2(std::abs(height - 257 * heights[i]) < 1,
                         qPrintable(QString("%1: %2").arg(greys[i]).arg(height / 257)));
            }
        }
    }

    void palettesCountByIndex() {
        const QString converter = QStandardPaths::findExecutable("convert");
        if (converter.isEmpty()) QSKIP("ImageMagick's convert, which makes the images, is not installed");
        const QTemporaryDir folder;
        const QString made = folder.filePath("source.pnm");
        write(made, "P3 2 2 255 255 0 0  0 255 0  0 0 255  255 0 0\n");
        for (const char* name : {"plain.gif", "interlaced.gif", "palette.tif"}) {
            const QString image = folder.filePath(name);
            QStringList options{made, "-type", "Palette", "-compress", "none"};
            if (image.contains("gif"))
                options = {made, "-interlace", image.contains("laced") ? "GIF" : "none"};
            QCOMPARE(QProcess::execute(converter, options + QStringList{image}), 0);
            std::string problem;
            const std::optional<Raster> raster = readRaster(image.toStdString(), problem);
            QVERIFY2(raster, problem.c_str());
            QVERIFY2(raster->indexed, name);
            // Which index a colour has is the converter's choice; equal colours have equal ones.
            QCOMPARE(raster->at(0, 0), raster->at(1, 1));
            QVERIFY(raster->at(0, 0) != raster->at(1, 0) && raster->at(1, 0) != raster->at(0, 1));
            QVERIFY(std::max({raster->at(0, 0), raster->at(1, 0), raster->at(0, 1)}) <= 3);
        }
    }

    /// Cut short or with bytes changed: an answer or none, but no crash.
    void damagedImagesEndInAMessage() {
        const QString converter = QStandardPaths::findExecutable("convert");
        if (converter.isEmpty()) QSKIP("ImageMagick's convert, which makes the images, is not installed");
        const QTemporaryDir folder;
        const QString made = folder.filePath("source.pnm");
        write(made, colorImage());
        for (const char* name : {"a.gif", "a.jpg", "a.tif", "a.png", "a.tga"}) {
            const QString image = folder.filePath(name);
            QCOMPARE(QProcess::execute(converter, {made, image}), 0);
            QFile file(image);
            QVERIFY(file.open(QIODevice::ReadOnly));
            const QByteArray whole = file.readAll();
            file.close();
            std::string problem;
            for (qsizetype length = 0; length < whole.size(); length += 7) {
                write(image, whole.first(length));
                readRaster(image.toStdString(), problem);
            }
            write(image, whole.first(8));
            QVERIFY2(!readRaster(image.toStdString(), problem), name);
            for (qsizetype at = 0; at < whole.size(); at += 3) {
                QByteArray changed = whole;
                changed[at] = static_cast<char>(changed[at] ^ 0xa5);
                write(image, changed);
                const std::optional<Raster> raster = readRaster(image.toStdString(), problem);
                if (!raster) continue;
                const auto count = static_cast<std::size_t>(raster->width) *
                                   static_cast<std::size_t>(raster->height) *
                                   static_cast<std::size_t>(raster->channels);
                QCOMPARE(raster->samples.size(), count);
            }
        }
    }
};

QTEST_APPLESS_MAIN(HeightFieldTest)
#include "height_field_test.moc"
