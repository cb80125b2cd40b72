// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/studies/ray_panel.h"

#include <QAction>
#include <QCheckBox>
#include <QDockWidget>

#include "app/desktop/window/actions.h"
#include "app/desktop/window/docks.h"
#include "tests/app/window_driver.h"
#include "widgets/charts/chart_view.h"
#include "widgets/editor/scene_editor.h"
#include "widgets/studies/ray_explanation.h"
#include "widgets/viewport/view_overlay.h"
#include "widgets/viewport/viewport.h"

using namespace isoscope;
using namespace isoscope::test;

namespace {

QString sphere(double maxGradient) {
    return QStringLiteral(
               "#version 3.7;\ncamera { location <0, 0, -4> look_at 0 angle 40 }\nlight_source { <4, 6, -5> "
               "rgb 1 }\n"
               "isosurface {\n  function { x*x + y*y + z*z - 1 }\n  contained_by { sphere { 0, 1.2 } }\n"
               "  max_gradient %1\n  pigment { rgb 0.9 }\n}\n")
        .arg(maxGradient);
}

/// Shows the text and clicks the middle of the picture with the pick tool.
bool picksMiddle(WindowDriver& d, const QString& text) {
    d->editor()->setSceneText(text);
    if (!d.rests(60000)) return false;
    d->actions()->inspectRay->setChecked(true);
    if (!d.rests(60000)) return false;
    QTest::mouseClick(d->viewport(), Qt::LeftButton, {}, d->viewport()->rect().center());
    return QTest::qWaitFor(
        [&] { return d->study<RayPanel>()->upToDate() && d->study<RayPanel>()->pixel().has_value(); }, 20000);
}

const ChartSeries* series(const RayPanel* panel, const QString& name) {
    for (const ChartSeries& one : panel->chart()->chart().series)
        if (one.name == name) return &one;
    return nullptr;
}

}  // namespace

/// The panel that explains a hole by the function along a ray, in the real window.
class RayPanelTest : public QObject {
    Q_OBJECT

  private slots:
    void aHoleIsExplained() {
        WindowDriver d;
        QVERIFY(picksMiddle(d, sphere(0.3)));
        RayPanel* panel = d->study<RayPanel>();
        QVERIFY(panel->profile().meetsContainer);
        QVERIFY(std::abs(panel->profile().near - 2.8) < 0.01 && std::abs(panel->profile().far - 5.2) < 0.01);
        const ChartSeries* wrong = series(panel, QStringLiteral("dismissed wrongly"));
        QVERIFY(wrong && wrong->points.size() == 2);
        QVERIFY(!series(panel, QStringLiteral("dismissed")));
        QVERIFY2(panel->explanation().startsWith(QStringLiteral("POV-Ray's method misses the surface at 3")),
                 qPrintable(panel->explanation()));
        QVERIFY2(panel->explanation().contains(QStringLiteral("no steeper than 0.3; there it is up to 2.4")),
                 qPrintable(panel->explanation()));
        QCOMPARE(panel->chart()->chart().marks.size(), 1);
        QVERIFY(std::abs(panel->chart()->chart().marks.first().x - 3) < 0.01);
        QVERIFY(QTest::qWaitFor([&] { return panel->chart()->settled(); }, 10000));
        QVERIFY(distinctColors(panel->chart()->grab().toImage()) > 50);
    }

    void theRightSettingDismissesRightly() {
        WindowDriver d;
        QVERIFY(picksMiddle(d, sphere(2.4)));
        RayPanel* panel = d->study<RayPanel>();
        QVERIFY(!series(panel, QStringLiteral("dismissed wrongly")));
        const ChartSeries* samples = series(panel, QStringLiteral("POV-Ray's samples"));
        QVERIFY(samples);
        QCOMPARE(samples->points.size(), panel->profile().povray.visited.size());
        QVERIFY2(panel->explanation().startsWith(QStringLiteral("POV-Ray's method finds the surface at 3")),
                 qPrintable(panel->explanation()));
        // Both marks: the surface and POV-Ray's hit.
        QCOMPARE(panel->chart()->chart().marks.size(), 2);
    }

    void conesAndEnclosuresAreSwitched() {
        WindowDriver d;
        QVERIFY(picksMiddle(d, sphere(2.4)));
        RayPanel* panel = d->study<RayPanel>();
        QCheckBox *cones = nullptr, *enclosures = nullptr;
        for (QCheckBox* box : panel->findChildren<QCheckBox*>()) (cones ? enclosures : cones) = box;
        QVERIFY(cones && enclosures);
        const auto count = [&] { return panel->chart()->chart().series.size(); };
        const auto before = count();
        QVERIFY(!series(panel, QStringLiteral("enclosure")));
        QTest::mouseClick(enclosures, Qt::LeftButton, {}, QPoint(8, enclosures->height() / 2));
        const ChartSeries* pieces = series(panel, QStringLiteral("enclosure"));
        QVERIFY(pieces);
        QCOMPARE(pieces->points.size(), 8 * panel->profile().enclosures.size());
        QTest::mouseClick(cones, Qt::LeftButton, {}, QPoint(8, cones->height() / 2));
        QCOMPARE(count(), before);
    }

    void theWheelZoomsIntoTheRay() {
        WindowDriver d;
        QVERIFY(picksMiddle(d, sphere(2.4)));
        RayPanel* panel = d->study<RayPanel>();
        ChartView* chart = panel->chart();
        QVERIFY(QTest::qWaitFor([&] { return chart->settled(); }, 10000));
        const auto width = [&] { return chart->chart().x.high - chart->chart().x.low; };
        const double whole = width();
        for (int i = 0; i < 6; ++i) d.wheel(chart, chart->rect().center(), 120);
        QVERIFY(width() < whole / 3);
        QVERIFY(chart->chart().x.low >= panel->profile().near &&
                chart->chart().x.high <= panel->profile().far);
        const double low = chart->chart().x.low;
        QTest::mousePress(chart, Qt::LeftButton, {}, chart->rect().center());
        for (int x = 0; x <= 60; x += 10) QTest::mouseMove(chart, chart->rect().center() + QPoint(x, 0));
        QTest::mouseRelease(chart, Qt::LeftButton, {}, chart->rect().center() + QPoint(60, 0));
        QVERIFY(chart->chart().x.low < low);
        for (int i = 0; i < 200; ++i) d.wheel(chart, chart->rect().center(), 120);
        QVERIFY(width() > 0 && width() < whole / 1000);
        QTest::mouseDClick(chart, Qt::LeftButton, {}, chart->rect().center());
        QTest::mouseRelease(chart, Qt::LeftButton, {}, chart->rect().center());
        QCOMPARE(width(), whole);
    }

    void theProfileFollowsSettingsAndView() {
        WindowDriver d;
        QVERIFY(picksMiddle(d, sphere(0.3)));
        RayPanel* panel = d->study<RayPanel>();
        d->editor()->setSceneText(sphere(2.4));
        QVERIFY(d.rests(60000));
        QVERIFY(QTest::qWaitFor(
            [&] { return panel->upToDate() && std::abs(panel->profile().maxGradient - 2.4) < 1e-12; },
            20000));
        const double near = panel->profile().near;
        d.wheel(d->viewport(), d->viewport()->rect().center(), 120);
        QVERIFY(d.rests(60000));
        QVERIFY(QTest::qWaitFor([&] { return panel->upToDate() && panel->profile().near < near; }, 20000));
    }

    void behindAnotherTabItComputesNothing() {
        WindowDriver d;
        QVERIFY(picksMiddle(d, sphere(0.3)));
        RayPanel* panel = d->study<RayPanel>();
        d->docks()->find("section")->raise();
        QVERIFY(d.rests(60000));
        d->editor()->setSceneText(sphere(2.4));
        QVERIFY(d.rests(60000));
        QTest::qWait(100);
        QVERIFY(!panel->upToDate());
        QVERIFY(panel->profile().maxGradient < 1);
        d->docks()->find("ray")->raise();
        QVERIFY(QTest::qWaitFor([&] { return panel->upToDate(); }, 20000));
        QCOMPARE(panel->profile().maxGradient, 2.4);
    }

    void aDragStillTurnsTheViewAndPicksNothing() {
        WindowDriver d;
        d->editor()->setSceneText(sphere(2.4));
        QVERIFY(d.rests(60000));
        d->actions()->inspectRay->setChecked(true);
        QVERIFY(d.rests(60000));
        d.dragViewport({100, 100}, {60, 30});
        QVERIFY(d->viewport()->viewMoved());
        QVERIFY(!d->study<RayPanel>()->pixel().has_value());
        // Without the tool a click picks nothing either.
        d->actions()->inspectRay->setChecked(false);
        QTest::mouseClick(d->viewport(), Qt::LeftButton, {}, {50, 50});
        QVERIFY(!d->study<RayPanel>()->pixel().has_value());
    }

    void raysPastTheContainerAndScenesWithoutIsosurfaceSaySo() {
        WindowDriver d;
        QVERIFY(picksMiddle(d, sphere(2.4)));
        RayPanel* panel = d->study<RayPanel>();
        QTest::mouseClick(d->viewport(), Qt::LeftButton, {}, {2, 2});
        QVERIFY(QTest::qWaitFor([&] { return panel->upToDate(); }, 20000));
        QVERIFY(!panel->profile().meetsContainer);
        QCOMPARE(panel->chart()->chart().empty, QStringLiteral("This ray passes the container by."));
        QVERIFY(panel->explanation().isEmpty());
        d->editor()->setSceneText(
            QStringLiteral("#version 3.7;\ncamera { location -3*z }\nsphere { 0, 1 }\n"));
        QVERIFY(d.rests(60000));
        QCOMPARE(panel->chart()->chart().empty, QStringLiteral("The scene has no isosurface."));
    }

    void aHoleOfTheMemoryAloneIsSaidToBeOne() {
        RayProfile profile;
        profile.meetsContainer = true;
        profile.accuracy = 0.001;
        profile.certifiedRoots = profile.povray.roots = {{3, RootKind::crossing}};
        QVERIFY(rayExplanation(profile, HolePixel::lost)
                    .contains(QStringLiteral("Yet its picture has a hole here")));
        QVERIFY(!rayExplanation(profile, HolePixel::right).contains(QStringLiteral("Yet")));
        QVERIFY(!rayExplanation(profile, {}).contains(QStringLiteral("Yet")));
        profile.povray.roots = {{2, RootKind::crossing}};
        QVERIFY(rayExplanation(profile, {})
                    .startsWith(QStringLiteral("POV-Ray's method hits at 2, where nothing is")));
        profile.povray.roots = {{4, RootKind::crossing}};
        QVERIFY(rayExplanation(profile, {}).contains(QStringLiteral("further back, at 4")));
        profile.certifiedRoots.clear();
        QVERIFY(rayExplanation(profile, {}).contains(QStringLiteral("where nothing is")));
        profile.povray.roots.clear();
        QVERIFY(rayExplanation(profile, {}).startsWith(QStringLiteral("Nothing is hit")));
    }
};

QTEST_MAIN(RayPanelTest)
#include "ray_panel_test.moc"
