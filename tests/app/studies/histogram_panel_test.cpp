// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/studies/histogram_panel.h"

#include <QDockWidget>
#include <QRegularExpression>

#include "app/desktop/window/docks.h"
#include "tests/app/window_driver.h"
#include "widgets/charts/chart_view.h"
#include "widgets/editor/scene_editor.h"
#include "widgets/studies/gradient_panel.h"

using namespace isoscope;
using namespace isoscope::test;

namespace {

const QString sphere = QStringLiteral(
    "#version 3.7;\ncamera { location <0, 0, -4> look_at 0 angle 40 }\nlight_source { <4, 6, -5> rgb 1 }\n"
    "isosurface {\n  function { x*x + y*y + z*z - 1 }\n  contained_by { sphere { 0, 1.2 } }\n"
    "  max_gradient 1.2\n  pigment { rgb 0.9 }\n}\n");

}  // namespace

/// The distribution of the gradient, in the real window.
class HistogramPanelTest : public QObject {
    Q_OBJECT

  private slots:
    void itIsMeasuredWhenItIsShown() {
        WindowDriver d;
        d->editor()->setSceneText(sphere);
        QVERIFY(d.rests(60000));
        QVERIFY(!d->study<GradientPanel>()->isActive());
        QVERIFY(d->study<HistogramPanel>()->chart()->chart().series.isEmpty());
        d->docks()->find("histogram")->raise();
        QVERIFY(QTest::qWaitFor(
            [&] { return d->study<GradientPanel>()->isActive() && d->study<GradientPanel>()->upToDate(); },
            60000));
        const Chart& chart = d->study<HistogramPanel>()->chart()->chart();
        QCOMPARE(chart.series.size(), 2);
        QCOMPARE(chart.series[0].shape, ChartSeries::Shape::bars);
        // Lines at the setting and at the proven bound.
        QCOMPARE(chart.marks.size(), 2);
        QCOMPARE(chart.marks[0].x, 1.2);
        QVERIFY(std::abs(chart.marks[1].x - 2.4) < 0.03);
        // What lies below the first edge is in the first bar, which says so.
        const ChartSeries& bars = chart.series[0];
        QCOMPARE(chart.notes.size(), 1);
        QCOMPARE(chart.notes[0].at.y(), bars.points[0].y());
        QVERIFY(chart.notes[0].at.x() > bars.points[0].x() && chart.notes[0].at.x() < bars.points[1].x());
        const QRegularExpression bottom(QStringLiteral("^0 to ([0-9.]+): ([0-9.]+) %$"));
        const QRegularExpressionMatch label = bottom.match(chart.notes[0].text);
        QVERIFY2(label.hasMatch(), qPrintable(chart.notes[0].text));
        QVERIFY(std::abs(label.captured(2).toDouble() - bars.points[0].y()) < 0.1);
        // It is seen in the window, too.
        ChartView* view = d->study<HistogramPanel>()->chart();
        QTRY_VERIFY(view->settled());
        const QImage labelled = view->grab().toImage();
        Chart bare = chart;
        bare.notes.clear();
        view->setChart(bare);
        QTRY_VERIFY(view->settled());
        QVERIFY(difference(labelled, view->grab().toImage()) > 0);
        // (1.2 / 2.4)^3 of the ball is less steep than 1.2.
        const QRegularExpression numbers(QStringLiteral("max_gradient: ([0-9.]+) % of the container, 100 %"));
        const QRegularExpressionMatch match = numbers.match(d->study<HistogramPanel>()->text());
        QVERIFY2(match.hasMatch(), qPrintable(d->study<HistogramPanel>()->text()));
        QVERIFY(std::abs(match.captured(1).toDouble() - 87.5) < 1.5);
        QVERIFY(QTest::qWaitFor([&] { return d->study<HistogramPanel>()->chart()->settled(); }, 10000));
        QVERIFY(distinctColors(d->study<HistogramPanel>()->chart()->grab().toImage()) > 30);
    }

    /// The chart takes the height that there is, instead of being scrolled.
    void chartsFitTheirPanes() {
        WindowDriver d;
        d->resize(1280, 800);
        d->editor()->setSceneText(sphere);
        d->docks()->find("histogram")->raise();
        QVERIFY(d.rests(60000));
        QTRY_VERIFY_WITH_TIMEOUT(!d->study<HistogramPanel>()->chart()->chart().series.isEmpty(), 60000);
        QTRY_VERIFY(d->study<HistogramPanel>()->height() <=
                    d->docks()->find("histogram")->widget()->height());
        QVERIFY(d->study<HistogramPanel>()->chart()->height() > d->study<HistogramPanel>()->height() / 2);
    }

    void theStudyPanelsAreTabbedAndRemembered() {
        WindowDriver d;
        const auto tabbed = [&] { return d->tabifiedDockWidgets(d->docks()->find("section")); };
        for (QDockWidget* dock : {d->docks()->find("gradient"), d->docks()->find("histogram"),
                                  d->docks()->find("accuracy"), d->docks()->find("ray")})
            QVERIFY(tabbed().contains(dock));
        d->docks()->find("accuracy")->close();
        d->docks()->find("ray")->setFloating(true);
        d.restart();
        QVERIFY(!d->docks()->find("accuracy")->isVisible());
        QVERIFY(d->docks()->find("ray")->isFloating());
        QVERIFY(tabbed().contains(d->docks()->find("histogram")));
    }

    void aSceneWithoutIsosurfaceEmptiesIt() {
        WindowDriver d;
        d->docks()->find("histogram")->raise();
        d->editor()->setSceneText(sphere);
        QVERIFY(d.rests(60000));
        QVERIFY(QTest::qWaitFor(
            [&] { return !d->study<HistogramPanel>()->chart()->chart().series.isEmpty(); }, 60000));
        d->editor()->setSceneText(
            QStringLiteral("#version 3.7;\ncamera { location -3*z }\nsphere { 0, 1 }\n"));
        QVERIFY(d.rests(60000));
        QVERIFY(d->study<HistogramPanel>()->chart()->chart().series.isEmpty());
        QVERIFY(!d->study<HistogramPanel>()->chart()->chart().empty.isEmpty());
        QVERIFY(d->study<HistogramPanel>()->text().isEmpty());
    }
};

QTEST_MAIN(HistogramPanelTest)
#include "histogram_panel_test.moc"
