// SPDX-License-Identifier: GPL-3.0-or-later
// The end of a run: work whose result will not be seen is given up.
#include <QAction>
#include <QDockWidget>
#include <QElapsedTimer>

#include "app/desktop/studies/study_controller.h"
#include "app/desktop/studies/verdict_controller.h"
#include "app/desktop/window/actions.h"
#include "app/desktop/window/docks.h"
#include "tests/app/window_driver.h"
#include "widgets/editor/scene_editor.h"
#include "widgets/studies/accuracy_panel.h"
#include "widgets/studies/gradient_panel.h"
#include "widgets/verdicts/verdict_study.h"
#include "widgets/viewport/viewport.h"

using namespace isoscope;
using namespace isoscope::test;

namespace {

/// Seconds of work for each study.
const QString slow = QStringLiteral(
    "#version 3.7;\n#include \"functions.inc\"\ncamera { location <0, 2, -5> look_at 0 angle 40 }\n"
    "light_source { <4, 6, -5> rgb 1 }\nisosurface {\n"
    "  function { x*x + y*y + z*z - 1 + 0.2*f_noise3d(x*19, y*19, z*19)*f_ridged_mf(x, y, z, 0.1, 3, 9, 0.7, "
    "0.7, 2) }\n  contained_by { sphere { 0, 2 } }\n  max_gradient 9\n  pigment { rgb 0.9 }\n}\n");

}  // namespace

class ClosingTest : public QObject {
    Q_OBJECT

  private slots:
    /// D33: with proofs, histogram, costs and overlay at work.
    void noStudyGoesOn() {
        auto driver = std::make_unique<WindowDriver>();
        WindowDriver& d = *driver;
        d->editor()->setSceneText(slow);
        d->docks()->find("histogram")->raise();
        QTRY_VERIFY(d->study<GradientPanel>()->isActive());
        d->actions()->inspectRay->setChecked(true);
        WindowDriver::trigger(d->actions()->overlayGradient);
        VerdictStudy* verdicts = d->studies()->verdicts()->study();
        QTRY_VERIFY(verdicts->busy());
        d->study<AccuracyPanel>()->measure();

        QElapsedTimer since;
        since.start();
        d->close();
        const qint64 closed = since.elapsed();
        QVERIFY(!verdicts->busy());
        QVERIFY(!d->study<GradientPanel>()->isActive());
        QVERIFY(!d->study<AccuracyPanel>()->measuring());
        QVERIFY(!d->viewport()->overlay().busy());
        driver.reset();
        qInfo("close() took %lld ms, the end %lld ms", closed, since.elapsed() - closed);
    }
};

QTEST_MAIN(ClosingTest)
#include "closing_test.moc"
