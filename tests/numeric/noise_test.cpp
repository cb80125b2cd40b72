// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/numeric/noise.h"

#include <cmath>
#include <limits>
#include <numeric>
#include <QCryptographicHash>
#include <QTest>

#include "core/numeric/noise_lookup.h"

using namespace isoscope;

namespace {

template <typename Container>
QByteArray hashOfWords(const Container& words, std::size_t count) {
    QByteArray bytes;
    for (std::size_t i = 0; i < count; ++i) {
        bytes.append(static_cast<char>(words[i] & 255));
        bytes.append(static_cast<char>(words[i] >> 8));
    }
    return QCryptographicHash::hash(bytes, QCryptographicHash::Sha256).toHex();
}

}  // namespace

class NoiseTest : public QObject {
    Q_OBJECT

  private slots:
    void latticeHashIsTheSpecifiedTable() {
        QCOMPARE(hashOfWords(latticeHash(), 4096),
                 QByteArray("aee9eb62be424d01e9b54f4e26b2a23a51520f1c2c28b8ef7d011b417f8e014b"));
        const unsigned first[] = {2291, 2574, 3654, 1557, 1196, 3388, 2637, 1820, 2436, 762};
        for (int i = 0; i < 10; ++i) QCOMPARE(unsigned(latticeHash()[i]), first[i]);
        for (int i = 0; i < 4096; ++i) QCOMPARE(latticeHash()[4096 + i], latticeHash()[i]);
    }

    /// What cells read at the end of the table, where an index has no next one, is its beginning.
    void theLookupIsTheTableFolded() {
        const auto& hash = latticeHash();
        for (unsigned i = 0; i <= 4096; ++i) {
            QCOMPARE(latticeLookup.hash[i], hash[i]);
            QCOMPARE(latticeLookup.ground[i], hash[hash[i] ^ 10000 % 4096]);
            if (i < 4096) QCOMPARE(unsigned(latticeLookup.entry[i]), hash[i] & 255u);
        }
    }

    void latticeValuesAreTheSpecifiedFigures() {
        const auto& values = latticeValues();
        QStringList figures;
        for (const double value : values) figures << QString::number(value, 'g', 6);
        QCOMPARE(QCryptographicHash::hash(figures.join('\n').toLatin1(), QCryptographicHash::Sha256).toHex(),
                 QByteArray("bc7eaa8c9b1993bc190633893cfa7f36d3de7ceb3a59756873edd099bf92583e"));
        // The figures themselves are the values: nothing is left behind the sixth digit.
        for (std::size_t i = 0; i < values.size(); ++i)
            QVERIFY2(figures[int(i)].toDouble() == values[i], qPrintable(figures[int(i)]));
        QCOMPARE(values[5], -0.0161593);
        // The specification gives the sum to six decimals.
        QVERIFY(std::abs(std::accumulate(values.begin(), values.end(), 0.0) + 8.350448) < 5e-7);
    }

    void gradientTablesAreTheSpecifiedOnes() {
        const GradientNoiseTables& tables = gradientNoiseTables();
        QCOMPARE(hashOfWords(tables.hash, 2048),
                 QByteArray("241d7b3e4ca8cc646819959b18e08bebec97a3327d6343afd1f881cd8fc985bd"));
        QCOMPARE(tables.gradients[0][0], 0.6044250694264234);
        QCOMPARE(tables.gradients[0][1], 0.7052602895441197);
        QCOMPARE(tables.gradients[0][2], 0.3705108088045583);
        for (int i = 0; i < 2050; ++i) QCOMPARE(tables.hash[2048 + i], tables.hash[i]);
    }

    void noiseEqualsPrintedValues_data() {
        QTest::addColumn<double>("x");
        QTest::addColumn<double>("y");
        QTest::addColumn<double>("z");
        QTest::addColumn<QList<double>>("values");
        QTest::newRow("positive") << 0.1 << 0.2 << 0.3
                                  << QList<double>{0.2992429090099138, 0.4171920326566367,
                                                   0.6522608537200985};
        QTest::newRow("mixed") << -1.7 << 2.25 << 3.9
                               << QList<double>{0.24777898624789996, 0.3919821305716337, 0.4574546608039243};
        QTest::newRow("far") << 12.5 << -7.125 << 0.0625
                             << QList<double>{0.8846677301281691, 0.7039657884538729, 0.5759855454444265};
        QTest::newRow("origin") << 0.0 << 0.0 << 0.0
                                << QList<double>{0.05658049999999998, 0.2983224393079099, 0.5113543053730359};
    }
    void noiseEqualsPrintedValues() {
        QFETCH(double, x);
        QFETCH(double, y);
        QFETCH(double, z);
        QFETCH(QList<double>, values);
        // Bit for bit: QCOMPARE of doubles would be fuzzy.
        for (int generator = 1; generator <= 3; ++generator)
            QVERIFY(noise(generator, x, y, z) == values[generator - 1]);
        QVERIFY(noise(0, x, y, z) == values[0]);
    }

    void vectorNoiseEqualsDerivedValues() {
        const auto vector = vectorNoise(0.1, 0.2, 0.3);
        QVERIFY(vector[0] == -0.20075709099008618);
        QVERIFY(vector[1] == -0.1007243831741798);
        QVERIFY(vector[2] == -0.46123045849626115);
        QVERIFY(vector[0] == latticeNoise(0.1, 0.2, 0.3));
    }

    void generatorNumbersAreTruncatedModuloFour() {
        const double number[] = {
            4,      -1,           1.6,           2.7,          -0.5,         7,  -2147483648.0, 1e300,
            -1e300, std::nan(""), -2147483648.9, 2147483647.9, 2147483649.0, 3e9};
        const int wanted[] = {0, 3, 1, 2, 0, 3, 0, 0, 0, 0, 0, 3, 0, 0};
        for (int i = 0; i < 14; ++i) QCOMPARE(noiseGeneratorNumber(number[i]), wanted[i]);
    }

    void coordinatesWithoutMeaningActAsZero() {
        const double infinite = std::numeric_limits<double>::infinity();
        for (const double wild : {infinite, -infinite, std::nan(""), 2147483648.0, -2147483648.0, 1e300})
            for (int generator = 0; generator < 4; ++generator)
                QVERIFY(noise(generator, 0.3, wild, 0.7) == noise(generator, 0.3, 0, 0.7));
        QVERIFY(std::isfinite(noise(2, 2147483647.5, -2147483647.5, 0)));
    }
};

QTEST_APPLESS_MAIN(NoiseTest)
#include "noise_test.moc"
