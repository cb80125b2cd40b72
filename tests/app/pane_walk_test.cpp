// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/desktop/window/pane_walk.h"

#include <QAbstractItemView>
#include <QComboBox>
#include <QDockWidget>
#include <QHeaderView>
#include <QLineEdit>
#include <QSlider>
#include <QTabBar>
#include <QToolBar>
#include <QToolButton>

#include "app/desktop/window/actions.h"
#include "app/desktop/window/docks.h"
#include "tests/app/window_driver.h"
#include "widgets/editor/scene_editor.h"
#include "widgets/parameters/parameter_panel.h"
#include "widgets/viewport/viewport.h"

using namespace isoscope;
using namespace isoscope::test;

/// F6 and Shift+F6 go from pane to pane.
class PaneWalkTest : public QObject {
    Q_OBJECT

    std::unique_ptr<WindowDriver> driver_;

    static void press(bool forward) {
        QTest::keyClick(QApplication::focusWidget(), Qt::Key_F6,
                        forward ? Qt::NoModifier : Qt::ShiftModifier);
        QCoreApplication::processEvents();
    }
    QList<QWidget*> panes() const {
        return PaneWalk(&driver_->window(), (*driver_)->docks(), (*driver_)->viewport()).panes();
    }
    static QWidget* paneOf(const QList<QWidget*>& all) {
        for (QWidget* pane : all)
            if (QWidget* focus = QApplication::focusWidget(); pane == focus || pane->isAncestorOf(focus))
                return pane;
        return nullptr;
    }

  private slots:
    void init() {
        driver_ = std::make_unique<WindowDriver>();
        QVERIFY(driver_->rests());
        driver_->window().activateWindow();
        (*driver_)->editor()->setFocus();
        QTRY_VERIFY((*driver_)->editor()->hasFocus());
    }
    void cleanup() { driver_.reset(); }

    void everyPaneIsReachedInBothDirections() {
        const QList<QWidget*> all = panes();
        QVERIFY(all.contains((*driver_)->viewport()));
        QVERIFY(all.contains((*driver_)->docks()->find("editor")));
        QVERIFY(
            std::any_of(all.begin(), all.end(), [](auto* pane) { return qobject_cast<QToolBar*>(pane); }));
        // Text, Parameters, picture and two tool bars; a low window folds what is below the picture.
        QVERIFY(all.size() >= 5);
        for (const bool forward : {true, false}) {
            (*driver_)->editor()->setFocus();
            QList<QWidget*> met;
            for (qsizetype i = 0; i < all.size(); ++i) {
                press(forward);
                met << paneOf(all);
            }
            QCOMPARE(met.last(), static_cast<QWidget*>((*driver_)->docks()->find("editor")));
            if (!forward) std::reverse(met.begin(), met.end() - 1);
            QCOMPARE(met, all.mid(1) << all.first());
        }
    }

    void aPaneHasTheFocusWhereItWas() {
        auto* filter = (*driver_)->parameters()->findChild<QLineEdit*>();
        filter->setFocus();
        QTRY_VERIFY(filter->hasFocus());
        press(true);
        QVERIFY(!filter->hasFocus());
        press(false);
        QVERIFY(filter->hasFocus());
    }

    void thePaneIsMarkedUntilTheFocusLeaves() {
        WindowDriver& d = *driver_;
        QWidget* pane = nullptr;
        for (int i = 0; i < 20 && pane != d->viewport(); ++i) {
            press(true);
            pane = paneOf(panes());
        }
        QCOMPARE(pane, static_cast<QWidget*>(d->viewport()));
        const QColor mark = pane->palette().color(QPalette::Highlight);
        QCOMPARE(pane->grab().toImage().pixelColor(pane->width() / 2, 1), mark);
        d.window().resize(d.window().size() + QSize(40, 40));
        QTRY_COMPARE(pane->grab().toImage().pixelColor(pane->width() - 1, pane->height() / 2), mark);
        d->editor()->setFocus();
        QVERIFY(pane->grab().toImage().pixelColor(pane->width() / 2, 1) != mark);
    }

    void arrowsGoAlongAToolBar() {
        // The badge in the status line is such a button, too.
        const auto inBar = [] {
            return qobject_cast<QToolBar*>(QApplication::focusWidget()->parentWidget());
        };
        for (int i = 0; i < 20 && !inBar(); ++i) press(false);
        auto* first = qobject_cast<QToolButton*>(QApplication::focusWidget());
        QVERIFY(first);
        QTest::keyClick(first, Qt::Key_Right);
        auto* second = qobject_cast<QToolButton*>(QApplication::focusWidget());
        QVERIFY(second && second != first);
        QCOMPARE(second->parentWidget(), first->parentWidget());
        QVERIFY(second->x() > first->x());
        const QColor mark = second->palette().color(QPalette::Highlight);
        QCOMPARE(second->grab().toImage().pixelColor(second->width() / 2, 1), mark);
        QVERIFY(first->grab().toImage().pixelColor(first->width() / 2, 1) != mark);
        QTest::keyClick(second, Qt::Key_Left);
        QVERIFY(first->hasFocus());
        int runs = 0;
        connect(first, &QToolButton::clicked, this, [&] { ++runs; });
        disconnect(first->defaultAction(), &QAction::triggered, nullptr, nullptr);
        QTest::keyClick(first, Qt::Key_Space);
        QCOMPARE(runs, 1);
    }

    void panelsBelowThePictureAreReached() {
        WindowDriver& d = *driver_;
        d.window().resize(1280, 1100);
        QDockWidget* section = d->docks()->find("section");
        QTRY_VERIFY(panes().contains(section));
        QVERIFY(!panes().contains(d->docks()->find("accuracy")));
        for (qsizetype i = panes().size(); i > 0 && paneOf(panes()) != section; --i) press(true);
        QCOMPARE(paneOf(panes()), static_cast<QWidget*>(section));
    }

    void panelsThatAreNotSeenArePassed() {
        WindowDriver& d = *driver_;
        QDockWidget* hidden = d->docks()->find("parameters");
        QVERIFY(panes().contains(hidden));
        hidden->hide();
        QTRY_VERIFY(!panes().contains(hidden));
    }

    /// Whatever can be clicked can have the focus by Tab: but for tool bars, where arrows lead, the titles of
    /// panels, whose buttons are in View, Panels as well, and parts of other controls.
    void everyControlTakesTheFocus() {
        WindowDriver& d = *driver_;
        d.window().resize(1280, 1100);
        QStringList wrong;
        for (QDockWidget* dock : d->docks()->all()) {
            d->docks()->bringUp(dock);
            QTest::qWait(20);
            for (const QWidget* widget : d.window().findChildren<QWidget*>()) {
                const QWidget* parent = widget->parentWidget();
                const bool part =
                    qobject_cast<const QToolBar*>(parent) || qobject_cast<const QDockWidget*>(parent) ||
                    qobject_cast<const QTabBar*>(parent) || qobject_cast<const QLineEdit*>(parent) ||
                    qobject_cast<const QAbstractItemView*>(parent);
                const bool clicked =
                    qobject_cast<const QAbstractButton*>(widget) || qobject_cast<const QComboBox*>(widget) ||
                    qobject_cast<const QSlider*>(widget) || qobject_cast<const QAbstractItemView*>(widget);
                if (clicked && !part && widget->isVisible() && widget->isEnabled() &&
                    !qobject_cast<const QHeaderView*>(widget) && !(widget->focusPolicy() & Qt::TabFocus))
                    wrong << QStringLiteral("%1 “%2” in %3")
                                 .arg(widget->metaObject()->className(), widget->accessibleName(),
                                      parent->metaObject()->className());
            }
        }
        wrong.removeDuplicates();
        QVERIFY2(wrong.isEmpty(), qPrintable(wrong.join('\n')));
    }
};

QTEST_MAIN(PaneWalkTest)
#include "pane_walk_test.moc"
