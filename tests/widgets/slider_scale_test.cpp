// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/numbers/slider_scale.h"

#include <cmath>
#include <limits>
#include <QRandomGenerator>
#include <QTest>

#include "widgets/numbers/number_text.h"

using namespace isoscope;
using Kind = SliderScale::Kind;

class SliderScaleTest : public QObject {
    Q_OBJECT

  private slots:
    void endsStandAsGiven() {
        const SliderScale scale(-0.8, 1.234, Kind::linear);
        QCOMPARE(scale.value(0), -0.8);
        QCOMPARE(scale.value(scale.steps()), 1.234);
    }

    void linearStepsAreRoundNumbers() {
        const SliderScale scale(0, 1, Kind::linear);
        QCOMPARE(numberText(scale.value(350)), QString("0.35"));
        QCOMPARE(numberText(scale.value(351)), QString("0.351"));
    }

    void logarithmicStepsKeepTheirRatio() {
        const SliderScale scale(1e-6, 1, Kind::logarithmic);
        QCOMPARE(scale.value(500), 1e-3);
        QVERIFY(std::abs(std::log10(scale.value(600)) + 2.4) < 1e-3);
        QVERIFY(numberText(scale.value(123)).size() <= 7);
    }

    void aStepIsCountedFromTheLowerEnd() {
        const SliderScale scale(0.1, 2, Kind::linear, 0.3);
        QCOMPARE(scale.steps(), 7);
        const QList<double> values{0.1, 0.4, 0.7, 1, 1.3, 1.6, 1.9, 2};
        for (int step = 0; step <= scale.steps(); ++step) {
            QCOMPARE(scale.value(step), values[step]);
            QCOMPARE(scale.step(values[step]), step);
        }
        QCOMPARE(scale.resolution(1), 0.3);
        QCOMPARE(SliderScale(0, 2, Kind::linear, 0.01).steps(), 200);
        QCOMPARE(SliderScale(0, 0.3, Kind::linear, 0.1).steps(), 3);
        // Wider, but the values are the same.
        QCOMPARE(scale.widenedTo(-0.3).minimum(), -0.5);
        QCOMPARE(scale.widenedTo(-0.3).value(2), 0.1);
    }

    void aLogarithmicScaleKeepsToItsStep() {
        const SliderScale scale(1, 100, Kind::logarithmic, 0.5);
        for (int step = 0; step <= scale.steps(); ++step)
            QCOMPARE(scale.value(step) * 2, std::round(scale.value(step) * 2));
        QCOMPARE(scale.value(500), 10.0);
    }

    void impossibleStepsAreIgnored() {
        for (const double step : {0.0, -1.0, 3.0, 1e-9, std::nan("")})
            QCOMPARE(SliderScale(0, 2, Kind::linear, step).steps(), SliderScale::fineSteps);
        QCOMPARE(SliderScale(0, 9, Kind::integral, 2).steps(), 9);
    }

    void integralStepsAreWhole() {
        const SliderScale scale(1, 15, Kind::integral);
        QCOMPARE(scale.steps(), 14);
        for (int step = 0; step <= 14; ++step) QCOMPARE(scale.value(step), step + 1.0);
        QCOMPARE(SliderScale(0.5, 2.5, Kind::integral).maximum(), 3.0);
    }

    /// The slider and the box never disagree: the value of a step belongs to that step.
    void valuesComeBackToTheirStep() {
        const quint32 seed = QRandomGenerator::global()->generate();
        QRandomGenerator random(seed);
        for (int round = 0; round < 300; ++round) {
            const Kind kind = static_cast<Kind>(round % 3);
            const double scaleFactor = std::pow(10.0, random.bounded(-6, 6));
            double low = (random.generateDouble() - 0.5) * scaleFactor;
            if (kind == Kind::logarithmic) low = std::abs(low) + 1e-9;
            const double high = low + (0.01 + random.generateDouble() * 100) * scaleFactor;
            const SliderScale scale(low, high, kind);
            for (int step = 0; step <= scale.steps(); step += 1 + scale.steps() / 200)
                QVERIFY2(
                    scale.step(scale.value(step)) == step,
                    qPrintable(QString("seed %1: %2 to %3, step %4").arg(seed).arg(low).arg(high).arg(step)));
        }
    }

    void valuesOutsideGiveTheEnds() {
        const SliderScale scale(0, 1, Kind::linear);
        QCOMPARE(scale.step(-5), 0);
        QCOMPARE(scale.step(7), scale.steps());
        QCOMPARE(scale.step(std::nan("")), 0);
        QCOMPARE(scale.widenedTo(7).maximum(), 7.0);
        QCOMPARE(scale.widenedTo(0.5).maximum(), 1.0);
        QCOMPARE(scale.widenedTo(std::nan("")).maximum(), 1.0);
    }

    void hugeNumbersAreOnTheScale() {
        for (const Kind kind : {Kind::linear, Kind::logarithmic, Kind::integral}) {
            const SliderScale scale =
                SliderScale(kind == Kind::logarithmic ? 1e-3 : 0, 4e300, kind).widenedTo(1e300);
            QVERIFY(scale.contains(1e300));
            const int step = scale.step(1e300);
            QVERIFY(step > 0 && step < scale.steps());
            QVERIFY(std::abs(scale.value(step) / 1e300 - 1) < (kind == Kind::logarithmic ? 0.8 : 0.01));
        }
    }

    void badEndsArePutRight_data() {
        QTest::addColumn<double>("low");
        QTest::addColumn<double>("high");
        const double infinity = std::numeric_limits<double>::infinity();
        QTest::newRow("equal") << 2.0 << 2.0;
        QTest::newRow("exchanged") << 3.0 << -1.0;
        QTest::newRow("infinite") << -infinity << infinity;
        QTest::newRow("not numbers") << std::nan("") << std::nan("");
        QTest::newRow("huge") << -1e300 << 1e300;
        QTest::newRow("log at zero") << 0.0 << 10.0;
    }
    void badEndsArePutRight() {
        QFETCH(double, low);
        QFETCH(double, high);
        for (const Kind kind : {Kind::linear, Kind::logarithmic, Kind::integral}) {
            const SliderScale scale(low, high, kind);
            QVERIFY(scale.minimum() < scale.maximum());
            QVERIFY(scale.steps() >= 1);
            QVERIFY(std::isfinite(scale.value(scale.steps() / 2)));
            QVERIFY(scale.resolution(0.5) > 0);
        }
    }
};

QTEST_APPLESS_MAIN(SliderScaleTest)
#include "slider_scale_test.moc"
