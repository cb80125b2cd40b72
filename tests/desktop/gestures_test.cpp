// SPDX-License-Identifier: GPL-3.0-or-later
#include <QAction>
#include <QApplication>
#include <QDockWidget>
#include <QLabel>
#include <QMenu>
#include <QRandomGenerator>
#include <QRegularExpression>
#include <QSlider>
#include <QTest>
#include <QToolButton>

#include "app/desktop/window/actions.h"
#include "app/desktop/window/docks.h"
#include "tests/app/window_driver.h"
#include "tests/desktop/real_input.h"
#include "widgets/editor/scene_editor.h"
#include "widgets/parameters/parameter_panel.h"
#include "widgets/parameters/parameter_slider.h"
#include "widgets/parameters/slider_note_popup.h"
#include "widgets/parameters/slider_player.h"
#include "widgets/section/section_panel.h"
#include "widgets/section/section_view.h"
#include "widgets/viewport/viewport.h"

using namespace isoscope;
using namespace isoscope::test;

/// What tooltips and the shortcut window promise of the mouse, done with real events under a window manager.
class GesturesTest : public QObject {
    Q_OBJECT

    std::unique_ptr<WindowDriver> driver_;
    RealInput hand_;
    QString text_;
    QStringList commands_;  ///< that acted

    Viewport* viewport() const { return driver_->window().viewport(); }
    QPoint middle() const { return viewport()->rect().center(); }
    bool untouched() const {
        return (*driver_)->editor()->sceneText() == text_ && commands_.isEmpty() &&
               !QApplication::activePopupWidget();
    }
    /// Raises the panel and waits until it is drawn.
    QWidget* shown(QDockWidget* dock) const {
        dock->show();
        dock->raise();
        return driver_->rests() ? dock->widget() : nullptr;
    }

  private slots:
    void init() {
        if (!RealInput::available()) QSKIP("needs a display: tests/desktop/with-window-manager PROGRAM");
        driver_ = std::make_unique<WindowDriver>();
        WindowDriver& d = *driver_;
        QVERIFY(QTest::qWaitForWindowActive(&d.window()));
        QVERIFY(d.rests());
        text_ = d->editor()->sceneText();
        commands_.clear();
        for (QAction* action : d->actions()->all())
            connect(action, &QAction::triggered, this, [this, action] { commands_ << action->text(); });
    }

    void cleanup() { driver_.reset(); }

    void rightDragShiftsThePictureAndOpensNoMenu_D1() {
        const Camera before = viewport()->camera();
        hand_.drag(viewport(), middle(), {50, 20}, RealInput::right);
        QTRY_VERIFY(!(viewport()->camera() == before));
        // Shifted, not turned: it looks the same way.
        QVERIFY(glm::length(viewport()->camera().direction - before.direction) < 1e-12);
        QVERIFY(untouched());
    }

    void rightClickOpensTheMenuAtItsRelease_D1() {
        hand_.dragAndHold(viewport(), middle(), {0, 0}, RealInput::right);
        QVERIFY(!QApplication::activePopupWidget());
        hand_.release(RealInput::right);
        QTRY_VERIFY(qobject_cast<QMenu*>(QApplication::activePopupWidget()));
        hand_.key(QStringLiteral("Escape"));
        QTRY_VERIFY(!QApplication::activePopupWidget());
        QVERIFY(untouched());
        QVERIFY(!viewport()->viewMoved());
    }

    void menuKeyOpensTheMenu() {
        viewport()->setFocus();
        hand_.key(QStringLiteral("Menu"));
        QTRY_VERIFY(qobject_cast<QMenu*>(QApplication::activePopupWidget()));
        hand_.key(QStringLiteral("Escape"));
        QTRY_VERIFY(!QApplication::activePopupWidget());
    }

    void dragsOfEveryKindMoveTheView_data() {
        QTest::addColumn<int>("button");
        QTest::addColumn<QString>("held");
        QTest::addColumn<bool>("turns");
        QTest::newRow("left turns") << 1 << QString() << true;
        QTest::newRow("shift and left shifts") << 1 << QStringLiteral("shift") << false;
        QTest::newRow("middle shifts") << 2 << QString() << false;
        QTest::newRow("right shifts") << 3 << QString() << false;
    }
    void dragsOfEveryKindMoveTheView() {
        QFETCH(int, button);
        QFETCH(QString, held);
        QFETCH(bool, turns);
        const Camera before = viewport()->camera();
        hand_.drag(viewport(), middle(), {60, 30}, static_cast<RealInput::Button>(button), held);
        QTRY_VERIFY(!(viewport()->camera() == before));
        QCOMPARE(glm::length(viewport()->camera().direction - before.direction) > 1e-3, turns);
        QVERIFY(untouched());
    }

    void aSliderPlaysUntilItIsTouched_data() {
        QTest::addColumn<bool>("escape");
        QTest::newRow("Escape") << true;
        QTest::newRow("press on the slider") << false;
    }
    void aSliderPlaysUntilItIsTouched() {
        QFETCH(bool, escape);
        WindowDriver& d = *driver_;
        QVERIFY(shown(d->docks()->find("parameters")));
        ParameterSlider* row = d->parameters()->slider(0);
        QToolButton* button = nullptr;
        for (auto* one : row->findChildren<QToolButton*>())
            if (one->accessibleName().startsWith("Play")) button = one;
        QVERIFY(button && button->isVisible());
        hand_.click(button, button->rect().center());
        QTRY_VERIFY(d->parameters()->player()->isPlaying());
        const double first = row->value();
        QTRY_VERIFY(row->value() != first);
        QVERIFY(untouched());
        if (escape) {
            hand_.key(QStringLiteral("Escape"));
        } else {
            auto* handle = row->findChild<QSlider*>();
            hand_.click(handle, handle->rect().center());
        }
        QTRY_VERIFY(!d->parameters()->player()->isPlaying());
        QVERIFY(d->editor()->sceneText() != text_);
        QVERIFY(d.rests());
        d->actions()->undo->trigger();
        if (!escape) d->actions()->undo->trigger();
        QCOMPARE(d->editor()->sceneText(), text_);
    }

    void aRangeIsSetByTheMenuOfItsSlider() {
        WindowDriver& d = *driver_;
        QVERIFY(shown(d->docks()->find("parameters")));
        ParameterSlider* row = d->parameters()->slider(0);
        QToolButton* button = nullptr;
        for (auto* one : row->findChildren<QToolButton*>())
            if (one->accessibleName().startsWith("Menu of")) button = one;
        QVERIFY(button && button->isVisible());
        hand_.click(button, button->rect().center());
        QTRY_VERIFY(qobject_cast<QMenu*>(QApplication::activePopupWidget()));
        const auto chosen = [] {
            const auto* menu = qobject_cast<QMenu*>(QApplication::activePopupWidget());
            return menu && menu->activeAction() ? menu->activeAction()->text() : QString();
        };
        for (int i = 0; i < 8 && !chosen().startsWith("Range"); ++i) hand_.key(QStringLiteral("Down"));
        hand_.key(QStringLiteral("Return"));
        QTRY_VERIFY(qobject_cast<SliderNotePopup*>(QApplication::activePopupWidget()));
        for (const char* key : {"7", "Tab", "9", "Return"}) hand_.key(QString::fromLatin1(key));
        QTRY_VERIFY(!QApplication::activePopupWidget());
        QTRY_VERIFY2(d->editor()->sceneText().contains("// [7:9"), qPrintable(d->editor()->sceneText()));
        QVERIFY(d.rests());
        QCOMPARE(row->note().minimum, 7.0);
        d->actions()->undo->trigger();
        QCOMPARE(d->editor()->sceneText(), text_);
    }

    void wheelZoomsAndDoubleClickResets() {
        hand_.wheel(viewport(), middle() + QPoint(30, 0), 3);
        QTRY_VERIFY(viewport()->viewMoved());
        hand_.doubleClick(viewport(), middle());
        QTRY_VERIFY(!viewport()->viewMoved());
        QVERIFY(untouched());
    }

    void quickStrokesFromOnePlaceAreNoDoubleClick_D20() {
        hand_.drag(viewport(), middle(), {40, 0});
        const Camera once = viewport()->camera();
        hand_.drag(viewport(), middle(), {40, 0});
        QVERIFY(viewport()->viewMoved());
        QVERIFY(!(viewport()->camera() == once));
        // Nor is a double click of another button one.
        hand_.doubleClick(viewport(), middle(), RealInput::middle);
        QVERIFY(viewport()->viewMoved());
    }

    void otherButtonsInADragDoNothing_D1() {
        hand_.dragAndHold(viewport(), middle(), {40, 10});
        hand_.click(viewport(), middle() + QPoint(40, 10), RealInput::right);
        QVERIFY(!QApplication::activePopupWidget());
        const Camera before = viewport()->camera();
        hand_.moveTo(viewport(), middle() + QPoint(90, 10));
        QTRY_VERIFY(!(viewport()->camera() == before));
        hand_.release();
        QVERIFY(untouched());
    }

    void crossSectionIsShiftedZoomedAndSeenWhole() {
        WindowDriver& d = *driver_;
        QVERIFY(shown(d->docks()->find("section")));
        SectionView* view = d->study<SectionPanel>()->view();
        QTRY_COMPARE(view->frame().size(), view->size());
        const QPoint at = view->rect().center() - QPoint(view->width() / 8, 0);
        // Where the mouse rests matters: it has a crosshair.
        hand_.moveTo(view, at);
        QVERIFY(d.rests());
        const QImage home = view->frame().copy();
        hand_.drag(view, at, {25, 10});
        QVERIFY(d.rests());
        QTRY_VERIFY(difference(view->frame(), home) > 0.005);
        hand_.doubleClick(view, at);
        QTRY_VERIFY(d.rests() && difference(view->frame(), home) < 0.001);
        hand_.wheel(view, at, 3);
        QTRY_VERIFY(d.rests() && difference(view->frame(), home) > 0.005);
        QVERIFY(untouched());
    }

    void doubleClickOnAParametersNameBringsItsFirstValueBack() {
        WindowDriver& d = *driver_;
        const int index = d.parameter(QStringLiteral("Radius"));
        ParameterSlider* slider = d->parameters()->slider(index);
        const double first = slider->value();
        d.drag(index, 30);
        QVERIFY(slider->value() != first);
        hand_.doubleClick(slider->findChild<QLabel*>(), {12, 6});
        QTRY_COMPARE(d->parameters()->slider(d.parameter(QStringLiteral("Radius")))->value(), first);
        QCOMPARE(d->editor()->sceneText(), text_);
    }

    /// Any button, any way, anywhere: a drag may move what is under it, but it is never a command, and what
    /// changes no number leaves the text alone.
    void dragsAreNeverCommands_D1() {
        WindowDriver& d = *driver_;
        const quint32 seed = QRandomGenerator::global()->generate();
        qInfo("seed %u", seed);
        QRandomGenerator random(seed);
        const QList<QDockWidget*> docks = {d->docks()->find("section"), d->docks()->find("histogram"),
                                           d->docks()->find("accuracy"), d->docks()->find("ray"),
                                           d->docks()->find("problems")};
        for (int i = 0; i < 24; ++i) {
            QWidget* area = viewport();
            if (i % 2 == 1) {
                QDockWidget* dock = docks[static_cast<int>(random.bounded(docks.size()))];
                QVERIFY(shown(dock));
                area = dock->widget();
                // Combo boxes, buttons and sliders do what they say; the areas with gestures lie in the
                // middle.
                const QList<QWidget*> views =
                    area->findChildren<QWidget*>(QRegularExpression(QStringLiteral("^(section|chart).*")));
                if (!views.isEmpty()) area = views.first();
            }
            const QPoint from = area->rect().center();
            const QPoint by(static_cast<int>(random.bounded(140)) - 70,
                            static_cast<int>(random.bounded(80)) - 40);
            const auto button = static_cast<RealInput::Button>(2 + random.bounded(2));
            hand_.drag(area, from, by.manhattanLength() < 8 ? QPoint(20, 20) : by, button);
            QTest::qWait(30);
            QVERIFY2(untouched(), qPrintable(QStringLiteral("button %1 over %2, by %3, %4: %5")
                                                 .arg(button)
                                                 .arg(area->metaObject()->className())
                                                 .arg(by.x())
                                                 .arg(by.y())
                                                 .arg(commands_.join(QLatin1String(", ")))));
        }
    }
};

QTEST_MAIN(GesturesTest)
#include "gestures_test.moc"
