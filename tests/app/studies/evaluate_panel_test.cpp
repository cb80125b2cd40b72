// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/studies/evaluate_panel.h"

#include <QAction>
#include <QDockWidget>
#include <QLabel>
#include <QPushButton>
#include <QTreeWidget>

#include "app/desktop/window/actions.h"
#include "app/desktop/window/docks.h"
#include "tests/app/window_driver.h"
#include "widgets/document/scene_session.h"
#include "widgets/editor/scene_editor.h"

using namespace isoscope;
using namespace isoscope::test;

namespace {

const QString scene = QStringLiteral(
    "#version 3.7;\ncamera { location <0, 1, -4> look_at 0 angle 40 }\nlight_source { <4, 6, -5> rgb 1 }\n"
    "isosurface {\n  function { pow(x, 4) + pow(y, 4) + pow(z, 4) - 0.5 }\n"
    "  contained_by { box { -1.2, 1.2 } }\n  max_gradient 2\n  pigment { rgb 0.9 }\n}\n");

}  // namespace

/// Trials of `evaluate`, in the real window.
class EvaluatePanelTest : public QObject {
    Q_OBJECT

  private slots:
    void aTrialIsWrittenIntoTheText() {
        WindowDriver d;
        d->resize(1280, 800);
        d->editor()->setSceneText(scene);
        d->docks()->bringUp(d->docks()->find("evaluate"));
        QVERIFY(d.rests(60000));
        auto* panel = d->study<EvaluatePanel>();
        QVERIFY(!panel->measuring() && panel->list()->topLevelItemCount() == 0);
        QVERIFY(!panel->writeButton()->isEnabled());
        QTest::mouseClick(panel->startButton(), Qt::LeftButton);
        QVERIFY(panel->measuring());
        QTRY_VERIFY_WITH_TIMEOUT(!panel->measuring() && panel->advice().complete, 60000);
        const EvaluateAdvice& advice = panel->advice();
        QCOMPARE(static_cast<std::size_t>(panel->list()->topLevelItemCount()), advice.trials.size() + 1);
        // Any of the trials can be written.
        QTreeWidgetItem* row = panel->list()->topLevelItem(panel->list()->topLevelItemCount() - 1);
        const QString setting = row->text(0);  // the list changes with the text
        QVERIFY(setting.startsWith(QStringLiteral("evaluate ")));
        panel->list()->setCurrentItem(row);
        QTest::mouseClick(panel->writeButton(), Qt::LeftButton);
        QVERIFY(d.rests(60000));
        QVERIFY(d->editor()->sceneText().contains(QStringLiteral("}\n  ") + setting + QLatin1Char('\n')));
        const QString written = d->editor()->sceneText();
        // Measured before that change: to be measured again.
        QVERIFY(panel->old() && !panel->writeButton()->isEnabled());
        WindowDriver::trigger(d->actions()->undo);
        QCOMPARE(d->editor()->sceneText(), scene);
        QVERIFY(written != scene);
    }

    void stopEndsTheTrials() {
        WindowDriver d;
        d->editor()->setSceneText(scene);
        d->docks()->bringUp(d->docks()->find("evaluate"));
        QVERIFY(d.rests(60000));
        auto* panel = d->study<EvaluatePanel>();
        panel->measure();
        QTest::mouseClick(panel->startButton(), Qt::LeftButton);
        QVERIFY(!panel->measuring());
        QTest::qWait(300);
        QVERIFY(!panel->advice().complete && panel->list()->topLevelItemCount() == 0);
    }
};

QTEST_MAIN(EvaluatePanelTest)
#include "evaluate_panel_test.moc"
