// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/studies/threshold_panel.h"

#include <QAction>
#include <QDockWidget>
#include <QPushButton>
#include <QTreeWidget>

#include "app/desktop/window/actions.h"
#include "app/desktop/window/docks.h"
#include "tests/app/window_driver.h"
#include "widgets/charts/chart_view.h"
#include "widgets/editor/scene_editor.h"
#include "widgets/viewport/viewport.h"

using namespace isoscope;
using namespace isoscope::test;

namespace {

/// Schwarz' P surface: minima -3, saddles -1 and 1, maxima 3, all inside.
const QString lattice = QStringLiteral(
    "#version 3.7;\ncamera { location <0.5, 3, -7> look_at 0.5 angle 40 }\nlight_source { <4, 6, -5> rgb 1 "
    "}\n"
    "isosurface {\n  function { cos(pi*x) + cos(pi*y) + cos(pi*z) }\n"
    "  contained_by { box { -1.4, 2.4 } }\n  threshold 0.5\n  max_gradient 6\n  pigment { rgb 0.9 }\n}\n");

ThresholdPanel* open(WindowDriver& d, const QString& text) {
    d->resize(1280, 800);
    d->editor()->setSceneText(text);
    d->docks()->find("levels")->raise();
    if (!d.rests(60000)) return nullptr;
    auto* panel = d->study<ThresholdPanel>();
    return QTest::qWaitFor([&] { return panel->survey().complete && panel->chart()->settled(); }, 60000)
               ? panel
               : nullptr;
}

}  // namespace

/// The thresholds at which a surface changes, in the real window.
class ThresholdPanelTest : public QObject {
    Q_OBJECT

  private slots:
    void itIsSearchedWhenItIsShown() {
        WindowDriver d;
        d->editor()->setSceneText(lattice);
        QVERIFY(d.rests(60000));
        auto* panel = d->study<ThresholdPanel>();
        QVERIFY(!panel->searching() && panel->survey().histogram.empty());
        QVERIFY(panel->chart()->chart().series.isEmpty());
        d->docks()->find("levels")->raise();
        QTRY_VERIFY_WITH_TIMEOUT(panel->survey().complete, 60000);
        QCOMPARE(panel->ticks().size(), std::size_t(4));
        QCOMPARE(panel->list()->topLevelItemCount(), 4);
        QCOMPARE(panel->list()->topLevelItem(1)->text(0).toDouble(), -1.0);
        QCOMPARE(panel->list()->topLevelItem(1)->text(1),
                 QStringLiteral("two pieces join or a tunnel opens (×24)"));
        QCOMPARE(panel->list()->topLevelItem(1)->text(2), QStringLiteral("proven"));
        QVERIFY(panel->text().contains(QStringLiteral("4 proven, 0 suspected")));
        const Chart& chart = panel->chart()->chart();
        QCOMPARE(chart.marks.size(), 1);
        QCOMPARE(chart.marks[0].x, 0.5);
        // Bars, ends and saddles.
        QCOMPARE(chart.series.size(), 3);
        QCOMPARE(chart.series[2].points.size(), std::size_t(4));
        QVERIFY(std::abs(chart.series[2].points[0].x() + 1) < 1e-9);
    }

    void aPressAtALineSetsTheThresholdAndUndoTakesItBack() {
        WindowDriver d;
        ThresholdPanel* panel = open(d, lattice);
        QVERIFY(panel);
        const auto at = [&](double value) { return panel->chart()->positionOf({value, 1}).toPoint(); };
        QTest::mouseClick(panel->chart(), Qt::LeftButton, {}, at(-1) + QPoint(4, 0));
        QCOMPARE(d.numberBehind(QStringLiteral("threshold ")), -1.0);
        QVERIFY(d.rests(60000));
        // What was found holds for every threshold.
        QVERIFY(panel->survey().complete && !panel->searching());
        QCOMPARE(panel->chart()->chart().marks[0].x, -1.0);
        WindowDriver::trigger(d->actions()->undo);
        QCOMPARE(d.numberBehind(QStringLiteral("threshold ")), 0.5);
    }

    void aDragIsOneStepAndRoundsBetweenTheLines() {
        WindowDriver d;
        ThresholdPanel* panel = open(d, lattice);
        QVERIFY(panel);
        ChartView* chart = panel->chart();
        const auto at = [&](double value) { return chart->positionOf({value, 1}).toPoint(); };
        QTest::mousePress(chart, Qt::LeftButton, {}, at(0.5));
        for (const double value : {0.3, 0.1, -0.2, -0.4}) {
            QTest::mouseMove(chart, at(value));
            QTRY_VERIFY(std::abs(d.numberBehind(QStringLiteral("threshold ")) - value) < 0.05);
        }
        QTest::mouseRelease(chart, Qt::LeftButton, {}, at(-0.4));
        const double reached = d.numberBehind(QStringLiteral("threshold "));
        QCOMPARE(reached, std::round(reached * 100) / 100);
        WindowDriver::trigger(d->actions()->undo);
        QCOMPARE(d.numberBehind(QStringLiteral("threshold ")), 0.5);
    }

    void theListSetsAndFlies() {
        WindowDriver d;
        ThresholdPanel* panel = open(d, lattice);
        QVERIFY(panel);
        panel->list()->setFocus();
        panel->list()->setCurrentItem(panel->list()->topLevelItem(2));
        QTest::keyClick(panel->list(), Qt::Key_Return);
        QCOMPARE(d.numberBehind(QStringLiteral("threshold ")), 1.0);
        QVERIFY(d.rests(60000));
        QCOMPARE(panel->list()->currentItem(), panel->list()->topLevelItem(2));
        const glm::dvec3 before = d->viewport()->camera().lookAt;
        auto* goThere = panel->findChildren<QPushButton*>().first();
        for (QPushButton* button : panel->findChildren<QPushButton*>())
            if (button->text() == QStringLiteral("Go There")) goThere = button;
        QTest::mouseClick(goThere, Qt::LeftButton);
        const glm::dvec3 after = d->viewport()->camera().lookAt;
        QVERIFY(after != before);
        // Of a saddle of this function each coordinate is a whole number.
        for (int k = 0; k < 3; ++k) QVERIFY(std::abs(after[k] - std::round(after[k])) < 1e-6);
    }

    /// A threshold that the text leaves out is written.
    void aThresholdThatIsLeftOutIsWritten() {
        WindowDriver d;
        QString text = lattice;
        text.remove(QStringLiteral("  threshold 0.5\n"));
        ThresholdPanel* panel = open(d, text);
        QVERIFY(panel);
        QTest::mouseClick(panel->chart(), Qt::LeftButton, {}, panel->chart()->positionOf({1, 1}).toPoint());
        QCOMPARE(d.numberBehind(QStringLiteral("threshold ")), 1.0);
    }

    void anotherFunctionIsSearchedAndNoneEmptiesIt() {
        WindowDriver d;
        ThresholdPanel* panel = open(d, lattice);
        QVERIFY(panel);
        QString text = lattice;
        d->editor()->setSceneText(text.replace(QStringLiteral("cos(pi*z)"), QStringLiteral("z*z")));
        QVERIFY(d.rests(60000));
        QTRY_VERIFY_WITH_TIMEOUT(panel->survey().complete, 60000);
        QCOMPARE(panel->ticks().size(), std::size_t(3));
        d->editor()->setSceneText(
            QStringLiteral("#version 3.7;\ncamera { location -3*z }\nsphere { 0, 1 }\n"));
        QVERIFY(d.rests(60000));
        QVERIFY(panel->ticks().empty() && panel->text().isEmpty());
        QCOMPARE(panel->list()->topLevelItemCount(), 0);
        QVERIFY(!panel->chart()->chart().empty.isEmpty());
    }
};

QTEST_MAIN(ThresholdPanelTest)
#include "threshold_panel_test.moc"
