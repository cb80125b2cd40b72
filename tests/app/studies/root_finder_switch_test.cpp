// SPDX-License-Identifier: GPL-3.0-or-later
#include <QAction>
#include <QTest>
#include <QToolBar>

#include "app/desktop/window/actions.h"
#include "tests/app/window_driver.h"
#include "widgets/document/scene_session.h"
#include "widgets/viewport/verdict_overlay.h"
#include "widgets/viewport/viewport.h"
#include "widgets/viewport/viewport_panel.h"

using namespace isoscope;
using namespace isoscope::test;

/// The switch certified | POV-Ray of the viewport, and what is shown of the verdicts.
class RootFinderSwitchTest : public QObject {
    Q_OBJECT

    std::unique_ptr<WindowDriver> driver_;
    void open(const QByteArray& text) {
        QVERIFY(driver_->openText(text));
        QVERIFY(driver_->rests(60000));
    }

  private slots:
    void init() { driver_ = std::make_unique<WindowDriver>(); }
    void cleanup() { driver_.reset(); }

    void oneOfThemIsAlwaysOn() {
        WindowDriver& d = *driver_;
        const bool certified = Viewport::defaultRootFinder == RootFinder::certified;
        QCOMPARE(d->actions()->certified->isChecked(), certified);
        QCOMPARE(d->actions()->povray->isChecked(), !certified);
        for (QAction* action : {d->actions()->certified, d->actions()->povray, d->actions()->verdicts})
            QVERIFY(d->viewportPanel()->tools()->actions().contains(action));
        d->actions()->certified->trigger();
        QVERIFY(!d->actions()->povray->isChecked());
        QVERIFY(d->actions()->verdicts->isEnabled());
        d->actions()->povray->trigger();
        QVERIFY(!d->actions()->certified->isChecked());
        QVERIFY(!d->actions()->verdicts->isEnabled());
    }

    void theCertifiedPictureHasNoHoles() {
        WindowDriver& d = *driver_;
        // max_gradient is far too small: POV-Ray sees hardly anything.
        // From -3*z some rays touch the ball exactly, at sizes such as 838 x 510, which nothing can prove.
        open(
            "camera { location -3.1*z look_at 0 } light_source { -9*z rgb 1 }\n"
            "isosurface { function { x*x + y*y + z*z - 1 } contained_by { sphere { 0, 1.2 } } max_gradient "
            "0.7\n"
            "pigment { rgb 1 } finish { ambient 1 } }\n");
        const auto lit = [&] {
            int count = 0;
            const QImage picture = d.picture();
            for (int y = 0; y < picture.height(); ++y)
                for (int x = 0; x < picture.width(); ++x) count += qGray(picture.pixel(x, y)) > 20;
            return count;
        };
        d->actions()->povray->trigger();
        QVERIFY(d.rests(60000));
        const int holed = lit();
        QVERIFY(!d->viewportPanel()->status().contains(QStringLiteral("proven")));
        QVERIFY(!d->viewport()->verdicts());
        d->actions()->certified->trigger();
        QVERIFY(d.rests(60000));
        QVERIFY2(lit() > holed * 11 / 10, qPrintable(QStringLiteral("%1 %2").arg(lit()).arg(holed)));
        QVERIFY2(d->viewportPanel()->status().contains(QStringLiteral("100 % proven")),
                 qPrintable(d->viewportPanel()->status()));
    }

    void theChoiceIsRemembered() {
        WindowDriver& d = *driver_;
        d->actions()->certified->trigger();
        d.restart();
        QVERIFY(d->actions()->certified->isChecked());
        QVERIFY(d->viewport()->rootFinder() == RootFinder::certified);
        d->actions()->povray->trigger();
        d.restart();
        QVERIFY(d->viewport()->rootFinder() == RootFinder::lipschitz);
    }

    void doubtfulPixelsAreMarkedAndExplained() {
        WindowDriver& d = *driver_;
        d->actions()->certified->trigger();
        open(
            "camera { location -4*z look_at 0 }\nisosurface { function { sin(1e5*(x*y + z))*max(0, sqrt(x*x "
            "+ y*y) - "
            "0.5)*1e-3 } contained_by { sphere { 0, 1.5 } } pigment { rgb 1 } }\n");
        QVERIFY(d->viewport()->verdicts());
        const QImage plain = d->viewport()->grab().toImage();
        d->actions()->verdicts->trigger();
        const QImage marked = d->viewport()->grab().toImage();
        QVERIFY(difference(plain, marked) > 0.02);
        QVERIFY2(d->viewportPanel()->status().contains(QStringLiteral("% proven: ")),
                 qPrintable(d->viewportPanel()->status()));
        d->actions()->verdicts->trigger();
        QCOMPARE(difference(d->viewport()->grab().toImage(), plain), 0.0);
    }

    void summaries() {
        QCOMPARE(verdictSummary({{"hit", 5}, {"miss", 2}}), QString());
        QCOMPARE(verdictSummary({{"certified-hit", 5}, {"certified-miss", 2}}),
                 QStringLiteral("100 % proven"));
        QCOMPARE(verdictSummary({{"certified-hit", 999}, {"gap", 1}}),
                 QStringLiteral("99.9 % proven: 1 unproven pixel"));
        QCOMPARE(verdictSummary({{"certified-hit", 1000000}, {"budget-exceeded", 1}}),
                 QStringLiteral("99.9999 % proven: 1 unproven pixel"));
        QCOMPARE(verdictSummary({{"certified-miss", 1}, {"gap", 1}, {"not-certified", 2}}),
                 QStringLiteral("25 % proven: 3 unproven pixels"));
    }
};

QTEST_MAIN(RootFinderSwitchTest)
#include "root_finder_switch_test.moc"
