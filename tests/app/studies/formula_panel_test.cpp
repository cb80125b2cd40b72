// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/studies/formula_panel.h"

#include <QAction>
#include <QClipboard>
#include <QDockWidget>
#include <QGuiApplication>
#include <QLabel>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QTreeWidget>

#include "app/desktop/window/actions.h"
#include "app/desktop/window/docks.h"
#include "tests/app/window_driver.h"
#include "widgets/editor/scene_editor.h"

using namespace isoscope;
using namespace isoscope::test;

namespace {

QString sceneWith(const QString& function) {
    return QStringLiteral(
               "#version 3.7;\ncamera { location <0, 2, -4> look_at 0 angle 40 }\n"
               "light_source { <4, 6, -5> rgb 1 }\nisosurface {\n  function { %1 } // kept\n"
               "  contained_by { box { -1.2, 1.2 } }\n  max_gradient 4\n  pigment { rgb 0.9 }\n}\n")
        .arg(function);
}

FormulaPanel* open(WindowDriver& d, const QString& function) {
    d->resize(1280, 800);
    d->editor()->setSceneText(sceneWith(function));
    d->docks()->bringUp(d->docks()->find("formula"));
    if (!d.rests(60000)) return nullptr;
    auto* panel = d->study<FormulaPanel>();
    return QTest::qWaitFor([&] { return panel->complete(); }, 60000) ? panel : nullptr;
}

}  // namespace

/// Other ways to write a function, in the real window.
class FormulaPanelTest : public QObject {
    Q_OBJECT

  private slots:
    void aClickRewritesAndUndoTakesItBack() {
        WindowDriver d;
        const QString before = QStringLiteral("(x + y*z)*(x + y*z) + y*y - 0.3");
        FormulaPanel* panel = open(d, before);
        QVERIFY(panel);
        QCOMPARE(panel->list()->topLevelItemCount(), 1);
        QVERIFY(!panel->rewriteButton()->isEnabled());
        panel->list()->setCurrentItem(panel->list()->topLevelItem(0));
        QVERIFY(panel->note()->text().contains(QStringLiteral("A*A = pow(A, 2)")));
        QTest::mouseClick(panel->rewriteButton(), Qt::LeftButton);
        QCOMPARE(d->editor()->sceneText(), sceneWith(QStringLiteral("pow(x + y*z, 2) + y*y - 0.3")));
        // What is listed follows the text.
        QVERIFY(d.rests(60000));
        QTRY_VERIFY_WITH_TIMEOUT(panel->complete() && panel->list()->topLevelItemCount() == 0, 60000);
        WindowDriver::trigger(d->actions()->undo);
        QCOMPARE(d->editor()->sceneText(), sceneWith(before));
    }

    void derivativesAreCopiedAndInserted() {
        WindowDriver d;
        const QString function = QStringLiteral("x*x + y*y + z*z - 1");
        FormulaPanel* panel = open(d, function);
        QVERIFY(panel);
        const QString text = panel->text()->toPlainText();
        QVERIFY2(text.contains(QStringLiteral("#declare f_dx = function(x, y, z)")), qPrintable(text));
        QVERIFY(text.contains(QStringLiteral("#declare f_normalised = function(x, y, z)")));
        QTest::mouseClick(panel->copyButton(), Qt::LeftButton);
        QCOMPARE(QGuiApplication::clipboard()->text(), text);
        QTest::mouseClick(panel->insertButton(), Qt::LeftButton);
        QCOMPARE(d->editor()->sceneText(),
                 sceneWith(function).replace(QStringLiteral("isosurface {"),
                                             text + QStringLiteral("isosurface {")));
        // The text can still be read, and the next declarations have names of their own.
        QVERIFY(d.rests(60000));
        QTRY_VERIFY_WITH_TIMEOUT(
            panel->complete() && panel->text()->toPlainText().contains(QStringLiteral("f2_dx")), 60000);
        WindowDriver::trigger(d->actions()->undo);
        QCOMPARE(d->editor()->sceneText(), sceneWith(function));
    }

    void withoutAnIsosurfaceThereIsNothing() {
        WindowDriver d;
        FormulaPanel* panel = open(d, QStringLiteral("x*x + y*y + z*z - 1"));
        QVERIFY(panel);
        d->editor()->setSceneText(QStringLiteral("camera { location -3*z look_at 0 }\nsphere { 0, 1 }\n"));
        QVERIFY(d.rests(60000));
        QTRY_VERIFY(!panel->copyButton()->isEnabled());
        QVERIFY(!panel->insertButton()->isEnabled() && !panel->rewriteButton()->isEnabled());
    }
};

QTEST_MAIN(FormulaPanelTest)
#include "formula_panel_test.moc"
