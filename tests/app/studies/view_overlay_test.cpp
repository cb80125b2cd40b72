// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/viewport/view_overlay.h"

#include <QAction>
#include <QClipboard>
#include <QDockWidget>
#include <QGuiApplication>
#include <QPushButton>
#include <QLocale>
#include <QSignalSpy>
#include <QToolButton>

#include "app/desktop/window/actions.h"
#include "app/desktop/window/docks.h"
#include "tests/app/sphere_text.h"
#include "tests/app/window_driver.h"
#include "widgets/document/scene_session.h"
#include "widgets/editor/scene_editor.h"
#include "widgets/studies/gradient_panel.h"
#include "widgets/viewport/cost_overlay.h"
#include "widgets/viewport/heat_overlay.h"
#include "widgets/viewport/hole_overlay.h"
#include "widgets/viewport/overlay_bar.h"
#include "widgets/viewport/viewport.h"
#include "widgets/viewport/viewport_panel.h"

using namespace isoscope;
using namespace isoscope::test;

namespace {

/// Pixels of one colour in the legend.
constexpr std::uint64_t swatch = 144;

QImage shown(const WindowDriver& d) { return d->viewport()->grab().toImage(); }

std::uint64_t countOf(const QImage& image, const QColor& color) {
    std::uint64_t count = 0;
    for (int y = 0; y < image.height(); ++y)
        for (int x = 0; x < image.width(); ++x) count += image.pixelColor(x, y) == color;
    return count;
}

bool showsSphere(WindowDriver& d) {
    d->editor()->setSceneText(sphereText);
    return d.rests(60000);
}

}  // namespace

/// What is laid over the picture of the viewport, in the real window.
class ViewOverlayTest : public QObject {
    Q_OBJECT

  private slots:
    void holesAreMarkedAndCounted() {
        WindowDriver d;
        QVERIFY(showsSphere(d));
        QVERIFY(!d->viewportPanel()->overlayBar()->isVisible());
        d->actions()->overlayHoles->trigger();
        QVERIFY(d.rests(60000));
        const HoleMap& map = d->viewport()->overlay().holes();
        QCOMPARE(QSize(map.width, map.height), d->viewport()->picture().size());
        QVERIFY(map.count(HolePixel::wrongPlace) > 1000);
        QVERIFY(d->viewportPanel()->overlayBar()->isVisible());
        const QString text = d->viewportPanel()->overlayBar()->text();
        QVERIFY2(text.startsWith(
                     QStringLiteral("POV-Ray's method: %1 lost, ")
                         .arg(QLocale::c().toString(static_cast<qulonglong>(map.count(HolePixel::lost))))),
                 qPrintable(text));
        // Each has its colour on the screen, but for those below the texts.
        const QColor yellow = holeColor(HolePixel::wrongPlace);
        const std::uint64_t wrong = map.count(HolePixel::wrongPlace), marked = countOf(shown(d), yellow);
        QVERIFY2(marked > wrong * 8 / 10 && marked <= wrong + swatch,
                 qPrintable(QStringLiteral("%1 of %2").arg(marked).arg(wrong)));
        d->actions()->overlayNone->trigger();
        QCOMPARE(countOf(shown(d), yellow), std::uint64_t(0));
    }

    void theSuggestedValueClosesTheHolesOfThePicture() {
        WindowDriver d;
        d->docks()->find("gradient")->raise();
        QVERIFY(showsSphere(d));
        d->actions()->overlayHoles->trigger();
        QVERIFY(d.rests(60000));
        QVERIFY(d->viewport()->overlay().holes().mistakes() > 1000);
        GradientPanel* panel = d->study<GradientPanel>();
        QVERIFY(QTest::qWaitFor([&] { return panel->isActive() && panel->upToDate(); }, 60000));
        QTest::mouseClick(panel->useSuggested(), Qt::LeftButton);
        QVERIFY(d->editor()->sceneText().contains(QStringLiteral("max_gradient 2.4\n")));
        QVERIFY(d.rests(60000));
        const ViewOverlay& overlay = d->viewport()->overlay();
        QVERIFY(overlay.ready());
        QCOMPARE(overlay.holes().mistakes(), std::uint64_t(0));
        QVERIFY2(overlay.summary().startsWith(QStringLiteral("POV-Ray's method loses none of ")),
                 qPrintable(overlay.summary()));
        for (const HolePixel kind : {HolePixel::lost, HolePixel::gained, HolePixel::wrongPlace})
            QVERIFY(countOf(shown(d), holeColor(kind)) <= swatch);
    }

    void marksOfAnOlderPictureGoAtOnce() {
        WindowDriver d;
        QString text = sphereText;  // which looks the same from all sides
        d->editor()->setSceneText(text.replace(QStringLiteral("y*y"), QStringLiteral("4*y*y")));
        QVERIFY(d.rests(60000));
        d->actions()->overlayDifference->trigger();
        QVERIFY(d.rests(60000));
        const auto before = d->viewport()->overlay().holes().pixels;
        QVERIFY(!before.empty());
        bool goneMeanwhile = false;
        const auto connection = connect(d->viewport(), &Viewport::viewChanged, this, [&] {
            goneMeanwhile = goneMeanwhile || d->viewport()->overlay().holes().pixels.empty();
        });
        d.dragViewport({100, 100}, {60, 30});
        disconnect(connection);
        QVERIFY(goneMeanwhile);
        QVERIFY(d.rests(60000));
        QVERIFY(!d->viewport()->overlay().holes().pixels.empty());
        QVERIFY(d->viewport()->overlay().holes().pixels != before);
    }

    /// It was dropped and counted again, with a flicker, when only places in the text had changed.
    void theSamePictureKeepsTheOverlay() {
        WindowDriver d;
        QVERIFY(d.rests());
        ViewOverlay& overlay = d->viewport()->overlay();
        d->actions()->overlayHoles->trigger();
        QVERIFY(d.rests(60000));
        QVERIFY(overlay.ready());
        bool dropped = false;
        connect(&overlay, &ViewOverlay::changed, this, [&] { dropped = dropped || !overlay.ready(); });
        QSignalSpy finished(d->viewport(), &Viewport::pictureFinished);
        d->viewport()->setScene(std::make_shared<Scene>(*d->viewport()->scene()), true);
        QVERIFY(QTest::qWaitFor([&] { return finished.count() == 1; }, 60000));
        QVERIFY(d.rests(60000));
        QVERIFY(!dropped && overlay.ready());
        // Another picture drops it.
        d->viewport()->setScene(std::make_shared<Scene>(*d->viewport()->scene()));
        QVERIFY(!overlay.ready());
    }

    void theDividerShowsBothPictures() {
        WindowDriver d;
        QVERIFY(showsSphere(d));
        d->actions()->povray->trigger();
        QVERIFY(d.rests(60000));
        const QImage holed = shown(d);
        d->actions()->certified->trigger();
        QVERIFY(d.rests(60000));
        const QImage whole = shown(d);
        d->actions()->overlaySplit->trigger();
        QVERIFY(d.rests(60000));
        Viewport* viewport = d->viewport();
        const int width = viewport->width(), height = viewport->height();
        const auto half = [&](const QImage& image, bool left, int divider) {
            // Without the box above, the labels below, and the divider.
            return left ? image.copy(2, 50, divider - 12, height - 100)
                        : image.copy(divider + 10, 50, width - divider - 12, height - 100);
        };
        const auto isSplitAt = [&](int divider) {
            const QImage split = shown(d);
            return difference(half(split, true, divider), half(holed, true, divider)) == 0 &&
                   difference(half(split, false, divider), half(whole, false, divider)) == 0;
        };
        QVERIFY(difference(holed, whole) > 0.005);
        QVERIFY(isSplitAt(width / 2));
        const QPoint grip(width / 2, height / 2);
        const Camera camera = viewport->camera();
        d.dragViewport(grip, {-width / 5, 0});
        QVERIFY(viewport->camera() == camera);
        QVERIFY(std::abs(viewport->overlay().divider() - 0.3) < 0.02);
        QVERIFY(isSplitAt(static_cast<int>(std::lround(viewport->overlay().divider() * width))));
        QTest::keyClick(viewport, Qt::Key_Right, Qt::AltModifier);
        QVERIFY(std::abs(viewport->overlay().divider() - 0.32) < 0.02);
        // The other way round: the viewport draws POV-Ray's picture, the overlay the certified one.
        d->actions()->povray->trigger();
        QVERIFY(d.rests(60000));
        QVERIFY(isSplitAt(static_cast<int>(std::lround(viewport->overlay().divider() * width))));
    }

    void aKeptSceneStandsBesideTheChangedOne() {
        WindowDriver d;
        QVERIFY(showsSphere(d));
        const QImage before = shown(d);
        QVERIFY(!d->actions()->copyDifference->isEnabled());
        d->actions()->overlayCompare->trigger();
        QVERIFY(d.rests(60000));
        QString text = sphereText;
        text.replace(QStringLiteral("x*x"), QStringLiteral("4*x*x"));
        QVERIFY(text != sphereText);
        d->editor()->setSceneText(text);
        QVERIFY(d.rests(60000));
        QVERIFY(d->viewport()->overlay().ready());
        const QImage both = shown(d);
        d->actions()->overlayNone->trigger();
        QVERIFY(d.rests(60000));
        const QImage after = shown(d);
        const int width = both.width(), height = both.height();
        // Without the box above, the labels below, and the divider.
        const QRect left(2, 50, width / 2 - 12, height - 100),
            right(width / 2 + 10, 50, width / 2 - 12, height - 100);
        QVERIFY(difference(before.copy(left), after.copy(left)) > 0.01);
        QVERIFY(difference(both.copy(left), before.copy(left)) < 0.01);
        QVERIFY(difference(both.copy(right), after.copy(right)) < 0.01);
        QVERIFY(!d->viewport()->overlay().kept());
    }

    void theDifferenceSurfaceIsCopied() {
        WindowDriver d;
        QVERIFY(showsSphere(d));
        d->actions()->overlayCompare->trigger();
        QVERIFY(d->actions()->copyDifference->isEnabled());
        QString text = sphereText;
        d->editor()->setSceneText(text.replace(QStringLiteral("x*x"), QStringLiteral("4*x*x")));
        QVERIFY(d.rests(60000));
        d->actions()->copyDifference->trigger();
        const QString copied = QGuiApplication::clipboard()->text();
        QVERIFY2(copied.contains(QStringLiteral("isosurface {")), qPrintable(copied));
        QVERIFY(copied.contains(QStringLiteral("pow(x, 2)")));
        d->editor()->setSceneText(QStringLiteral("#version 3.7;\n#include \"functions.inc\"\n") + copied);
        QVERIFY(d.rests(60000));
        QCOMPARE(d->session()->scene()->isosurfaces.size(), std::size_t(1));
    }

    void aSlowOneTellsItsProgressAndCanBeStopped() {
        WindowDriver d;
        d->editor()->setSceneText(
            QStringLiteral("#version 3.7;\ncamera { location <0, 0, -4> look_at 0 angle 40 }\nlight_source { "
                           "<4, 6, -5> rgb 1 }\n"
                           "isosurface {\n  function { x*x + y*y + z*z - 1 + 0.3*f_noise3d(9*x, 9*y, 9*z) }\n"
                           "  contained_by { sphere { 0, 1.2 } }\n  accuracy 1e-9 max_gradient 2000\n  "
                           "pigment { rgb 0.9 }\n}\n"));
        d->actions()->certified->trigger();
        QVERIFY(d.rests(60000));
        d->actions()->overlayHoles->trigger();
        ViewOverlay& overlay = d->viewport()->overlay();
        QVERIFY(overlay.busy());
        OverlayBar* bar = d->viewportPanel()->overlayBar();
        QVERIFY(!bar->stopButton()->isVisible());
        QVERIFY(QTest::qWaitFor([&] { return bar->stopButton()->isVisible(); }, 10000));
        QVERIFY(overlay.busy() && overlay.share() < 1);
        QTest::mouseClick(bar->stopButton(), Qt::LeftButton);
        QVERIFY(!overlay.busy() && !overlay.ready());
        QVERIFY2(bar->text().startsWith(QStringLiteral("Stopped.")), qPrintable(bar->text()));
        QVERIFY(!bar->stopButton()->isVisible());
    }

    void theGradientIsShownAsHeat() {
        WindowDriver d;
        QVERIFY(showsSphere(d));
        d->actions()->overlayGradient->trigger();
        QVERIFY(d.rests(60000));
        const GradientHeatMap& heat = d->viewport()->overlay().heat();
        // |grad| is 2 on the unit sphere, and the setting 1.1.
        QVERIFY(heat.seen > 10000);
        QCOMPARE(heat.over, heat.seen);
        QVERIFY(std::abs(heat.largest - 2 / 1.1) < 1e-6);
        QVERIFY2(d->viewportPanel()->overlayBar()->text().contains(QStringLiteral("up to 1.82 times")),
                 qPrintable(d->viewportPanel()->overlayBar()->text()));
        QVERIFY(countOf(shown(d), QColor(heatColor(heat.largest).rgb())) > heat.seen / 2);
    }

    void theCostIsShownByCause() {
        WindowDriver d;
        QVERIFY(showsSphere(d));
        d->actions()->overlayCost->trigger();
        QVERIFY(d.rests(60000));
        const CostMap& cost = d->viewport()->overlay().cost();
        QVERIFY(cost.complete && cost.evaluations() > 10000);
        const QList<LegendEntry> legend = costLegend(cost);
        QCOMPARE(static_cast<std::size_t>(legend.size()), costCauseCount);
        for (std::size_t i = 0; i < costCauseCount; ++i)
            QVERIFY2(legend[static_cast<int>(i)].text.contains(
                         QLocale::c().toString(static_cast<qulonglong>(cost.totals[i]))),
                     qPrintable(legend[static_cast<int>(i)].text));
        QVERIFY2(d->viewportPanel()->overlayBar()->text().contains(
                     QLocale::c().toString(static_cast<qulonglong>(cost.dearest))),
                 qPrintable(d->viewportPanel()->overlayBar()->text()));
        // The picture is replaced: its corner meets no container, and costs nothing.
        QCOMPARE(shown(d).pixelColor(3, 3), QColor(Qt::black));
    }

    void theCostComesInFewPixelsFirstAndIsStopped() {
        WindowDriver d;
        QVERIFY(showsSphere(d));
        ViewOverlay& overlay = d->viewport()->overlay();
        QList<QSize> seen;
        bool stopAtFirst = false;
        connect(&overlay, &ViewOverlay::changed, this, [&] {
            const QSize size(overlay.cost().width, overlay.cost().height);
            if (!overlay.cost().complete || (!seen.isEmpty() && seen.last() == size)) return;
            seen << size;
            if (stopAtFirst) QMetaObject::invokeMethod(&overlay, [&overlay] { overlay.stop(); });
        });
        d->actions()->overlayCost->trigger();
        QVERIFY(d.rests(60000));
        QCOMPARE(seen.size(), qsizetype(2));
        QCOMPARE(seen[0], QSize(seen[1].width() / 4, seen[1].height() / 4));
        // Stopped while it is refined, what is there stays; the next picture has all again.
        seen.clear();
        stopAtFirst = true;
        d.dragViewport(d->viewport()->rect().center(), {30, 0});
        QTRY_VERIFY_WITH_TIMEOUT(seen.size() == 1 && !overlay.busy(), 60000);
        QVERIFY(overlay.cost().complete && overlay.cost().width == seen[0].width());
        stopAtFirst = false;
        d.dragViewport(d->viewport()->rect().center(), {30, 0});
        QVERIFY(d.rests(60000));
        QTRY_VERIFY_WITH_TIMEOUT(overlay.cost().width > seen[0].width(), 60000);
    }

    void withoutSurfaceNothingIsWrong() {
        WindowDriver d;
        d->actions()->overlayHoles->trigger();
        d->editor()->setSceneText(QStringLiteral("#version 3.7;\ncamera { location -3*z }\n"));
        QVERIFY(d.rests(60000));
        QCOMPARE(d->viewport()->overlay().holes().mistakes(), std::uint64_t(0));
        QVERIFY(d->viewport()->overlay().ready());
        d->actions()->overlayGradient->trigger();
        QVERIFY(d.rests(60000));
        QCOMPARE(d->viewport()->overlay().summary(), QStringLiteral("No isosurface is seen in this view"));
    }

    void theButtonTellsWhatIsOn() {
        WindowDriver d;
        QToolButton* button = nullptr;
        for (auto* candidate : d->findChildren<QToolButton*>())
            if (candidate->accessibleName() == QStringLiteral("Overlay of the picture")) button = candidate;
        QVERIFY(button);
        QCOMPARE(button->text(), QStringLiteral("Overlay"));
        d->actions()->overlaySplit->trigger();
        QCOMPARE(button->text(), QStringLiteral("Split"));
        d->actions()->overlayNone->trigger();
        QCOMPARE(button->text(), QStringLiteral("Overlay"));
    }
};

QTEST_MAIN(ViewOverlayTest)
#include "view_overlay_test.moc"
