// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/studies/accuracy_panel.h"

#include <QDockWidget>
#include <QPushButton>
#include <QSignalSpy>

#include "app/desktop/studies/study_controller.h"
#include "app/desktop/window/docks.h"
#include "app/desktop/window/rest_watch.h"
#include "core/text/csv_table.h"
#include "tests/app/window_driver.h"
#include "widgets/charts/chart_saver.h"
#include "widgets/charts/chart_view.h"
#include "widgets/editor/scene_editor.h"

using namespace isoscope;
using namespace isoscope::test;

namespace {

const QString torus = QStringLiteral(
    "#version 3.7;\n#include \"functions.inc\"\ncamera { location <0.4, 2, -4> look_at 0 angle 40 }\n"
    "light_source { <4, 6, -5> rgb 1 }\nisosurface {\n  function { f_torus(x, y, z, 0.8, 0.2) }\n"
    "  contained_by { box { -1.1, 1.1 } }\n  max_gradient 1\n  pigment { rgb 0.9 }\n}\n");

bool shows(WindowDriver& d, const QString& text) {
    d->editor()->setSceneText(text);
    d->docks()->find("accuracy")->raise();
    return d.rests(60000);
}

/// It begins by itself.
bool measured(WindowDriver& d) {
    const AccuracyPanel* panel = d->study<AccuracyPanel>();
    return QTest::qWaitFor(
        [&] { return !panel->measuring() && panel->fresh() && panel->points().size() == 18; }, 60000);
}

/// Clicks where the value of the setting lies in the chart.
void clickAt(ChartView* chart, double value) {
    const QPointF at = chart->positionOf({value, chart->chart().y.low});
    QTest::mouseClick(chart, Qt::LeftButton, {}, QPoint(qRound(at.x()), chart->height() / 2));
}

}  // namespace

/// The panel that says what accuracy costs, in the real window.
class AccuracyPanelTest : public QObject {
    Q_OBJECT

  private slots:
    void theChartGrowsWhileItIsMeasured() {
        WindowDriver d;
        QVERIFY(shows(d, torus));
        AccuracyPanel* panel = d->study<AccuracyPanel>();
        QVERIFY(QTest::qWaitFor([&] { return panel->points().size() >= 4; }, 60000));
        // Coarse first: the ends of the range, with both root finders.
        QCOMPARE(panel->points()[0].setting, 1e-1);
        QCOMPARE(panel->points()[2].setting, 1e-9);
        QVERIFY(panel->points()[0].finder != panel->points()[1].finder);
        QCOMPARE(panel->costChart()->chart().series.size(), 2);
        QVERIFY(QTest::qWaitFor([&] { return !panel->measuring(); }, 60000));
        QCOMPARE(panel->points().size(), std::size_t(18));
        QVERIFY(panel->fresh());
        // In order of the setting, whatever the order of measuring.
        const auto& points = panel->costChart()->chart().series.first().points;
        QCOMPARE(points.size(), std::size_t(9));
        for (std::size_t i = 1; i < points.size(); ++i) QVERIFY(points[i].x() > points[i - 1].x());
        // The curves are on the screen.
        QVERIFY(QTest::qWaitFor([&] { return panel->costChart()->settled(); }, 10000));
        QVERIFY(distinctColors(panel->costChart()->grab().toImage()) > 30);
        // Finer is dearer with POV-Ray's method; by its values, for seconds are the machine's, too.
        std::uint64_t fine = 0, coarse = 0;
        for (const AccuracyPoint& point : panel->points()) {
            if (point.finder != RootFinder::lipschitz) continue;
            if (point.setting == 1e-9) fine = point.evaluations;
            if (point.setting == 1e-1) coarse = point.evaluations;
        }
        QVERIFY(coarse > 0);
        QVERIFY(fine > coarse);
    }

    void aClickWritesTheValueAsOneUndoStep() {
        WindowDriver d;
        QVERIFY(shows(d, torus));
        QVERIFY(measured(d));
        AccuracyPanel* panel = d->study<AccuracyPanel>();
        QVERIFY(QTest::qWaitFor([&] { return panel->costChart()->settled(); }, 10000));
        clickAt(panel->costChart(), 1e-5);
        QVERIFY2(d->editor()->sceneText().contains(QStringLiteral("accuracy 0.00001\n")) ||
                     d->editor()->sceneText().contains(QStringLiteral("accuracy 1e-5\n")),
                 qPrintable(d->editor()->sceneText()));
        QVERIFY(d.rests(60000));
        // What was measured still holds, and the mark has moved.
        QVERIFY(panel->fresh());
        QCOMPARE(panel->costChart()->chart().marks.size(), 1);
        QCOMPARE(panel->costChart()->chart().marks.first().x, 1e-5);
        d->editor()->undo();
        QCOMPARE(d->editor()->sceneText(), torus);
    }

    void theSecondStudyIsAboutMaxGradient() {
        WindowDriver d;
        QVERIFY(shows(d, torus));
        AccuracyPanel* panel = d->study<AccuracyPanel>();
        panel->setStudied(StudiedSetting::maxGradient);
        QVERIFY(measured(d));
        QCOMPARE(panel->points().size(), std::size_t(18));
        // From a tenth of the proven bound, where pixels are lost, to ten times it, where none is.
        const ChartSeries povray = panel->lossChart()->chart().series.first();
        QVERIFY(povray.points.front().y() > 0);
        QCOMPARE(povray.points.back().y(), 0.0);
        QVERIFY(std::abs(povray.points.back().x() / povray.points.front().x() - 100) < 1e-6);
        QVERIFY(std::abs(povray.points.front().x() - 0.1) < 0.01);
        clickAt(panel->lossChart(), povray.points[4].x());
        QVERIFY2(std::abs(d.numberBehind(QStringLiteral("max_gradient")) - 1) < 0.02,
                 qPrintable(d->editor()->sceneText()));
        // The other study is kept.
        QVERIFY(d.rests(60000));
        QVERIFY(measured(d));
        panel->setStudied(StudiedSetting::accuracy);
        QVERIFY(measured(d));
        panel->setStudied(StudiedSetting::maxGradient);
        QVERIFY(!panel->measuring());
        QCOMPARE(panel->points().size(), std::size_t(18));
    }

    void anotherSceneMakesItOld() {
        WindowDriver d;
        QVERIFY(shows(d, torus));
        QVERIFY(measured(d));
        AccuracyPanel* panel = d->study<AccuracyPanel>();
        QString text = torus;
        d->editor()->setSceneText(text.replace(QStringLiteral("0.8, 0.2"), QStringLiteral("0.8, 0.25")));
        QVERIFY(QTest::qWaitFor([&] { return !panel->fresh(); }, 60000));
        QVERIFY(panel->costChart()->chart().series.first().color.alpha() < 255);
        QVERIFY(measured(d));
        d.dragViewport({100, 100}, {60, 30});
        QVERIFY(!panel->fresh());
    }

    void itCanBeStopped() {
        WindowDriver d;
        QVERIFY(shows(d, torus));
        AccuracyPanel* panel = d->study<AccuracyPanel>();
        QVERIFY(QTest::qWaitFor([&] { return panel->measuring() && !panel->points().empty(); }, 60000));
        QTest::mouseClick(panel->startButton(), Qt::LeftButton);
        QVERIFY(!panel->measuring());
        QCOMPARE(panel->startButton()->text(), QStringLiteral("Measure Again"));
        const std::size_t count = panel->points().size();
        QVERIFY(count < 18);
        // It does not begin again by itself what a person has stopped.
        QTest::qWait(800);
        QVERIFY(!panel->measuring());
        QCOMPARE(panel->points().size(), count);
        QTest::mouseClick(panel->startButton(), Qt::LeftButton);
        QVERIFY(panel->measuring());
        QVERIFY(measured(d));
    }

    void itStopsWhileSomethingMovesAndBeginsAgain() {
        WindowDriver d;
        QVERIFY(shows(d, torus));
        AccuracyPanel* panel = d->study<AccuracyPanel>();
        QVERIFY(QTest::qWaitFor([&] { return panel->measuring(); }, 60000));
        QSignalSpy moved(d->studies()->restWatch(), &RestWatch::moved);
        bool measuredWhileMoving = false;
        d.drag(d.parameter(QStringLiteral("Major Radius")), 10,
               [&] { measuredWhileMoving = panel->measuring(); });
        QVERIFY(moved.count() > 0);
        QVERIFY(!measuredWhileMoving);
        QVERIFY(measured(d));
    }

    /// A bug once: a tab that was chosen when all rested already said for ever that it is going to measure.
    void itBeginsWhenItsTabIsChosenAtRest() {
        WindowDriver d;
        QSignalSpy rested(d->studies()->restWatch(), &RestWatch::rested);
        d->editor()->setSceneText(torus);
        d->docks()->find("gradient")->raise();
        QVERIFY(d.rests(60000));
        QTRY_VERIFY(rested.count() > 0);
        QTest::qWait(200);
        QVERIFY(!d->study<AccuracyPanel>()->measuring());
        d->docks()->find("accuracy")->raise();
        QVERIFY(measured(d));
    }

    void itDoesNotWorkWhileNobodySeesIt() {
        WindowDriver d;
        d->editor()->setSceneText(torus);
        d->docks()->find("gradient")->raise();
        QVERIFY(d.rests(60000));
        QTest::qWait(800);
        QVERIFY(!d->study<AccuracyPanel>()->measuring());
        QVERIFY(d->study<AccuracyPanel>()->points().empty());
    }

    void numbersAndChartsAreSaved() {
        WindowDriver d;
        QVERIFY(shows(d, torus));
        QVERIFY(measured(d));
        QTemporaryDir folder;
        const QString table = folder.filePath(QStringLiteral("a.csv")),
                      picture = folder.filePath(QStringLiteral("a.png"));
        QVERIFY(d->study<AccuracyPanel>()->saver()->saveTo(table));
        const auto read = CsvTable::read(table.toStdString());
        QVERIFY(read);
        QCOMPARE(read->rowCount(), std::size_t(18));
        QCOMPARE(read->number(0, "accuracy", 0), 0.1);
        QCOMPARE(read->field(1, "solver"), std::string("certified"));
        QVERIFY(d->study<AccuracyPanel>()->saver()->saveTo(picture));
        QVERIFY(distinctColors(QImage(picture)) > 30);
        const QString drawing = folder.filePath(QStringLiteral("a.svg"));
        QVERIFY(d->study<AccuracyPanel>()->saver()->saveTo(drawing));
        QFile svg(drawing);
        QVERIFY(svg.open(QIODevice::ReadOnly));
        const QByteArray text = svg.readAll();
        for (const char* part : {"<svg", "CPU seconds of the picture", "Pixels missed", "POV-Ray", "exact"})
            QVERIFY2(text.contains(part), part);
        QVERIFY(!d->study<AccuracyPanel>()->saver()->saveTo(folder.filePath(QStringLiteral("no/such.csv"))));
        QVERIFY(!d->study<AccuracyPanel>()->saver()->saveTo(folder.filePath(QStringLiteral("no/such.png"))));
    }

    void withoutIsosurfaceThereIsNothingToMeasure() {
        WindowDriver d;
        QVERIFY(shows(d, QStringLiteral("#version 3.7;\ncamera { location -3*z }\nsphere { 0, 1 }\n")));
        QVERIFY(!d->study<AccuracyPanel>()->startButton()->isEnabled());
        QCOMPARE(d->study<AccuracyPanel>()->costChart()->chart().empty,
                 QStringLiteral("The scene has no isosurface to measure."));
    }
};

QTEST_MAIN(AccuracyPanelTest)
#include "accuracy_panel_test.moc"
