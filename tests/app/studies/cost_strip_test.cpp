// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/studies/cost_strip.h"

#include "app/desktop/studies/study_controller.h"
#include "app/desktop/window/rest_watch.h"
#include "tests/app/window_driver.h"
#include "widgets/editor/scene_editor.h"
#include "widgets/parameters/parameter_panel.h"
#include "widgets/parameters/parameter_slider.h"
#include "widgets/studies/cost_surveyor.h"
#include "widgets/viewport/viewport.h"

using namespace isoscope;
using namespace isoscope::test;

namespace {

const QString torus = QStringLiteral(
    "#version 3.7;\n#include \"functions.inc\"\ncamera { location <0.4, 2, -4> look_at 0 angle 40 }\n"
    "light_source { <4, 6, -5> rgb 1 }\nisosurface {\n  function { f_torus(x, y, z, 0.8, 0.2) }\n"
    "  contained_by { box { -1.1, 1.1 } }\n  accuracy 0.001\n  max_gradient 1\n  pigment { rgb 0.9 }\n}\n");

CostStrip* stripOf(WindowDriver& d, const QString& name) {
    ParameterSlider* slider = d->parameters()->slider(d.parameter(name));
    return slider ? slider->strip() : nullptr;
}

bool measured(WindowDriver& d) {
    return QTest::qWaitFor(
        [&] {
            for (const char* name : {"accuracy", "max_gradient"}) {
                const CostStrip* strip = stripOf(d, QLatin1String(name));
                if (!strip || !strip->fresh()) return false;
            }
            return true;
        },
        90000);
}

}  // namespace

/// The strips under the sliders of the real window.
class WindowCostStripTest : public QObject {
    Q_OBJECT

  private slots:
    void theStripsAppearAtRest() {
        WindowDriver d;
        d->editor()->setSceneText(torus);
        QVERIFY(d.rests(60000));
        QVERIFY(measured(d));
        const CostStrip* accuracy = stripOf(d, QStringLiteral("accuracy"));
        QCOMPARE(accuracy->plot().marks.size(), std::size_t(7));
        QVERIFY(accuracy->plot().knee);
        QVERIFY(accuracy->summary().startsWith(QStringLiteral("POV-Ray ")));
        QVERIFY2(accuracy->summary().contains(QStringLiteral("± 50 % at 800 × 600")),
                 qPrintable(accuracy->summary()));
        QCOMPARE(stripOf(d, QStringLiteral("max_gradient"))->plot().setting, StudiedSetting::maxGradient);
    }

    void aClickSetsTheValueAsOneUndoStepAndKeepsTheStrip() {
        WindowDriver d;
        d->editor()->setSceneText(torus);
        QVERIFY(d.rests(60000));
        QVERIFY(measured(d));
        CostStrip* strip = stripOf(d, QStringLiteral("accuracy"));
        QTest::mouseClick(strip, Qt::LeftButton, {},
                          QPoint(qRound(strip->positionOf(1e-5)), strip->height() / 2));
        QCOMPARE(d.numberBehind(QStringLiteral("accuracy")), 1e-5);
        QVERIFY(d.rests(60000));
        QTest::qWait(500);
        // What was measured over this setting still holds.
        QVERIFY(stripOf(d, QStringLiteral("accuracy"))->fresh());
        d->editor()->undo();
        QCOMPARE(d->editor()->sceneText(), torus);
    }

    void nothingIsMeasuredWhileSomethingMoves() {
        WindowDriver d;
        d->editor()->setSceneText(torus);
        QVERIFY(d.rests(60000));
        CostSurveyor* surveyor = d->studies()->surveyor();
        QVERIFY(QTest::qWaitFor([&] { return surveyor->surveying(); }, 60000));
        bool surveyed = true;
        quint64 before = 0, after = 0;
        d.drag(d.parameter(QStringLiteral("Major Radius")), 12, [&] {
            surveyed = surveyor->surveying() || d->studies()->restWatch()->resting();
            QTest::qWait(100);  // what was under way has been told by now
            before = surveyor->measuredValues();
            QTest::qWait(700);  // longer than the pause after which it begins at rest
            after = surveyor->measuredValues();
        });
        QVERIFY(!surveyed);
        QCOMPARE(after, before);
        QVERIFY(measured(d));
    }

    void anotherViewMakesThemPaleAndTheOldOneIsRemembered() {
        WindowDriver d;
        d->editor()->setSceneText(torus);
        QVERIFY(d.rests(60000));
        QVERIFY(measured(d));
        CostStrip* strip = stripOf(d, QStringLiteral("accuracy"));
        d.dragViewport({100, 100}, {60, 30});
        QVERIFY(!strip->fresh());
        QVERIFY(strip->hasOld());
        QVERIFY(measured(d));
        d->viewport()->resetView();
        QVERIFY(QTest::qWaitFor([&] { return d->viewport()->finished(); }, 60000));
        QVERIFY(measured(d));
        const quint64 values = d->studies()->surveyor()->measuredValues();
        QTest::qWait(800);
        QCOMPARE(d->studies()->surveyor()->measuredValues(), values);
    }

    void povraysTimeIsToldForTheSizeOfTheExport() {
        WindowDriver d;
        d->editor()->setSceneText(torus);
        QVERIFY(d.rests(60000));
        d->studies()->setExportSize({320, 200});
        QVERIFY(measured(d));
        const QString summary = stripOf(d, QStringLiteral("accuracy"))->summary();
        QVERIFY2(summary.contains(QStringLiteral("at 320 × 200")), qPrintable(summary));
    }

    /// It said "measuring what it costs" for ever, beside a text that could not be shown.
    void aTextThatCannotBeShownIsNotMeasured() {
        const QString wrong =
            QStringLiteral("#version 3.7;\nisosurface { function { x + nonsense(y) } max_gradient 2 }\n");
        WindowDriver d;
        d->editor()->setSceneText(wrong);
        QVERIFY(d.rests(60000));
        QVERIFY(stripOf(d, QStringLiteral("accuracy")));
        QTRY_VERIFY(!stripOf(d, QStringLiteral("accuracy"))->measurable());
        d->editor()->setSceneText(torus);
        QVERIFY(d.rests(60000));
        QVERIFY(measured(d));
        // The picture of the text before stays, and has nothing at this place.
        d->editor()->setSceneText(wrong);
        QVERIFY(d.rests(60000));
        QTRY_VERIFY(!stripOf(d, QStringLiteral("max_gradient"))->measurable());
    }

    void aSceneWithoutIsosurfaceHasNone() {
        WindowDriver d;
        d->editor()->setSceneText(
            QStringLiteral("#version 3.7;\ncamera { location -3*z }\nsphere { 0, 1 }\n"));
        QVERIFY(d.rests(60000));
        QVERIFY(!stripOf(d, QStringLiteral("accuracy")));
        QVERIFY(!d->studies()->surveyor()->surveying());
    }
};

QTEST_MAIN(WindowCostStripTest)
#include "cost_strip_test.moc"
