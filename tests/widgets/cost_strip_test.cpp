// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/studies/cost_strip.h"

#include <QAccessible>
#include <QApplication>
#include <QPainter>
#include <QSignalSpy>
#include <QSlider>
#include <QTest>

#include "widgets/numbers/slider_scale.h"
#include "widgets/parameters/parameter_slider.h"
#include "widgets/theme.h"

using namespace isoscope;

namespace {

CostPlot samplePlot() {
    CostPlot plot;
    plot.marks = {{1e-4, {40, 0.5}, {0, 0}},
                  {1e-3, {30, 0.5}, {0, 0}},
                  {1e-2, {20, 0.4}, {12, 0}},
                  {1e-1, {10, 0.4}, {900, 2}}};
    plot.picture = {800, 600};
    plot.counted = 4800;
    plot.knee = 1e-3;
    plot.complete = true;
    return plot;
}

struct ShownStrip {
    ShownStrip() {
        strip.setScale(SliderScale(1e-4, 1e-1, SliderScale::Kind::logarithmic), 8);
        strip.setSubject(QStringLiteral("isosurface accuracy"));
        strip.resize(317, 34);
        strip.setValue(1e-2);
        strip.show();
    }
    QImage image() { return strip.grab().toImage(); }
    int count(auto matches) {
        const QImage picture = image();
        int found = 0;
        for (int y = 0; y < picture.height(); ++y)
            for (int x = 0; x < picture.width(); ++x) found += matches(picture.pixelColor(x, y));
        return found;
    }
    CostStrip strip;
};

bool orange(const QColor& c) { return c.red() > 150 && c.green() > 60 && c.green() < 150 && c.blue() < 80; }
bool blue(const QColor& c) { return c.blue() > 140 && c.red() < 100; }

}  // namespace

class CostStripTest : public QObject {
    Q_OBJECT

  private slots:
    void initTestCase() { applyTheme(Theme::light); }

    void nothingIsDrawnThatIsNotKnown() {
        ShownStrip s;
        QCOMPARE(s.count(orange), 0);
        QCOMPARE(s.count(blue), 0);
        QVERIFY(s.strip.summary().isEmpty());
        QVERIFY(s.strip.detail(1e-2).isEmpty());
        CostPlot half = samplePlot();
        half.complete = false;
        half.knee.reset();
        half.marks.erase(half.marks.begin());
        s.strip.setPlot(half);
        QVERIFY(s.count(orange) > 20);
        // Left of the first value known there is no curve.
        const QImage picture = s.image();
        const int end = static_cast<int>(s.strip.positionOf(1e-3)) - 8;
        for (int x = 2; x < end; ++x)
            for (int y = 2; y < picture.height() - 2; ++y) QVERIFY(!orange(picture.pixelColor(x, y)));
    }

    void curvesLostPixelsAndKneeAreDrawn_data() {
        QTest::addColumn<bool>("dark");
        QTest::newRow("light") << false;
        QTest::newRow("dark") << true;
    }
    void curvesLostPixelsAndKneeAreDrawn() {
        QFETCH(const bool, dark);
        applyTheme(dark ? Theme::dark : Theme::light);
        ShownStrip s;
        s.strip.setPlot(samplePlot());
        QVERIFY(s.count(orange) > 40);
        QVERIFY(s.count(blue) > 40);
        const QImage picture = s.image();
        // Lost pixels: red under 0.1, nothing red under 0.0001.
        const auto isReddish = [](const QColor& c) {
            return c.red() > c.green() + 60 && c.red() > c.blue() + 60;
        };
        const int row = s.strip.height() - 7;
        QVERIFY(isReddish(picture.pixelColor(static_cast<int>(s.strip.positionOf(1e-1)) - 4, row)));
        QVERIFY(!isReddish(picture.pixelColor(static_cast<int>(s.strip.positionOf(1e-4)) + 10, row)));
        // The triangle of the knee has the colour of text.
        const QColor ink = s.strip.palette().color(QPalette::Text);
        const QColor at = picture.pixelColor(static_cast<int>(s.strip.positionOf(1e-3)), 3);
        QVERIFY2(std::abs(at.lightness() - ink.lightness()) < 60, qPrintable(at.name()));
        applyTheme(Theme::light);
    }

    void aClickChoosesAMeasuredValueWhereOneIsNear() {
        ShownStrip s;
        s.strip.setPlot(samplePlot());
        QSignalSpy chosen(&s.strip, &CostStrip::chosen);
        QTest::mouseClick(&s.strip, Qt::LeftButton, {},
                          QPoint(static_cast<int>(s.strip.positionOf(1e-3)) + 3, 10));
        QCOMPARE(chosen.count(), 1);
        QCOMPARE(chosen[0][0].toDouble(), 1e-3);
        const double between = std::sqrt(1e-3 * 1e-2);
        QTest::mouseClick(&s.strip, Qt::LeftButton, {},
                          QPoint(static_cast<int>(s.strip.positionOf(between)), 10));
        QCOMPARE(chosen.count(), 2);
        QVERIFY(std::abs(std::log10(chosen[1][0].toDouble() / between)) < 0.1);
    }

    void arrowKeysGoFromValueToValueAndReturnToTheKnee() {
        ShownStrip s;
        s.strip.setPlot(samplePlot());
        QSignalSpy chosen(&s.strip, &CostStrip::chosen);
        QTest::keyClick(&s.strip, Qt::Key_Left);
        QCOMPARE(chosen.takeLast()[0].toDouble(), 1e-3);
        QTest::keyClick(&s.strip, Qt::Key_Right);
        QCOMPARE(chosen.takeLast()[0].toDouble(), 1e-1);
        QTest::keyClick(&s.strip, Qt::Key_Return);
        QCOMPARE(chosen.takeLast()[0].toDouble(), 1e-3);
        s.strip.setValue(1e-4);
        QTest::keyClick(&s.strip, Qt::Key_Left);
        QVERIFY(chosen.isEmpty());
    }

    void itTellsTheTimeItsErrorAndThePixels() {
        ShownStrip s;
        s.strip.setPlot(samplePlot());
        QCOMPARE(s.strip.summary(), QStringLiteral("POV-Ray 20 s ± 50 % at 800 × 600; 12 lost"));
        s.strip.setValue(1e-3);
        QCOMPARE(s.strip.summary(), QStringLiteral("POV-Ray 30 s ± 50 % at 800 × 600; none lost"));
        const QAccessibleInterface* accessible = QAccessible::queryAccessibleInterface(&s.strip);
        QCOMPARE(accessible->text(QAccessible::Description), s.strip.summary());
        QCOMPARE(accessible->text(QAccessible::Name), QStringLiteral("What isosurface accuracy costs"));
        const QString detail = s.strip.detail(1e-2);
        for (const char* part : {"accuracy 0.01", "20 s", "0.4 s", "12", "4800", "Knee at 0.001"})
            QVERIFY2(detail.contains(QLatin1String(part)), qPrintable(detail));
        // Between two values, between their numbers.
        QVERIFY(s.strip.detail(3e-2).contains(QStringLiteral("12 to 900")));
    }

    void whatIsOldIsPaleUntilTheNewIsComplete() {
        ShownStrip s;
        s.strip.setPlot(samplePlot());
        const int strong = s.count(orange);
        s.strip.setOld();
        QVERIFY(!s.strip.fresh());
        QVERIFY(s.strip.hasOld());
        QVERIFY(s.count(orange) < strong / 3);
        QVERIFY(s.strip.summary().isEmpty());
        QVERIFY(s.strip.detail(1e-2).contains(QStringLiteral("before the last change")));
        CostPlot begun = samplePlot();
        begun.complete = false;
        s.strip.setPlot(begun);
        QVERIFY(s.strip.hasOld());
        s.strip.setPlot(samplePlot());
        QVERIFY(s.strip.fresh() && !s.strip.hasOld());
    }

    void timesAreRough() {
        QCOMPARE(roughTime(0.034), QStringLiteral("0.03 s"));
        QCOMPARE(roughTime(0.44), QStringLiteral("0.4 s"));
        QCOMPARE(roughTime(41.2), QStringLiteral("41 s"));
        QCOMPARE(roughTime(150), QStringLiteral("2.5 min"));
        QCOMPARE(roughTime(7200), QStringLiteral("2.0 h"));
    }

    void itStandsUnderTheSlidersOfTheTwoSettings() {
        SceneParameter parameter;
        parameter.role = ParameterRole::accuracy;
        parameter.name = "accuracy";
        parameter.value = 1e-3;
        parameter.minimum = 1e-6;
        parameter.maximum = 1;
        parameter.logarithmic = true;
        ParameterSlider row(parameter);
        QVERIFY(row.strip());
        row.resize(320, 120);
        row.show();
        // Its values lie under the slider's.
        const auto* slider = row.findChild<QSlider*>();
        QCOMPARE(row.strip()->mapTo(&row, QPoint()).x(), slider->mapTo(&row, QPoint()).x());
        QCOMPARE(row.strip()->width(), slider->width());
        // A click goes the slider's way, and is one change.
        CostPlot plot = samplePlot();
        row.strip()->setPlot(plot);
        QSignalSpy started(&row, &ParameterSlider::dragStarted),
            changed(&row, &ParameterSlider::valueChanged), finished(&row, &ParameterSlider::dragFinished);
        emit row.strip()->chosen(1e-2);
        QCOMPARE(row.value(), 1e-2);
        QVERIFY(QTest::qWaitFor([&] { return finished.count() == 1; }, 5000));
        QCOMPARE(started.count(), 1);
        QCOMPARE(changed.count(), 1);
        parameter.role = ParameterRole::other;
        ParameterSlider other(parameter);
        QVERIFY(!other.strip());
    }
};

QTEST_MAIN(CostStripTest)
#include "cost_strip_test.moc"
