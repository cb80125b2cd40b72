// SPDX-License-Identifier: GPL-3.0-or-later
#include <QAction>
#include <QDockWidget>
#include <QRandomGenerator>
#include <QSlider>
#include <QTest>

#include "app/desktop/files/document_controller.h"
#include "app/desktop/files/history_keeper.h"
#include "app/desktop/window/actions.h"
#include "app/desktop/window/docks.h"
#include "tests/app/window_driver.h"
#include "widgets/document/scene_session.h"
#include "widgets/editor/edit_history.h"
#include "widgets/editor/scene_editor.h"
#include "widgets/notice_bar.h"
#include "widgets/numbers/undo_group.h"
#include "widgets/parameters/parameter_panel.h"
#include "widgets/parameters/parameter_slider.h"
#include "widgets/section/section_panel.h"
#include "widgets/viewport/viewport.h"

using namespace isoscope;
using namespace isoscope::test;

namespace {

quint32 testSeed() {
    const int asked = qEnvironmentVariableIntValue("ISOSCOPE_SOAK_SEED");
    return asked > 0 ? static_cast<quint32>(asked) : QRandomGenerator::global()->generate() & 0x7fffffff;
}

}  // namespace

/// One history for text, sliders, view and section plane.
class HistoryTest : public QObject {
    Q_OBJECT

    std::unique_ptr<WindowDriver> driver_;

    struct State {
        QString text;
        OrbitView::State view;
        SectionPanel::State plane;

        friend bool operator==(const State&, const State&) = default;
    };

    State state() const {
        WindowDriver& d = *driver_;
        return {d->editor()->sceneText(), d->viewport()->view(), d->study<SectionPanel>()->state()};
    }
    void undo() const { (*driver_)->actions()->undo->trigger(); }
    void redo() const { (*driver_)->actions()->redo->trigger(); }
    QPoint middle() const { return (*driver_)->viewport()->rect().center(); }
    void settle() const { QTest::qWait(UndoGroup::pause + 100); }

  private slots:
    void init() {
        driver_ = std::make_unique<WindowDriver>();
        (*driver_)->docks()->find("section")->show();
        (*driver_)->docks()->find("section")->raise();
        QVERIFY(driver_->rests());
    }
    void cleanup() { driver_.reset(); }

    void strayDoubleClickIsUndone_D20() {
        WindowDriver& d = *driver_;
        d.dragViewport(middle(), {80, 20});
        const OrbitView::State turned = d->viewport()->view();
        QTest::mouseClick(d->viewport(), Qt::LeftButton);
        QTest::mouseDClick(d->viewport(), Qt::LeftButton);
        QTest::mouseRelease(d->viewport(), Qt::LeftButton);
        QVERIFY(!d->viewport()->viewMoved());
        undo();
        QVERIFY(d->viewport()->view() == turned);
        undo();
        QVERIFY(!d->viewport()->viewMoved());
        QVERIFY(!d->actions()->undo->isEnabled());
        redo();
        QVERIFY(d->viewport()->view() == turned);
    }

    void oneDragIsOneStep() {
        WindowDriver& d = *driver_;
        const OrbitView::State home = d->viewport()->view();
        d.dragViewport(middle(), {80, 20});
        const OrbitView::State once = d->viewport()->view();
        d.dragViewport(middle(), {-30, 50}, Qt::RightButton);
        undo();
        QVERIFY(d->viewport()->view() == once);
        undo();
        QVERIFY(d->viewport()->view() == home);
        QVERIFY(!d->actions()->undo->isEnabled());
    }

    void viewAndTextGoBackInTheirTrueOrder() {
        WindowDriver& d = *driver_;
        const State first = state();
        d.dragViewport(middle(), {60, 0});
        const State turned = state();
        d.typeBehind(QStringLiteral("#declare Radius = 0."), QStringLiteral("1"));
        const State typed = state();
        d.wheel(d->viewport(), middle(), 120);
        QVERIFY(!(state().view == typed.view));
        const State zoomed = state();
        undo();
        QVERIFY(state() == typed);
        undo();
        QVERIFY(state() == turned);
        undo();
        QVERIFY(state() == first);
        for (const State& next : {turned, typed, zoomed}) {
            redo();
            QVERIFY(state() == next);
        }
        QVERIFY(!d->actions()->redo->isEnabled());
    }

    void anOrbitDoesNotModifyTheText() {
        WindowDriver& d = *driver_;
        QVERIFY(!d->isWindowModified());
        d.dragViewport(middle(), {60, 0});
        QVERIFY(!d->isWindowModified());
        d.typeBehind(QStringLiteral("isosurface {"), QStringLiteral(" "));
        QVERIFY(d->isWindowModified());
        d.dragViewport(middle(), {60, 0});
        undo();
        QVERIFY(d->isWindowModified());
        undo();
        QVERIFY(!d->isWindowModified());
        undo();
        QVERIFY(!d->isWindowModified());
        redo();
        redo();
        QVERIFY(d->isWindowModified());
        // Saved here, another text is the modified one.
        d->editor()->setModified(false);
        QVERIFY(!d->isWindowModified());
        undo();
        QVERIFY(d->isWindowModified());
        d.typeBehind(QStringLiteral("isosurface {"), QStringLiteral(" "));
        QVERIFY(d->isWindowModified());
    }

    void aWrittenViewComesBackMovedAsItWas() {
        WindowDriver& d = *driver_;
        d.dragViewport(middle(), {90, 30});
        const State moved = state();
        d->actions()->writeView->trigger();
        QTRY_VERIFY(!d->session()->busy());
        QVERIFY(d.rests());
        QVERIFY(!d->viewport()->viewMoved());
        undo();
        QCOMPARE(d->editor()->sceneText(), moved.text);
        QTRY_VERIFY(state() == moved);
        QVERIFY(d->viewport()->viewMoved());
    }

    void sectionPlaneIsInTheHistory() {
        WindowDriver& d = *driver_;
        const State first = state();
        d->study<SectionPanel>()->setPosition(0.3);
        settle();
        d->study<SectionPanel>()->setAxis(0);
        settle();
        d->study<SectionPanel>()->turn(30, 20);
        const State free = state();
        undo();
        QCOMPARE(state().plane.axis, 0);
        undo();
        QCOMPARE(state().plane.position, 0.3);
        undo();
        QVERIFY(state() == first);
        redo();
        redo();
        redo();
        QVERIFY(state() == free);
    }

    void newDocumentHasNoHistory() {
        WindowDriver& d = *driver_;
        d.dragViewport(middle(), {60, 0});
        d.typeBehind(QStringLiteral("isosurface {"), QStringLiteral(" "));
        d->showTutorial();
        QVERIFY(d.rests());
        QVERIFY(!d->actions()->undo->isEnabled());
        QVERIFY(!d->actions()->redo->isEnabled());
    }

    /// Random steps of all kinds beside a list of the states: undo and redo walk along that list.
    void textAndViewGoBackAfterARestart() {
        WindowDriver& d = *driver_;
        QVERIFY(
            d.openText("#declare Radius = 0.5;\ncamera { location -3*z look_at 0 }\n"
                       "sphere { 0, Radius pigment { rgb 1 } }\n"));
        QVERIFY(d.rests());
        const OrbitView::State home = d->viewport()->view();
        d.typeBehind(QStringLiteral("Radius = 0."), QStringLiteral("1"));
        settle();
        d.dragViewport(middle(), {60, 0});
        settle();
        const OrbitView::State turned = d->viewport()->view();
        d.typeBehind(QStringLiteral("rgb "), QStringLiteral("0."));
        const QString last = d->editor()->sceneText();
        WindowDriver::trigger(d->actions()->save);
        const QString file = d->documents()->document()->filePath();
        d.restart();
        QVERIFY(d->documents()->openFile(file));
        QVERIFY(d.rests());
        QCOMPARE(d->editor()->sceneText(), last);
        QVERIFY(!d->editor()->isModified());
        undo();
        QVERIFY(d->editor()->sceneText().contains(QStringLiteral("rgb 1 ")));
        QVERIFY(d->editor()->isModified());
        undo();
        QVERIFY(d.rests());
        QVERIFY(glm::distance(d->viewport()->view().camera.location, home.camera.location) < 1e-12);
        redo();
        QVERIFY(glm::distance(d->viewport()->view().camera.location, turned.camera.location) < 1e-12);
        undo();
        undo();
        QVERIFY(d->editor()->sceneText().contains(QStringLiteral("Radius = 0.5;")));
        QVERIFY(!d->actions()->undo->isEnabled());
    }

    void theStepsOfAKeptTextComeBackAfterACrash() {
        WindowDriver& d = *driver_;
        QVERIFY(d.openText("sphere { 0, 1 pigment { rgb 1 } }\n"));
        d.typeBehind(QStringLiteral("0, 1"), QStringLiteral(".25"));
        settle();
        d.typeBehind(QStringLiteral("rgb "), QStringLiteral("0."));
        const QString last = d->editor()->sceneText();
        QTest::qWait(HistoryKeeper::pause + 300);
        d.crash();
        d->documents()->offerRecovery();
        QVERIFY(d.press(d->notices(), QStringLiteral("Bring Back")));
        QCOMPARE(d->editor()->sceneText(), last);
        QVERIFY(d->editor()->isModified());
        undo();
        QVERIFY(d->editor()->sceneText().contains(QStringLiteral("0, 1.25 pigment { rgb 1 }")));
        undo();
        QCOMPARE(d->editor()->sceneText(), QStringLiteral("sphere { 0, 1 pigment { rgb 1 } }\n"));
        QVERIFY(!d->editor()->isModified());
    }

    void randomStepsGoBackAndForth() {
        WindowDriver& d = *driver_;
        const quint32 seed = testSeed();
        qInfo("seed %u (ISOSCOPE_SOAK_SEED)", seed);
        QRandomGenerator random(seed);
        const auto upTo = [&](int bound) { return static_cast<int>(random.bounded(bound)); };
        QList<State> states{state()};
        int at = 0;
        const auto compare = [&](const QString& what) {
            const bool same = QTest::qWaitFor([&] { return state() == states[at]; }, 10000);
            const State now = state();
            QVERIFY2(same, qPrintable(QStringLiteral("%1: text %2, view %3, plane %4")
                                          .arg(what)
                                          .arg(now.text == states[at].text)
                                          .arg(now.view == states[at].view)
                                          .arg(now.plane == states[at].plane)));
        };
        for (int i = 0; i < 60; ++i) {
            const int kind = upTo(9);
            if (kind < 4) {
                const bool back = upTo(3) > 0;
                const int steps = 1 + upTo(4);
                for (int j = 0; j < steps; ++j) {
                    if (back ? at == 0 : at == states.size() - 1) break;
                    back ? undo() : redo();
                    at += back ? -1 : 1;
                    compare(QStringLiteral("%1, %2").arg(i).arg(back ? "undo" : "redo"));
                    if (QTest::currentTestFailed()) return;
                }
                continue;
            }
            // A step begins from rest: what a scene changes by itself has happened by then.
            QTRY_VERIFY(!d->session()->busy());
            QVERIFY(d.rests());
            settle();
            switch (kind) {
                case 4: d.dragViewport(middle(), {upTo(100) - 120, upTo(60) + 8}); break;
                case 5: d.wheel(d->viewport(), middle(), upTo(2) ? 120 : -240); break;
                case 6: d.typeBehind(QStringLiteral("isosurface {"), QStringLiteral(" ")); break;
                case 7: {
                    const int radius = d.parameter(QStringLiteral("Radius"));
                    if (radius < 0) continue;
                    d.drag(radius, upTo(2) ? 15 + upTo(20) : -15 - upTo(20));
                    break;
                }
                default: d->study<SectionPanel>()->setPosition((upTo(100) - 50) / 100.0 + 0.001 * i); break;
            }
            settle();
            const State now = state();
            if (now == states[at]) continue;
            while (states.size() > at + 1) states.removeLast();
            states << now;
            ++at;
        }
        while (at > 0) {
            undo();
            --at;
            compare(QStringLiteral("to the beginning"));
            if (QTest::currentTestFailed()) return;
        }
        QVERIFY(!d->actions()->undo->isEnabled());
        QVERIFY(!d->isWindowModified());
        qInfo("%lld states", static_cast<long long>(states.size()));
    }
};

QTEST_MAIN(HistoryTest)
#include "history_test.moc"
