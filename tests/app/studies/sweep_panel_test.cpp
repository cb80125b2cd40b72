// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/studies/sweep_panel.h"

#include <QAction>
#include <QComboBox>
#include <QDockWidget>
#include <QPushButton>

#include "app/desktop/window/actions.h"
#include "app/desktop/window/docks.h"
#include "tests/app/window_driver.h"
#include "widgets/charts/chart_view.h"
#include "widgets/editor/scene_editor.h"

using namespace isoscope;
using namespace isoscope::test;

namespace {

const QString torus = QStringLiteral(
    "#version 3.7;\n#include \"functions.inc\"\n#declare R = 0.4;\ncamera { location <0, 2, -4> look_at 0 "
    "angle 40 }\n"
    "light_source { <4, 6, -5> rgb 1 }\nisosurface {\n  function { f_torus(x, y, z, R, 0.2) }\n"
    "  contained_by { box { -1.5, 1.5 } }\n  max_gradient 1.2\n  pigment { rgb 0.9 }\n}\n");

SweepPanel* open(WindowDriver& d, const QString& number) {
    d->resize(1280, 800);
    d->editor()->setSceneText(torus);
    if (!d.rests(60000)) return nullptr;
    d->docks()->bringUp(d->docks()->find("sweep"));
    auto* panel = d->study<SweepPanel>();
    if (!QTest::qWaitFor([&] { return panel->numbers()->findText(number) >= 0; }, 10000)) return nullptr;
    const int index = panel->numbers()->findText(number);
    panel->numbers()->setCurrentIndex(index);
    emit panel->numbers()->activated(index);
    return QTest::qWaitFor([&] { return !panel->measuring() && panel->points().size() == 17; }, 60000)
               ? panel
               : nullptr;
}

}  // namespace

/// A number of the text, swept in the real window.
class SweepPanelTest : public QObject {
    Q_OBJECT

  private slots:
    void itMeasuresByItself() {
        WindowDriver d;
        d->editor()->setSceneText(torus);
        QVERIFY(d.rests(60000));
        auto* panel = d->study<SweepPanel>();
        QVERIFY(!panel->measuring() && panel->points().empty());
        d->docks()->bringUp(d->docks()->find("sweep"));
        // An argument comes first.
        QTRY_COMPARE(panel->numbers()->currentText(), QStringLiteral("f_torus Minor Radius"));
        QTRY_COMPARE_WITH_TIMEOUT(panel->points().size(), std::size_t(17), 60000);
        QTRY_VERIFY(panel->fresh());
        QCOMPARE(panel->costChart()->chart().series.size(), 2);
        QCOMPARE(panel->formChart()->chart().series.size(), 3);
        QCOMPARE(panel->formChart()->chart().series[1].points.back().y(), 1.0);
    }

    void aClickWritesTheValueAndKeepsTheCurve() {
        WindowDriver d;
        SweepPanel* panel = open(d, QStringLiteral("R"));
        QVERIFY(panel);
        QTRY_VERIFY(panel->costChart()->settled());
        const double low = panel->points().front().value, high = panel->points().back().value;
        QVERIFY(low < high);
        const double wanted = low + 0.75 * (high - low);
        ChartView* chart = panel->costChart();
        QTest::mouseClick(chart, Qt::LeftButton, {},
                          {qRound(chart->positionOf({wanted, 0}).x()), chart->height() / 2});
        const double written = d.numberBehind(QStringLiteral("R = "));
        QVERIFY(std::abs(written - wanted) < 0.02 * (high - low));
        QVERIFY(d.rests(60000));
        QVERIFY(panel->fresh() && !panel->measuring());
        QTRY_COMPARE(chart->chart().marks[0].x, written);
        WindowDriver::trigger(d->actions()->undo);
        QCOMPARE(d.numberBehind(QStringLiteral("R = ")), 0.4);
    }

    void anotherTextIsMeasuredAgain() {
        WindowDriver d;
        SweepPanel* panel = open(d, QStringLiteral("R"));
        QVERIFY(panel);
        const double before = panel->points().back().gradientHigh;
        QString text = torus;
        d->editor()->setSceneText(text.replace(QStringLiteral("f_torus(x,"), QStringLiteral("f_torus(3*x,")));
        QVERIFY(d.rests(60000));
        QTRY_VERIFY_WITH_TIMEOUT(panel->fresh() && !panel->measuring() && panel->points().size() == 17,
                                 60000);
        QCOMPARE(panel->numbers()->currentText(), QStringLiteral("R"));
        QVERIFY(panel->points().back().gradientHigh > 2 * before);
    }

    void aSceneWithoutIsosurfaceHasNothingToVary() {
        WindowDriver d;
        SweepPanel* panel = open(d, QStringLiteral("R"));
        QVERIFY(panel);
        d->editor()->setSceneText(
            QStringLiteral("#version 3.7;\ncamera { location -3*z }\nsphere { 0, 1 }\n"));
        QVERIFY(d.rests(60000));
        QTRY_COMPARE(panel->numbers()->count(), 0);
        QVERIFY(!panel->startButton()->isEnabled());
    }
};

QTEST_MAIN(SweepPanelTest)
#include "sweep_panel_test.moc"
