// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/texture/image_map.h"

#include <QTest>
#include <limits>

#include "core/texture/tables/image_table.h"

using namespace isoscope;

namespace {

/// Two by two samples: 0.1 and 0.2 above 0.3 and 0.4.
ImageMap image(ImageInterpolation interpolation = ImageInterpolation::none) {
    ImageMap map;
    map.width = map.height = 2;
    std::vector<ImageMap::Sample> samples;
    for (const float v : {0.1F, 0.2F, 0.3F, 0.4F}) samples.push_back({v, v, v, 0, 0});
    map.samples = map.stored = std::make_shared<const std::vector<ImageMap::Sample>>(samples);
    map.indices = std::make_shared<const std::vector<std::uint8_t>>(std::vector<std::uint8_t>{7, 5, 3, 1});
    map.interpolation = interpolation;
    return map;
}

double redAt(const ImageMap& map, double u, double v) { return imageColor(map, {u, v, 0}).red; }

bool near(double a, double b) { return std::abs(a - b) < 1e-6; }

}  // namespace

class ImageMapTest : public QObject {
    Q_OBJECT

  private slots:
    void samplesFillTheUnitSquareOverAndOver() {
        const ImageMap map = image();
        QVERIFY(near(redAt(map, 0.25, 0.75), 0.1));
        QVERIFY(near(redAt(map, 0.75, 0.75), 0.2));
        QVERIFY(near(redAt(map, 0.25, 0.25), 0.3));
        QVERIFY(near(redAt(map, -0.25, -3.75), 0.4));
    }

    void interpolationMeetsTheMiddlesOfSamples() {
        for (const auto kind :
             {ImageInterpolation::bilinear, ImageInterpolation::bicubic, ImageInterpolation::distance}) {
            const ImageMap map = image(kind);
            QVERIFY(near(redAt(map, 0.25, 0.75), 0.1));
            QVERIFY(near(redAt(map, 0.75, 0.25), 0.4));
            QVERIFY(near(redAt(map, 0.5, 0.5), 0.25));
        }
        QVERIFY(near(redAt(image(ImageInterpolation::bilinear), 0.375, 0.75), 0.125));
        // Squares of distances: 1/4 and 3/4 of a sample beside, 1 below.
        const double w[] = {1 / 0.0625, 1 / 0.5625, 1 / 1.0625, 1 / 1.5625};
        const double mean = (0.1 * w[0] + 0.2 * w[1] + 0.3 * w[2] + 0.4 * w[3]) / (w[0] + w[1] + w[2] + w[3]);
        QVERIFY(near(redAt(image(ImageInterpolation::distance), 0.375, 0.75), mean));
    }

    void outsideOfASingleImageItIsClear() {
        ImageMap map = image();
        map.once = true;
        QCOMPARE(imageColor(map, {1.5, 0.5, 0}).transmit, 1.0);
        QCOMPARE(storedColor(map, {1.5, 0.5, 0}).red, 0.0);
        QCOMPARE(imageIndex(map, {1.5, 0.5, 0}), 0);
        const double nan = std::numeric_limits<double>::quiet_NaN();
        QCOMPARE(imageColor(map, {nan, 0, 0}).transmit, 1.0);
        QCOMPARE(imageIndex(map, {nan, 0, 0}), 0);
    }

    void stepsGoOverTheEdges() {
        QVERIFY(near(storedColor(image(), {0.75, 0.25, 0}, 1, 1).red, 0.1));
        QVERIFY(near(storedColor(image(), {0.25, 0.75, 0}, -1, 0).red, 0.2));
    }

    void numbersAreThoseOfThePalette() {
        QCOMPARE(imageIndex(image(), {0.25, 0.75, 0}), 7);
        QCOMPARE(imageIndex(image(), {0.75, 0.25, 0}), 1);
        ImageMap plain = image();
        plain.indices = nullptr;
        QCOMPARE(imageIndex(plain, {0.25, 0.25, 0}), 77);  // of 0.3 * 255
    }

    void tablesStayWithinTheirBounds() {
        const ImageTable table(image(ImageInterpolation::bicubic), ImageChannel::storedGray);
        for (double u = 0; u < 1; u += 0.05)
            for (double v = 0; v < 1; v += 0.05) {
                const double value = table.value({u, v, 0});
                QVERIFY(table.low() <= value && value <= table.high());
            }
    }
};

QTEST_APPLESS_MAIN(ImageMapTest)
#include "image_map_test.moc"
