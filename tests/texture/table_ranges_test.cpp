// SPDX-License-Identifier: GPL-3.0-or-later
// Bounds of images and densities over boxes: they hold every value, and get narrow with the box.
#include <functional>
#include <QTest>
#include <random>

#include "core/texture/tables/density_table.h"
#include "core/texture/tables/image_table.h"
#include "tests/support/test_setting.h"

using namespace isoscope;

namespace {

const std::uint64_t seed = test::seedSetting(51109);

class Random {
  public:
    double between(double low, double high) {
        return std::uniform_real_distribution<double>(low, high)(engine_);
    }
    int below(int count) { return static_cast<int>(between(0, count)); }
    bool chance(double part) { return between(0, 1) < part; }

  private:
    std::mt19937_64 engine_{seed};
};

ImageMap randomImage(Random& random, ImageInterpolation interpolation) {
    ImageMap map;
    map.width = 1 + random.below(40);
    map.height = 1 + random.below(9);
    std::vector<ImageMap::Sample> samples;
    std::vector<std::uint8_t> indices;
    for (int i = 0; i < map.width * map.height; ++i) {
        ImageMap::Sample sample;
        for (float& part : sample) part = static_cast<float>(random.between(0, 1));
        samples.push_back(sample);
        indices.push_back(static_cast<std::uint8_t>(random.below(256)));
    }
    map.samples = map.stored = std::make_shared<const std::vector<ImageMap::Sample>>(samples);
    map.indices = std::make_shared<const std::vector<std::uint8_t>>(indices);
    map.interpolation = interpolation;
    map.once = random.chance(0.5);
    return map;
}

std::shared_ptr<const DensityVolume> randomVolume(Random& random) {
    auto volume = std::make_shared<DensityVolume>();
    std::size_t count = 1;
    for (int& size : volume->size) {
        size = 1 + random.below(9);
        count *= static_cast<std::size_t>(size);
    }
    for (std::size_t i = 0; i < count; ++i)
        volume->samples.push_back(static_cast<float>(random.between(0, 1)));
    return volume;
}

/// Fails the test where a value leaves its bounds.
void holdsItsValues(const PointTable& table, Random& random) {
    for (int round = 0; round < 60; ++round) {
        const double size = std::pow(10, random.between(-6, 0.7));
        std::array<Interval, 3> box;
        for (Interval& side : box) {
            double low = random.chance(0.2) ? random.below(3) - 1 : random.between(-1.3, 1.6);
            if (random.chance(0.05)) low *= std::pow(10, random.between(3, 17));
            side = {low, low + (random.chance(0.1) ? 0 : size * random.between(0, 1)), false};
        }
        const Interval range = table.range(box);
        QVERIFY(range.isDefined());
        for (int sample = 0; sample < 12; ++sample) {
            std::array<double, 3> at;
            for (std::size_t k = 0; k < 3; ++k)
                at[k] = sample == 0   ? box[k].low
                        : sample == 1 ? box[k].high
                                      : random.between(box[k].low, box[k].high);
            const double value = table.value(at);
            QVERIFY2(
                range.holds(value),
                qPrintable(QStringLiteral("%1 beside %2 to %3").arg(value).arg(range.low).arg(range.high)));
        }
    }
}

/// Fails the test where a value is further from its chord than is told. Returns how many ways were straight.
int keepsToItsChords(const PointTable& table, Random& random) {
    int straight = 0;
    for (int round = 0; round < 30; ++round) {
        const double size = std::pow(10, random.between(-6, 0));
        std::array<Interval, 3> box;
        std::array<double, 3> center, slope, errors;
        for (std::size_t k = 0; k < 3; ++k) {
            center[k] = random.between(-0.2, 1.2);
            slope[k] = random.between(-size, size);
            errors[k] = random.chance(0.5) ? 0 : random.between(0, 0.3 * size);
            const double reach = (std::abs(slope[k]) + errors[k]) * (1 + 1e-12) + 1e-15;
            box[k] = {center[k] - reach, center[k] + reach, false};
        }
        const auto valueAt = [&](double s, bool moved) {
            std::array<double, 3> at;
            for (std::size_t k = 0; k < 3; ++k)
                at[k] = center[k] + s * slope[k] + (moved ? random.between(-1, 1) * errors[k] : 0);
            return table.value(at);
        };
        const auto [bend, spread] = table.straightness(box, slope, errors);
        if (!std::isfinite(bend)) continue;
        straight += bend < 0.01;
        const double first = valueAt(-1, false), last = valueAt(1, false);
        for (int sample = 0; sample < 12; ++sample) {
            const double s = random.between(-1, 1), chord = (first + last) / 2 + (last - first) / 2 * s;
            const double exact = std::abs(valueAt(s, false) - chord),
                         off = std::abs(valueAt(s, true) - chord);
            const bool holds = exact <= bend && off <= bend + spread;
            const QString told =
                QStringLiteral("%1 and %2, told %3 and %4").arg(exact).arg(off).arg(bend).arg(spread);
            if (!QTest::qVerify(holds, "straightness", qPrintable(told), __FILE__, __LINE__)) return 0;
        }
    }
    return straight;
}

}  // namespace

class TableRangesTest : public QObject {
    Q_OBJECT

  private slots:
    void initTestCase() { qInfo("seed %llu", static_cast<unsigned long long>(seed)); }

    void imagesHoldTheirValues_data() {
        QTest::addColumn<int>("interpolation");
        QTest::newRow("none") << static_cast<int>(ImageInterpolation::none);
        QTest::newRow("bilinear") << static_cast<int>(ImageInterpolation::bilinear);
        QTest::newRow("bicubic") << static_cast<int>(ImageInterpolation::bicubic);
        // Nothing is told of parts of space; what is told has to hold all the same.
        QTest::newRow("distance") << static_cast<int>(ImageInterpolation::distance);
    }
    void imagesHoldTheirValues() {
        QFETCH(int, interpolation);
        Random random;
        for (int round = 0; round < 400; ++round) {
            const auto image = randomImage(random, static_cast<ImageInterpolation>(interpolation));
            const auto channel =
                static_cast<ImageChannel>(random.below(static_cast<int>(ImageChannel::index) + 1));
            const bool moves = random.chance(0.3);
            const ImageTable table(image, channel, moves ? 1 : 0, moves ? 2 : 0);
            const bool weighed = image.interpolation == ImageInterpolation::distance;
            QCOMPARE(table.hasRanges(), !weighed || channel == ImageChannel::index);
            holdsItsValues(table, random);
            if (QTest::currentTestFailed()) return;
        }
    }

    void densitiesHoldTheirValues() {
        Random random;
        for (int round = 0; round < 600; ++round) {
            const DensityTable table(randomVolume(random),
                                     static_cast<DensityTable::Interpolation>(round % 3));
            QVERIFY(table.hasRanges());
            holdsItsValues(table, random);
            if (QTest::currentTestFailed()) return;
        }
    }

    /// Of a box of 1e-5 in grids of fewer than 40 samples a side: what is joined is as narrow, and what is
    /// not is one sample nearly everywhere.
    void narrowBoxesHaveNarrowBounds() {
        Random random;
        constexpr double side = 1e-5;
        int narrow = 0, all = 0;
        for (int round = 0; round < 900; ++round) {
            std::shared_ptr<const PointTable> table;
            constexpr ImageInterpolation kinds[] = {ImageInterpolation::none, ImageInterpolation::bilinear,
                                                    ImageInterpolation::bicubic};
            if (round % 2)
                table = std::make_shared<const ImageTable>(randomImage(random, kinds[round % 3]),
                                                           ImageChannel::storedGray);
            else
                table = std::make_shared<const DensityTable>(
                    randomVolume(random), static_cast<DensityTable::Interpolation>(round % 3));
            std::array<Interval, 3> box;
            for (Interval& interval : box) {
                const double low = random.between(0.05, 0.95);
                interval = {low, low + side, false};
            }
            ++all;
            narrow += table->range(box).width() < 200 * side;
        }
        QVERIFY2(narrow > 0.99 * all, qPrintable(QString::number(narrow)));
    }

    void chordsAreAsStraightAsTold() {
        Random random;
        int straight = 0;
        for (int round = 0; round < 600; ++round) {
            constexpr ImageInterpolation kinds[] = {ImageInterpolation::bilinear,
                                                    ImageInterpolation::bicubic};
            straight += keepsToItsChords(
                ImageTable(randomImage(random, kinds[round % 2]),
                           round % 5 ? ImageChannel::storedGray : ImageChannel::patternGray, round % 3),
                random);
            straight += keepsToItsChords(
                DensityTable(randomVolume(random), static_cast<DensityTable::Interpolation>(1 + round % 2)),
                random);
            if (QTest::currentTestFailed()) return;
        }
        QVERIFY2(straight > 5000, qPrintable(QString::number(straight)));
    }

    void whatHasNoRangesIsTold() {
        Random random;
        const auto image = randomImage(random, ImageInterpolation::distance);
        const ImageTable red(image, ImageChannel::red);
        QVERIFY(!red.hasRanges());
        // Numbers of a palette are never interpolated.
        QVERIFY(ImageTable(image, ImageChannel::index).hasRanges());
        const std::array<Interval, 3> nowhere{Interval::unknown(), Interval::point(0), Interval::point(0)};
        QCOMPARE(red.range(nowhere), (Interval{0, 1, false}));
    }
};

QTEST_APPLESS_MAIN(TableRangesTest)
#include "table_ranges_test.moc"
