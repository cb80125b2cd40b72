// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/language/expressions/slider_range.h"

#include <QTest>
#include <cmath>
#include <limits>

#include "core/language/parse.h"

using namespace isoscope;

class SliderRangeTest : public QObject {
    Q_OBJECT

  private slots:
    void endsInRoundNumbers_data() {
        QTest::addColumn<double>("value");
        QTest::addColumn<double>("minimum");
        QTest::addColumn<double>("maximum");
        const double huge = std::numeric_limits<double>::max();
        QTest::newRow("zero") << 0.0 << -1.0 << 1.0;
        QTest::newRow("thousandths") << 0.015 << 0.0 << 0.06;
        QTest::newRow("tenths") << 0.1 << 0.0 << 0.4;
        QTest::newRow("0.55") << 0.55 << 0.0 << 2.5;
        QTest::newRow("two") << 2.0 << 0.0 << 8.0;
        QTest::newRow("0.0023") << 0.0023 << 0.0 << 0.01;
        QTest::newRow("tens") << 10.0 << 0.0 << 40.0;
        QTest::newRow("negative") << -10.0 << -40.0 << 0.0;
        QTest::newRow("small negative") << -3e-7 << -1.5e-6 << 0.0;
        QTest::newRow("nothing to see") << 1e-300 << 0.0 << 1.0;
        QTest::newRow("huge") << huge << 0.0 << huge;
        QTest::newRow("infinite") << -std::numeric_limits<double>::infinity() << -huge << 0.0;
        QTest::newRow("no number") << std::nan("") << -1.0 << 1.0;
    }
    void endsInRoundNumbers() {
        QFETCH(double, value);
        QFETCH(double, minimum);
        QFETCH(double, maximum);
        QCOMPARE(sliderRangeAround(value).minimum, minimum);
        QCOMPARE(sliderRangeAround(value).maximum, maximum);
    }

    void holdsTheValueInEveryDecade() {
        for (int decade = -11; decade < 290; ++decade)
            for (const double digits : {1.0, 1.37, 2.5, 3.0, 7.1, 9.9}) {
                const double value = digits * std::pow(10.0, decade);
                const SliderRange range = sliderRangeAround(value);
                QVERIFY2(range.maximum >= 3.9 * value && range.maximum <= 6.1 * value,
                         qPrintable(QString::number(value)));
                QCOMPARE(symmetricRangeAround(-value).minimum, -range.maximum);
                QCOMPARE(symmetricRangeAround(-value).maximum, range.maximum);
            }
    }

    /// A bug once: every number below a quarter got a slider from 0 to 1.
    void smallDeclaredNumbersGetASmallRange() {
        const ParseResult parsed = parseScene(
            "#declare A = 0.015; isosurface { function { x } threshold 0.002 contained_by { sphere { 0, 0.05 "
            "} } }");
        const auto range = [&](const char* name) {
            for (const SceneParameter& p : parsed.scene->parameters)
                if (p.name == name) return std::pair(p.minimum, p.maximum);
            return std::pair(0.0, 0.0);
        };
        QCOMPARE(range("A"), std::pair(0.0, 0.06));
        QCOMPARE(range("threshold"), std::pair(-0.008, 0.008));
        QCOMPARE(range("radius"), std::pair(0.0, 0.2));
    }
};

QTEST_APPLESS_MAIN(SliderRangeTest)
#include "slider_range_test.moc"
