// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/studies/gradient_panel.h"

#include <QDockWidget>
#include <QLabel>
#include <QPushButton>

#include "app/desktop/window/docks.h"
#include "core/study/gradient/gradient_verdict.h"
#include "tests/app/sphere_text.h"
#include "tests/app/window_driver.h"
#include "widgets/editor/scene_editor.h"

using namespace isoscope;
using namespace isoscope::test;

namespace {

/// Shows the panel and the text, and waits for the measurement.
bool measured(WindowDriver& d, const QString& text) {
    d->editor()->setSceneText(text);
    d->docks()->find("gradient")->raise();
    if (!d.rests()) return false;
    return QTest::qWaitFor(
        [&] { return d->study<GradientPanel>()->isActive() && d->study<GradientPanel>()->upToDate(); },
        30000);
}

}  // namespace

class GradientPanelTest : public QObject {
    Q_OBJECT

  private slots:
    void theSuggestedValueClosesTheHoles() {
        WindowDriver d;
        QVERIFY(measured(d, sphereText));
        GradientPanel* panel = d->study<GradientPanel>();
        QCOMPARE(panel->survey().setting, 1.1);
        QVERIFY(panel->survey().holes.mistakes() > 100);
        QVERIFY(panel->holesText().contains(QStringLiteral("wrong place")));
        QVERIFY(panel->useSuggested()->isEnabled());

        QTest::mouseClick(panel->useSuggested(), Qt::LeftButton);
        QVERIFY(d->editor()->sceneText().contains(QStringLiteral("max_gradient 2.4\n")));
        QVERIFY(QTest::qWaitFor([&] { return panel->upToDate() && panel->survey().setting == 2.4; }, 30000));
        QCOMPARE(panel->survey().holes.mistakes(), std::uint64_t(0));
        QVERIFY(panel->holesText().startsWith(QStringLiteral("none")));
        QCOMPARE(judgeGradient(2.4, panel->survey().bracket, 0), GradientVerdict::right);

        // One undo step takes it out again.
        d->editor()->undo();
        QCOMPARE(d->editor()->sceneText(), sphereText);
    }

    void whatIsEnoughForTheViewIsOfferedBesides() {
        WindowDriver d;
        QString text = sphereText;
        text.replace(QStringLiteral("  contained_by"), QStringLiteral("  max_gradient 9\n  contained_by"));
        QVERIFY(measured(d, text));
        GradientPanel* panel = d->study<GradientPanel>();
        QVERIFY(panel->survey().enoughForView.has_value());
        QTest::mouseClick(panel->useEnough(), Qt::LeftButton);
        const double written = d.numberBehind(QStringLiteral("max_gradient"));
        QVERIFY(written > 1 && written <= 2.4);
        QVERIFY(
            QTest::qWaitFor([&] { return panel->upToDate() && panel->survey().setting == written; }, 30000));
        QCOMPARE(panel->survey().holes.mistakes(), std::uint64_t(0));
    }

    void anInfiniteGradientIsNamedWithItsPlace() {
        WindowDriver d;
        QString text = sphereText;
        text.replace(QStringLiteral("x*x + y*y + z*z - 1"), QStringLiteral("y - 0.1/(x - 0.25)"));
        QVERIFY(measured(d, text));
        const GradientBracket& b = d->study<GradientPanel>()->survey().bracket;
        QCOMPARE(b.state, GradientState::unbounded);
        QVERIFY(std::abs(b.place.x - 0.25) < 1e-9);
        QVERIFY(!d->study<GradientPanel>()->useSuggested()->isEnabled());
        bool named = false;
        for (const QLabel* label : d->study<GradientPanel>()->findChildren<QLabel*>())
            named = named || label->text().contains(QStringLiteral("a pole at <0.25"));
        QVERIFY(named);
    }

    void turningTheViewCountsAgain() {
        WindowDriver d;
        QString text = sphereText;
        text.replace(QStringLiteral("y*y"), QStringLiteral("4*y*y"));
        QVERIFY(measured(d, text));
        const auto before = d->study<GradientPanel>()->survey().holes.pixels;
        d.dragViewport({100, 100}, {120, 30});
        QVERIFY(d.rests());
        QVERIFY(QTest::qWaitFor(
            [&] {
                return d->study<GradientPanel>()->upToDate() &&
                       d->study<GradientPanel>()->survey().holes.pixels != before;
            },
            30000));
    }

    void withoutIsosurfaceNothingIsMeasured() {
        WindowDriver d;
        QVERIFY(measured(
            d, QStringLiteral(
                   "#version 3.7;\ncamera { location -3*z }\nlight_source { 9, 1 }\nsphere { 0, 1 }\n")));
        QVERIFY(!d->study<GradientPanel>()->useSuggested()->isEnabled() &&
                !d->study<GradientPanel>()->useEnough()->isEnabled());
        QCOMPARE(d->study<GradientPanel>()->holesText(), QStringLiteral("–"));
    }
};

QTEST_MAIN(GradientPanelTest)
#include "gradient_panel_test.moc"
