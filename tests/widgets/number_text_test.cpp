// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/numbers/number_text.h"

#include <cmath>
#include <limits>
#include <QRandomGenerator>
#include <QTest>

using namespace isoscope;

class NumberTextTest : public QObject {
    Q_OBJECT

  private slots:
    void writesTheShortestDecimal_data() {
        QTest::addColumn<double>("value");
        QTest::addColumn<double>("resolution");
        QTest::addColumn<QString>("text");
        QTest::newRow("rounding noise") << 0.35000000001 << 0.002 << "0.35";
        QTest::newRow("sum of tenths") << 0.1 + 0.2 << 0.001 << "0.3";
        QTest::newRow("keeps the resolution") << 0.3512 << 0.0001 << "0.3512";
        QTest::newRow("a place finer than the resolution") << 0.3512 << 0.002 << "0.351";
        QTest::newRow("whole") << 12.0 << 0.01 << "12";
        QTest::newRow("negative") << -0.25 << 0.01 << "-0.25";
        QTest::newRow("never minus zero") << -0.0001 << 0.01 << "0";
        QTest::newRow("coarse steps") << 1234.0 << 100.0 << "1200";
        QTest::newRow("small") << 1e-6 << 1e-8 << "1e-6";
        QTest::newRow("small, three digits") << 1.234567e-6 << 1e-8 << "1.23e-6";
        QTest::newRow("no exponent for thousandths") << 0.001 << 1e-5 << "0.001";
        QTest::newRow("large") << 1e9 << 1.0 << "1e9";
        QTest::newRow("thousands") << 25000.0 << 1.0 << "25000";
        QTest::newRow("not a number") << std::nan("") << 0.01 << "0";
        QTest::newRow("infinite") << std::numeric_limits<double>::infinity() << 0.01 << "0";
        QTest::newRow("no resolution") << 0.125 << 0.0 << "0.125";
    }
    void writesTheShortestDecimal() {
        QFETCH(double, value);
        QFETCH(double, resolution);
        QTEST(numberText(value, resolution), "text");
    }

    void textsReadBackAsTheSameNumber() {
        const quint32 seed = QRandomGenerator::global()->generate();
        QRandomGenerator random(seed);
        for (int i = 0; i < 20000; ++i) {
            const double value = (random.generateDouble() - 0.5) * std::pow(10.0, random.bounded(-20, 20));
            const QString text = numberText(value);
            QVERIFY2(text.toDouble() == value, qPrintable(QString("seed %1: %2").arg(seed).arg(text)));
            QVERIFY2(!text.contains('+') && !text.contains(','), qPrintable(text));
        }
    }

    void roundingMovesByHalfTheResolutionAtMost() {
        const quint32 seed = QRandomGenerator::global()->generate();
        QRandomGenerator random(seed);
        for (int i = 0; i < 20000; ++i) {
            const double resolution = std::pow(10.0, -6 + 8 * random.generateDouble());
            const double value = (random.generateDouble() - 0.5) * 2000 * resolution;
            const double rounded = roundToResolution(value, resolution);
            const double bound = resolution / 2 * (1 + 1e-9);
            QVERIFY2(
                std::abs(rounded - value) <= bound,
                qPrintable(QString("seed %1: %2 at %3").arg(seed).arg(value, 0, 'g', 17).arg(resolution)));
        }
    }
};

QTEST_APPLESS_MAIN(NumberTextTest)
#include "number_text_test.moc"
