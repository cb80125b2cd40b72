// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/linked_probe.h"

#include <cmath>
#include <glm/geometric.hpp>
#include <QAction>
#include <QDockWidget>
#include <QLabel>
#include <QSignalSpy>

#include "app/desktop/studies/study_controller.h"
#include "app/desktop/window/actions.h"
#include "app/desktop/window/docks.h"
#include "tests/app/window_driver.h"
#include "widgets/charts/chart_view.h"
#include "widgets/editor/scene_editor.h"
#include "widgets/section/section_panel.h"
#include "widgets/section/section_profile.h"
#include "widgets/section/section_view.h"
#include "widgets/studies/gradient_panel.h"
#include "widgets/studies/histogram_panel.h"
#include "widgets/studies/ray_panel.h"
#include "widgets/studies/threshold_panel.h"
#include "widgets/viewport/viewport.h"

using namespace isoscope;
using namespace isoscope::test;

namespace {

/// A ball of radius 1 about <0.2, 0, 0>, in its own coordinates about the origin.
const QString ball = QStringLiteral(
    "#version 3.7;\ncamera { location <0, 0, -4> look_at 0 angle 40 }\nlight_source { <4, 6, -5> rgb 1 }\n"
    "isosurface {\n  function { x*x + y*y + z*z }\n  threshold 1\n  contained_by { sphere { 0, 1.3 } }\n"
    "  max_gradient 2.6\n  translate 0.2*x\n  pigment { rgb 0.9 }\n}\n");
/// What stands for a chart without a line.
constexpr double nothing = -1e300;

/// The window with the ball, every panel of which has been seen once, and the ray of the middle chosen.
class ProbedWindow : public WindowDriver {
  public:
    bool begins() {
        MainWindow& window = this->window();
        window.resize(1400, 900);
        window.editor()->setSceneText(ball);
        if (!rests(60000)) return false;
        window.actions()->inspectRay->setChecked(true);
        QTest::mouseClick(window.viewport(), Qt::LeftButton, {}, window.viewport()->rect().center());
        for (const char* dock : {"gradient", "histogram", "levels", "ray", "section"}) {
            window.docks()->find(dock)->raise();
            if (!rests(60000)) return false;
        }
        auto* levels = window.study<ThresholdPanel>();
        window.docks()->find("levels")->raise();
        if (!QTest::qWaitFor([&] { return levels->survey().complete; }, 60000)) return false;
        window.docks()->find("section")->raise();
        return rests(60000) && window.study<RayPanel>()->profile().meetsContainer;
    }

    LinkedProbe* probe() const { return window().studies()->probe(); }
    bool knows() const {
        return QTest::qWaitFor([&] { return probe()->upToDate() && probe()->point().has_value(); }, 20000);
    }
    static double of(const ChartView* chart) { return chart->cursorLine().value_or(nothing); }
    double onRay() const { return of(window().study<RayPanel>()->chart()); }
    double onLevels() const { return of(window().study<ThresholdPanel>()->chart()); }
    double onHistogram() const { return of(window().study<HistogramPanel>()->chart()); }
    /// All but the panel that the point comes from show `point`.
    QString disagreement() const {
        const ProbedPoint& p = *probe()->point();
        const MainWindow& w = window();
        if (std::abs(onLevels() - p.value) > 1e-12) return QStringLiteral("levels");
        if (std::abs(onHistogram() - p.slope) > 1e-12) return QStringLiteral("histogram");
        const QPointF pixel = *w.study<RayPanel>()->pixel();
        const Ray ray = fittedCamera(w.viewport()->camera(), w.viewport()->width(), w.viewport()->height())
                            .ray(pixel.x() - 0.5, 0.5 - pixel.y());
        const RayProfile& profile = w.study<RayPanel>()->profile();
        const double nearest = std::clamp(nearestOnRay(ray, p.inScene), profile.near, profile.far);
        if (std::abs(onRay() - nearest) > 1e-9) return QStringLiteral("ray");
        const QString share = QString::number(100 * p.slope / 2.6, 'g', p.slope < 2.6 ? 2 : 3);
        if (!w.study<GradientPanel>()->probeText().endsWith(share + QStringLiteral(" % of max_gradient")))
            return w.study<GradientPanel>()->probeText();
        const QString status = w.probed()->text();
        if (!status.contains(QStringLiteral("f %1,").arg(QString::number(p.value, 'g', 5))) ||
            !status.contains(QStringLiteral("|∇f| %1").arg(QString::number(p.slope, 'g', 5))) ||
            !status.startsWith(QStringLiteral("x ")))
            return status;
        return {};
    }
};

}  // namespace

/// One point, hovered anywhere and seen everywhere, in the real window.
class LinkedProbeTest : public QObject {
    Q_OBJECT

  private slots:
    void aPointOfThePictureIsSeenEverywhere() {
        ProbedWindow d;
        QVERIFY(d.begins());
        const QPoint at = d->viewport()->rect().center() + QPoint(20, -15);
        QTest::mouseMove(d->viewport(), at);
        QVERIFY(d.knows());
        const ProbedPoint point = *d.probe()->point();
        QVERIFY2(std::abs(point.value - 1) < 1e-6 && std::abs(point.slope - 2) < 1e-6, "on the surface");
        const auto pixel = d->viewport()->projection().pixelOf(point.inScene);
        QVERIFY(pixel && (*pixel - QPointF(at)).manhattanLength() < 0.01);
        QVERIFY(glm::distance(point.inScene, point.place + glm::dvec3(0.2, 0, 0)) < 1e-12);
        QCOMPARE(d.disagreement(), QString());
        const SectionView* section = d->study<SectionPanel>()->view();
        const glm::dvec2 foot = section->field().plane.footOf(point.place);
        QVERIFY(section->probePixel().has_value());
        QVERIFY(glm::distance(foot, glm::dvec2(point.place.x, point.place.y)) < 1e-12);
        // The mouse itself marks the point here.
        QVERIFY(!d->viewport()->probeMark().point());
        QTest::mouseMove(d->viewport(), QPoint(4, 4));
        QTRY_VERIFY(d.probe()->upToDate() && !d.probe()->point());
        QVERIFY(d.onRay() == nothing && d.onLevels() == nothing && d.onHistogram() == nothing);
        QVERIFY(!section->probePixel() && d->probed()->text().isEmpty());
    }

    void aPointOfTheSectionIsSeenEverywhere() {
        ProbedWindow d;
        QVERIFY(d.begins());
        auto* panel = d->study<SectionPanel>();
        panel->setPosition(-0.9);
        QVERIFY(d.rests(60000));
        SectionView* view = panel->view();
        QSignalSpy told(view, &SectionView::hovered);
        // About the middle of the container, beside which there are numbers.
        QTest::mouseMove(view, QPoint(view->width() / 2 - 30, view->height() / 2 - 6));
        QVERIFY(d.knows());
        const glm::dvec3 under = view->field().plane.at(told.last()[0].toDouble(), told.last()[1].toDouble());
        QVERIFY(d.probe()->point()->place == under);
        QVERIFY(under.z == -0.9);
        QCOMPARE(d.probe()->point()->value, glm::dot(under, under));
        QCOMPARE(d.disagreement(), QString());
        // The middle of that plane lies inside of the ball.
        QVERIFY(glm::length(under) < 1 && d.probe()->hidden());
        QVERIFY(!d->viewport()->probeMark().point());
        panel->setPosition(-1.2);
        QVERIFY(d.rests(60000));
        view->tellHover();
        QTRY_VERIFY(d.probe()->upToDate() && d.probe()->point() && d.probe()->point()->place.z == -1.2);
        QVERIFY(!d.probe()->hidden());
        QVERIFY(d->viewport()->probeMark().point() == d.probe()->point()->inScene);
    }

    void aPointOfTheRayIsSeenEverywhere() {
        ProbedWindow d;
        QVERIFY(d.begins());
        d->docks()->find("ray")->raise();
        QVERIFY(d.rests(60000));
        const RayPanel* panel = d->study<RayPanel>();
        QTRY_VERIFY(panel->chart()->settled());
        const RayProfile& profile = panel->profile();
        const double wanted = profile.near + 0.25 * (profile.far - profile.near);
        const QPoint at = panel->chart()->positionOf({wanted, 0}).toPoint();
        QTest::mouseMove(panel->chart(), at);
        QVERIFY(d.knows());
        const double t = panel->chart()->valueAt(at)->x();
        QVERIFY(std::abs(t - wanted) < 0.02 * (profile.far - profile.near));
        QVERIFY(std::abs(glm::distance(d.probe()->point()->inScene, glm::dvec3(0, 0, -4)) - t) < 1e-9);
        QVERIFY(std::abs(d.onRay() - t) < 1e-9);
        QCOMPARE(d.disagreement(), QString());
    }

    void aCriticalPlaceOfTheLevelsIsSeenEverywhere() {
        ProbedWindow d;
        QVERIFY(d.begins());
        d->docks()->find("levels")->raise();
        QVERIFY(d.rests(60000));
        ChartView* chart = d->study<ThresholdPanel>()->chart();
        QTRY_VERIFY(chart->settled());
        // The ball appears where f is 0, at the origin.
        QTest::mouseMove(chart, chart->positionOf({0, chart->chart().y.high / 2}).toPoint() + QPoint(1, 0));
        QVERIFY(d.knows());
        QVERIFY(glm::length(d.probe()->point()->place) < 1e-6);
        QVERIFY(std::abs(d.onLevels()) < 1e-9);
        QVERIFY(d->study<GradientPanel>()->probeText().endsWith(QStringLiteral(" % of max_gradient")));
    }

    void keysMoveThePointInTheSection() {
        ProbedWindow d;
        QVERIFY(d.begins());
        SectionView* view = d->study<SectionPanel>()->view();
        view->setFocus();
        QTest::keyClick(view, Qt::Key_Right);
        QVERIFY(d.knows());
        const glm::dvec3 middle = d.probe()->point()->place;
        QVERIFY(glm::length(middle) < 1e-9);
        QTest::keyClick(view, Qt::Key_Right);
        QTest::keyClick(view, Qt::Key_Up);
        QTest::keyClick(view, Qt::Key_Up, Qt::ShiftModifier);
        const double step = (view->field().right - view->field().left) / 100;
        QTRY_VERIFY(d.probe()->upToDate() &&
                    glm::distance(d.probe()->point()->place, glm::dvec3(step, 1.1 * step, 0)) < 1e-9);
        QCOMPARE(d.disagreement(), QString());
        // A screen reader has the values.
        QVERIFY2(view->accessibleDescription().contains(QStringLiteral("f − threshold = -0.9")),
                 qPrintable(view->accessibleDescription()));
        QTest::keyClick(view, Qt::Key_Escape);
        QVERIFY(!d.probe()->point() && d.onLevels() == nothing);
    }

    void keysMoveThePointAlongTheRay() {
        ProbedWindow d;
        QVERIFY(d.begins());
        d->docks()->find("ray")->raise();
        QVERIFY(d.rests(60000));
        const RayPanel* panel = d->study<RayPanel>();
        ChartView* chart = panel->chart();
        chart->setFocus();
        QTest::keyClick(chart, Qt::Key_Home);
        QVERIFY(d.knows());
        QVERIFY(std::abs(d.onRay() - panel->profile().near) < 1e-9);
        QTest::keyClick(chart, Qt::Key_Right);
        const double step = (panel->profile().far - panel->profile().near) / 100;
        QTRY_VERIFY(std::abs(d.onRay() - panel->profile().near - step) < 1e-9);
        QCOMPARE(d.disagreement(), QString());
        QVERIFY(chart->accessibleDescription().startsWith(QStringLiteral("at ")));
    }

    void theLineOfTheSectionSharesThePoint() {
        ProbedWindow d;
        QVERIFY(d.begins());
        auto* panel = d->study<SectionPanel>();
        panel->setProfileShown(true);
        QVERIFY(d.rests(60000));
        ChartView* chart = panel->profile()->chart();
        chart->setFocus();
        QTest::keyClick(chart, Qt::Key_Home);
        QVERIFY(d.knows());
        QVERIFY(d.probe()->point()->place == panel->profile()->samples().from);
        QVERIFY(ProbedWindow::of(chart) == 0);
        const QPoint at = d->viewport()->rect().center();
        QTest::mouseMove(d->viewport(), at);
        QTRY_VERIFY(d.probe()->upToDate() && d.probe()->source() == d->viewport());
        const LineSamples& line = panel->profile()->samples();
        const glm::dvec3 way = (line.to - line.from) / line.length();
        QVERIFY(std::abs(ProbedWindow::of(chart) - glm::dot(d.probe()->point()->place - line.from, way)) <
                1e-9);
    }

    void hoveringDrawsNoPictureAgain() {
        ProbedWindow d;
        QVERIFY(d.begins());
        SectionView* section = d->study<SectionPanel>()->view();
        QTRY_VERIFY(section->settled());
        QSignalSpy drawn(d->viewport(), &Viewport::progressed);
        const qint64 picture = d->viewport()->picture().cacheKey(), frame = section->frame().cacheKey();
        QSignalSpy changed(d.probe(), &LinkedProbe::changed);
        for (int i = 0; i < 12; ++i) {
            QTest::mouseMove(d->viewport(), d->viewport()->rect().center() + QPoint(4 + 4 * i, 2 * i));
            QVERIFY(d.knows());
            QTest::qWait(20);
        }
        QVERIFY(changed.size() >= 12);
        QCOMPARE(drawn.size(), 0);
        QCOMPARE(d->viewport()->picture().cacheKey(), picture);
        QCOMPARE(section->frame().cacheKey(), frame);
        d->docks()->find("ray")->raise();
        QVERIFY(d.rests(60000));
        ChartView* ray = d->study<RayPanel>()->chart();
        QTRY_VERIFY(ray->settled());
        const qint64 curve = ray->frame().cacheKey();
        for (int i = 0; i < 12; ++i) {
            QTest::mouseMove(ray, ray->rect().center() + QPoint(4 * i, 0));
            QVERIFY(d.knows());
            QTest::qWait(20);
        }
        QCOMPARE(ray->frame().cacheKey(), curve);
        QCOMPARE(drawn.size(), 0);
    }

    void thePointFollowsANumberThatMoves() {
        ProbedWindow d;
        QVERIFY(d.begins());
        SectionView* view = d->study<SectionPanel>()->view();
        view->setFocus();
        QTest::keyClick(view, Qt::Key_Right);
        for (int i = 0; i < 10; ++i) QTest::keyClick(view, Qt::Key_Right);
        QVERIFY(d.knows());
        const glm::dvec3 place = d.probe()->point()->place;
        const double before = d.probe()->point()->value;
        QString doubled = ball;
        doubled.replace(QStringLiteral("x*x + y*y"), QStringLiteral("4*x*x + y*y"));
        d->editor()->setSceneText(doubled);
        QVERIFY(d.rests(60000));
        QTRY_VERIFY(d.probe()->upToDate() && d.probe()->point());
        QVERIFY(d.probe()->point()->place == place);
        QVERIFY(std::abs(d.probe()->point()->value - 4 * before) < 1e-9);
        QCOMPARE(d.onLevels(), d.probe()->point()->value);
    }
};

QTEST_MAIN(LinkedProbeTest)
#include "linked_probe_test.moc"
