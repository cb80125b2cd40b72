// SPDX-License-Identifier: GPL-3.0-or-later
#include <QLabel>
#include <QPushButton>
#include <QSignalSpy>
#include <QTest>
#include <QToolButton>
#include <QTreeWidget>

#include "app/desktop/editing/preview_light.h"
#include "app/desktop/editing/quick_fixer.h"
#include "tests/app/window_driver.h"
#include "widgets/document/scene_session.h"
#include "widgets/editor/include_viewer.h"
#include "widgets/editor/scene_editor.h"
#include "widgets/notice_bar.h"
#include "widgets/verdicts/problems_panel.h"
#include "widgets/viewport/viewport.h"

using namespace isoscope;
using test::WindowDriver;

/// Problems in the window: what they say, where they lead, and what they do about themselves.
class ProblemsWindowTest : public QObject {
    Q_OBJECT

    std::unique_ptr<WindowDriver> driver_;

    MainWindow& window() const { return driver_->window(); }
    QTreeWidget* list() const { return window().problems()->findChild<QTreeWidget*>(); }
    QString text() const { return window().editor()->sceneText(); }

    /// As if it had been typed: with an undo step.
    void type(const QString& text) const {
        window().editor()->selectAll();
        window().editor()->replaceSelectedText(text);
        QVERIFY(driver_->rests());
    }

    QPushButton* noticeButton(const QString& label) const {
        for (QPushButton* button : window().textNotices()->findChildren<QPushButton*>())
            if (button->text() == label && button->isVisible()) return button;
        return nullptr;
    }

    QToolButton* fixButton(const QString& label) const {
        for (QToolButton* button : list()->findChildren<QToolButton*>())
            if (button->text() == label) return button;
        return nullptr;
    }

  private slots:
    void init() { driver_ = std::make_unique<WindowDriver>(); }
    void cleanup() { driver_.reset(); }

    /// D30.
    void aWrongWordIsReplacedInOneStep() {
        const QString wrong = "// ä\nisosurface { functon { x*x + y*y + z*z - 1 } pigment { rgb 1 } }\n";
        type(wrong);
        QTRY_VERIFY(fixButton("Use “function”"));
        fixButton("Use “function”")->click();
        QCOMPARE(text(), QString(wrong).replace("functon", "function"));
        QVERIFY(driver_->rests());
        QTRY_VERIFY(!fixButton("Use “function”"));
        window().editor()->undo();
        QCOMPARE(text(), wrong);
    }

    void allOfAKindAreReplacedInOneStep() {
        const QString wrong = "sphere { 0, 1 pigmet { rgb 1 } }\nbox { -1, 1 pigmet { rgb 1 } }\n";
        type(wrong);
        QTRY_VERIFY(fixButton("Fix All 2"));
        // Text that comes before the places moves them.
        window().editor()->insertAt("// more\n", 0, 0);
        fixButton("Fix All 2")->click();
        QCOMPARE(text(), "// more\n" + QString(wrong).replace("pigmet", "pigment"));
        window().editor()->undo();
        QCOMPARE(text(), "// more\n" + wrong);
    }

    void placesAreFollowedOrLeftAlone() {
        const SourceRange range{0, 4, 7};
        QCOMPARE(followed(range, "one two", "one two three"), range);
        QCOMPARE(followed(range, "one two", "a one two"), (SourceRange{0, 6, 9}));
        QVERIFY(!followed(range, "one two", "one twx"));
        QVERIFY(!followed({1, 0, 1}, "one", "one"));
        QVERIFY(!followed({0, 5, 9}, "one", "one"));
    }

    /// D16: places in include files could not be opened.
    void placesInIncludesOpenThere() {
        QTreeWidgetItem* place = nullptr;
        type("#include \"transforms.inc\"\nsphere { 0, 1 Axis_Rotate_Trans(\"a\", 3) pigment { rgb 1 } }\n");
        QTRY_VERIFY(list()->topLevelItemCount() > 0);
        for (QTreeWidgetItemIterator it(list()); *it; ++it)
            if ((*it)->text(1).startsWith("transforms.inc:")) place = *it;
        QVERIFY(place);
        emit list()->itemActivated(place, 0);
        IncludeViewer* viewer = window().includes();
        QVERIFY(viewer->isVisible());
        QVERIFY(viewer->fileName().endsWith("transforms.inc"));
        QVERIFY(!viewer->selectedText().isEmpty());
        const QString before = text();
        QTest::keyClicks(viewer->focusWidget(), "abc");
        QTest::keyClick(viewer->focusWidget(), Qt::Key_Escape);
        QVERIFY(!viewer->isVisible());
        QCOMPARE(text(), before);
        QVERIFY(window().editor()->isVisible());
    }

    /// D31.
    void aFormulaBecomesAnIsosurface() {
        const QString formula = "x^2 + y^2 + z^2 = 1";
        type(formula);
        QTRY_VERIFY(noticeButton("Make It an Isosurface"));
        QCOMPARE(list()->topLevelItemCount(), 1);
        noticeButton("Make It an Isosurface")->click();
        QVERIFY(driver_->rests());
        QVERIFY(text().contains("function { x*x + y*y + z*z - 1 }"));
        QVERIFY(text().contains("camera"));
        QTRY_COMPARE(list()->topLevelItemCount(), 0);
        QVERIFY(test::distinctColors(driver_->picture()) > 20);
        QVERIFY(!window().textNotices()->isVisible());
        window().editor()->undo();
        QCOMPARE(text(), formula);
    }

    void inASceneOnlyTheFormulaIsReplaced() {
        const QString scene = "camera { location -5*z look_at 0 }\nlight_source { -9*z rgb 1 }\n";
        type(scene + "|x| + |y| + |z| = 1\n");
        QTRY_VERIFY(noticeButton("Make It an Isosurface"));
        noticeButton("Make It an Isosurface")->click();
        QVERIFY2(text().startsWith(scene + "isosurface {"), qPrintable(text()));
        QCOMPARE(text().count("camera"), 1);
    }

    /// D17.
    void whatIsBlackCanBeLit() {
        type("camera { location -3*z look_at 0 }\nlight_source { -5*z rgb 1 }\nsphere { 0, 1 }\n");
        QTRY_VERIFY(noticeButton("Light It in the Preview"));
        QCOMPARE(test::distinctColors(driver_->picture()), 1);
        noticeButton("Light It in the Preview")->click();
        QVERIFY(driver_->rests());
        QTRY_VERIFY(test::distinctColors(driver_->picture()) > 20);
        QVERIFY(fixButton("Add a Pigment"));
        // Exports and panels have the scene of the text.
        QVERIFY(std::get<SolidPigment>(window().session()->scene()->materials.front().pigment).color.red ==
                0);
        QVERIFY(window().previewLight()->isOn());
    }

    /// D30: raw backticks in what a person reads.
    void noBackticksAreSeen() {
        type("isosurface { functon { x } }\nfoo\nsphere { 0, 1 photons { target } }\n");
        QTRY_VERIFY(list()->topLevelItemCount() > 2);
        for (QTreeWidgetItemIterator it(list()); *it; ++it)
            for (const QString& shown :
                 {(*it)->text(0), (*it)->toolTip(0), (*it)->data(0, Qt::AccessibleTextRole).toString()})
                QVERIFY2(!shown.contains('`'), qPrintable(shown));
        for (QToolButton* button : list()->findChildren<QToolButton*>())
            QVERIFY(!button->text().contains('`'));
    }
};

QTEST_MAIN(ProblemsWindowTest)
#include "problems_window_test.moc"
