// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/charts/chart_axis.h"

#include <cmath>
#include <QTest>

using namespace isoscope;

namespace {

QString labels(const ChartAxis& axis, int most) {
    QStringList texts;
    for (const ChartTick& tick : chartTicks(axis, most)) texts << tick.label;
    return texts.join(QLatin1Char(' '));
}

}  // namespace

class ChartAxisTest : public QObject {
    Q_OBJECT

  private slots:
    void linearTicksAreRound() {
        QCOMPARE(labels({{}, -1.05, 1.05, false, 0}, 5), QStringLiteral("-1 -0.5 0 0.5 1"));
        QCOMPARE(labels({{}, 0, 3, false, 0}, 3), QStringLiteral("0 1 2 3"));
    }

    void logarithmicTicksArePowersOfTen() {
        QCOMPARE(labels({{}, 1e-9, 1e-1, true, 0}, 20).section(QLatin1Char(' '), 0, 2),
                 QStringLiteral("1e-9 1e-8 1e-7"));
        QCOMPARE(labels({{}, 1e-9, 1e-1, true, 0}, 5), QStringLiteral("1e-9 1e-7 1e-5 0.001 0.1"));
    }

    void fewDecadesGetTwoAndFive() {
        QString all = labels({{}, 0.01, 0.1, true, 0}, 8);
        QVERIFY2(all.contains(QStringLiteral("0.02")) && all.contains(QStringLiteral("0.05")),
                 qPrintable(all));
    }

    void logarithmicAxesHaveAPlaceForZero() {
        const ChartAxis axis = axisOver({}, {0, 5, 120}, true);
        QVERIFY(axis.usable());
        QVERIFY(axis.zero > 0 && axis.zero < 5 && axis.low == axis.zero && axis.high >= 120);
        QCOMPARE(axis.place(0), std::log10(axis.zero));
        QVERIFY(labels(axis, 6).startsWith(QStringLiteral("0 ")));
        QVERIFY(std::isnan((ChartAxis{{}, 1, 10, true, 0}.place(0))));
        QVERIFY(std::isnan(axis.place(-1)));
    }

    void everythingGivesAnAxis() {
        const double inf = std::numeric_limits<double>::infinity(), nan = std::nan("");
        for (const bool logarithmic : {false, true})
            for (const std::vector<double>& values : {std::vector<double>{},
                                                      {0.0},
                                                      {0.0, 0.0},
                                                      {1.0},
                                                      {-1.0},
                                                      {nan, inf, -inf},
                                                      {1e-300, 1e300},
                                                      {3.0, 3.0}}) {
                const ChartAxis axis = axisOver({}, values, logarithmic);
                QVERIFY(axis.usable());
                for (const double value : values)
                    if (std::isfinite(value) && !(logarithmic && value < 0))
                        QVERIFY(axis.place(value) >= axis.placeLow() - 1e-6 &&
                                axis.place(value) <= axis.placeHigh() + 1e-6);
                QVERIFY(chartTicks(axis, 6).size() < 40);
            }
        QVERIFY(chartTicks({{}, 1, 1, false, 0}, 6).empty());
        QVERIFY(chartTicks({{}, nan, 1, false, 0}, 6).empty());
    }

    void placesAndValuesAreInverse() {
        const ChartAxis axis{{}, 1e-3, 1e3, true, 0};
        QVERIFY(std::abs(axis.value(axis.place(42)) - 42) < 1e-9);
    }
};

QTEST_APPLESS_MAIN(ChartAxisTest)
#include "chart_axis_test.moc"
