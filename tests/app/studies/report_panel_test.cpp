// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/studies/report_panel.h"

#include <QAction>
#include <QDockWidget>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QScrollBar>
#include <QTreeWidget>

#include "app/desktop/window/actions.h"
#include "app/desktop/window/docks.h"
#include "tests/app/window_driver.h"
#include "widgets/editor/scene_editor.h"
#include "widgets/viewport/viewport.h"

using namespace isoscope;
using namespace isoscope::test;

namespace {

QString sceneWith(const QString& function) {
    return QStringLiteral(
               "#version 3.7;\n#include \"functions.inc\"\ncamera { location <0, 2, -4> look_at 0 angle 40 "
               "}\n"
               "light_source { <4, 6, -5> rgb 1 }\nisosurface {\n  function { %1 }\n"
               "  contained_by { box { -1.2, 1.2 } }\n  max_gradient 4\n  pigment { rgb 0.9 }\n}\n")
        .arg(function);
}

ReportPanel* open(WindowDriver& d, const QString& function) {
    d->resize(1280, 800);
    d->editor()->setSceneText(sceneWith(function));
    d->docks()->bringUp(d->docks()->find("report"));
    if (!d.rests(60000)) return nullptr;
    auto* panel = d->study<ReportPanel>();
    return QTest::qWaitFor([&] { return panel->health().known; }, 60000) ? panel : nullptr;
}

}  // namespace

/// What an isosurface is like, in the real window.
class ReportPanelTest : public QObject {
    Q_OBJECT

  private slots:
    void itIsWrittenWhenItIsSeen() {
        WindowDriver d;
        d->editor()->setSceneText(sceneWith(QStringLiteral("f_torus(x, y, z, 0.8, 0.2)")));
        QVERIFY(d.rests(60000));
        auto* panel = d->study<ReportPanel>();
        QVERIFY(!panel->working() && !panel->report().known);
        d->docks()->bringUp(d->docks()->find("report"));
        QTRY_VERIFY_WITH_TIMEOUT(panel->health().known && !panel->working(), 60000);
        const QString text = panel->text()->toPlainText();
        QVERIFY2(text.startsWith(QStringLiteral("Pieces: 1 piece with 1 tunnel and no hollows")),
                 qPrintable(text));
        QCOMPARE(text.count(QLatin1Char('\n')), 5);
        // Another camera changes nothing.
        const QString moved =
            d->editor()->sceneText().replace(QStringLiteral("<0, 2, -4>"), QStringLiteral("<0, 1, -4>"));
        d->editor()->setSceneText(moved);
        QVERIFY(d.rests(60000));
        QVERIFY(panel->report().known && !panel->working());
    }

    void aClickFliesToThePlace() {
        WindowDriver d;
        ReportPanel* panel = open(d, QStringLiteral("1/(x - 0.3) + y"));
        QVERIFY(panel);
        QTreeWidgetItem* pole = nullptr;
        for (int i = 0; i < panel->list()->topLevelItemCount(); ++i) {
            QTreeWidgetItem* row = panel->list()->topLevelItem(i);
            // “suspected” was cut off, beside a column with room to spare.
            for (int column = 0; column < 3; ++column)
                QVERIFY(panel->list()->columnWidth(column) >
                        panel->list()->fontMetrics().horizontalAdvance(row->text(column)));
            if (row->text(0).startsWith(QStringLiteral("infinite")) && row->text(2) == QStringLiteral("met"))
                pole = row;
        }
        QVERIFY(pole);
        const glm::dvec3 before = d->viewport()->camera().lookAt;
        panel->list()->scrollToItem(pole);
        QTest::mouseClick(panel->list()->viewport(), Qt::LeftButton, {},
                          panel->list()->visualItemRect(pole).center());
        const glm::dvec3 after = d->viewport()->camera().lookAt;
        QVERIFY(after != before);
        QVERIFY(std::abs(after.x - 0.3) < 0.05);
    }

    void aClickWritesTheRemedy() {
        WindowDriver d;
        // Infinitely steep where the root is 0.
        ReportPanel* panel = open(d, QStringLiteral("sqrt(x + 1.2) - (y + 1.5)"));
        QVERIFY(panel);
        QTRY_VERIFY_WITH_TIMEOUT(!panel->working(), 60000);
        constexpr int remedy = 4;
        QTreeWidgetItem* row = nullptr;
        for (int i = 0; i < panel->list()->topLevelItemCount() && !row; ++i)
            if (!panel->list()->topLevelItem(i)->text(remedy).isEmpty()) row = panel->list()->topLevelItem(i);
        QVERIFY(row && !panel->list()->isColumnHidden(remedy));
        QVERIFY(panel->rewriteButton()->isVisible() && !panel->rewriteButton()->isEnabled());
        const QString before = d->editor()->sceneText();
        panel->list()->setColumnWidth(0, 40);  // the window of the test is narrow
        panel->list()->scrollToItem(row);
        panel->list()->horizontalScrollBar()->setValue(panel->list()->horizontalScrollBar()->maximum());
        const QRect seen = panel->list()->visualRect(panel->list()->indexFromItem(row, remedy));
        QTest::mouseClick(panel->list()->viewport(), Qt::LeftButton, {},
                          QPoint(seen.left() + 8, seen.center().y()));
        QVERIFY(d->editor()->sceneText() != before);
        QVERIFY2(!d->editor()->sceneText().contains(QStringLiteral("sqrt(")),
                 qPrintable(d->editor()->sceneText()));
        // Another function, which is looked at again; it has no such place.
        QVERIFY(d.rests(60000));
        QTRY_VERIFY_WITH_TIMEOUT(panel->health().known && !panel->working(), 60000);
        QVERIFY(panel->list()->isColumnHidden(remedy));
        WindowDriver::trigger(d->actions()->undo);
        QCOMPARE(d->editor()->sceneText(), before);
    }

    void aHealthyFunctionIsCalledSo() {
        WindowDriver d;
        ReportPanel* panel = open(d, QStringLiteral("x*x + y*y + z*z - 1"));
        QVERIFY(panel);
        QCOMPARE(panel->list()->topLevelItemCount(), 0);
        QVERIFY(!panel->goThere()->isEnabled());
        d->editor()->setSceneText(
            QStringLiteral("#version 3.7;\ncamera { location -3*z }\nsphere { 0, 1 }\n"));
        QVERIFY(d.rests(60000));
        QCOMPARE(panel->text()->toPlainText(), QStringLiteral("The scene has no isosurface."));
    }
};

QTEST_MAIN(ReportPanelTest)
#include "report_panel_test.moc"
