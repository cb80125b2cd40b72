// SPDX-License-Identifier: GPL-3.0-or-later
#include <QAbstractSpinBox>
#include <QAction>
#include <QComboBox>
#include <QDockWidget>
#include <QLineEdit>
#include <QMenu>
#include <QSignalSpy>
#include <QStatusBar>
#include <QTest>
#include <QToolButton>

#include "app/desktop/editing/timeline_controller.h"
#include "app/desktop/window/actions.h"
#include "app/desktop/window/docks.h"
#include "tests/app/window_driver.h"
#include "widgets/document/scene_session.h"
#include "widgets/editor/edit_history.h"
#include "widgets/editor/scene_editor.h"
#include "widgets/parameters/parameter_panel.h"
#include "widgets/parameters/parameter_slider.h"
#include "widgets/timeline/timeline_panel.h"
#include "widgets/timeline/timeline_view.h"
#include "widgets/viewport/viewport.h"

using namespace isoscope;
using namespace isoscope::test;

namespace {

const QByteArray scene =
    "#declare R = 0.5; // [0.2:1]\n"
    "#declare Count = 2; // [1:6:1]\n"
    "camera { location <0, 0, -4> look_at 0 }\nlight_source { <5, 5, -5> 1 }\n"
    "isosurface { function { f_sphere(x, y, z, R) } contained_by { box { -1.1, 1.1 } } pigment { rgb 1 } }\n"
    "#for (I, 1, Count) sphere { <I/3, 1.2, 0>, 0.15 pigment { rgb 1 } } #end\n";
const QByteArray frames = "// timeline: frames 0 to 40, clock 0 to 1, 20 per second\n";
const QByteArray keysOfR = "// keys \"R\": 0 = 0.3 linear, 40 = 0.9\n";

}  // namespace

/// The timeline in the real window.
class TimelineWindowTest : public QObject {
    Q_OBJECT

    std::unique_ptr<WindowDriver> driver_;

    MainWindow& window() const { return driver_->window(); }
    TimelinePanel* panel() const { return window().timelinePanel(); }
    TimelineView* view() const { return panel()->view(); }
    QString text() const { return window().editor()->sceneText(); }
    void undo() const { window().actions()->undo->trigger(); }
    double value(const char* name) const {
        return window().parameters()->slider(driver_->parameter(name))->value();
    }
    bool open(const QByteArray& text) const {
        if (!driver_->openText(text)) return false;
        QDockWidget* dock = window().docks()->find("timeline");
        window().docks()->bringUp(dock);
        return driver_->rests();
    }
    /// A press at one frame, moves, and the release at another.
    void drag(int from, int to, int row = -1, const std::function<void()>& midway = {}) const {
        const auto place = [&](int frame) {
            return row < 0 ? QPoint(view()->placeOf(frame, 0).x(), 4) : view()->placeOf(frame, row);
        };
        QTest::mousePress(view(), Qt::LeftButton, {}, place(from));
        for (int i = 1; i <= 10; ++i) {
            const QPoint at = place(from) + (place(to) - place(from)) * i / 10;
            QMouseEvent move(QEvent::MouseMove, at, view()->mapToGlobal(at), Qt::NoButton, Qt::LeftButton,
                             {});
            QApplication::sendEvent(view(), &move);
            if (i == 5 && midway) midway();
        }
        QTest::mouseRelease(view(), Qt::LeftButton, {}, place(to));
    }
    bool chooseKey(const QString& entry) const {
        emit panel()->keyMenu()->aboutToShow();
        for (QAction* action : panel()->keyMenu()->actions())
            if (action->text() == entry) {
                action->trigger();
                return true;
            }
        return false;
    }
    bool type(const QString& box, const QString& number) const {
        for (auto* spin : panel()->findChildren<QAbstractSpinBox*>()) {
            if (spin->accessibleName() != box) continue;
            spin->setFocus();
            spin->selectAll();
            QTest::keyClicks(spin, number);
            QTest::keyClick(spin, Qt::Key_Return);
            return true;
        }
        return false;
    }

  private slots:
    void init() { driver_ = std::make_unique<WindowDriver>(); }
    void cleanup() { driver_.reset(); }

    void aDragToAFrameIsOneStep() {
        QVERIFY(open(scene + frames + keysOfR));
        const QString before = text();
        const QImage first = driver_->picture();
        const quint64 revision = window().editor()->revision();
        QSignalSpy parsed(window().session(), &SceneSession::parsed);
        drag(0, 40, -1, [&] {
            // Half way the picture and the slider follow, while neither text nor parser hear of it.
            QVERIFY(value("R") > 0.5 && value("R") < 0.8);
            QCOMPARE(window().editor()->revision(), revision);
            QCOMPARE(parsed.count(), 0);
            QVERIFY(!window().isWindowModified());
        });
        QVERIFY(driver_->rests());
        QCOMPARE(driver_->numberBehind("#declare R = "), 0.9);
        QCOMPARE(panel()->frame(), 40);
        QVERIFY(difference(first, driver_->picture()) > 0.02);
        undo();
        QCOMPARE(text(), before);
        QVERIFY(!window().actions()->undo->isEnabled());
        QCOMPARE(panel()->frame(), 0);
        QVERIFY(driver_->rests());
        QVERIFY(difference(first, driver_->picture()) < 0.001);
        window().actions()->redo->trigger();
        QCOMPARE(driver_->numberBehind("#declare R = "), 0.9);
        QCOMPARE(panel()->frame(), 40);
    }

    void aPlayIsOneStepAndReadsNoText() {
        QVERIFY(open(scene + frames + keysOfR));
        const QString before = text();
        const quint64 serial = window().editor()->history()->serial();
        QSignalSpy parsed(window().session(), &SceneSession::parsed);
        QSignalSpy changed(window().session(), &SceneSession::sceneChanged);
        QSignalSpy moving(window().timeline(), &TimelineController::movingChanged);
        emit panel()->playRequested(true);
        QVERIFY(window().timeline()->isPlaying());
        QTRY_VERIFY_WITH_TIMEOUT(changed.count() >= 8, 20000);
        QCOMPARE(parsed.count(), 0);
        QCOMPARE(window().editor()->history()->serial(), serial);
        QCOMPARE(text(), before);
        QTest::keyClick(window().editor(), Qt::Key_Escape);
        QVERIFY(!window().timeline()->isPlaying());
        QCOMPARE(moving.count(), 2);
        const int frame = panel()->frame();
        QVERIFY(std::abs(driver_->numberBehind("#declare R = ") - (0.3 + 0.6 * frame / 40)) < 1e-9);
        QVERIFY(driver_->rests());
        undo();
        QCOMPARE(text(), before);
        QVERIFY(!window().actions()->undo->isEnabled());
        QVERIFY(driver_->rests());
    }

    void aPlayThatDoesNotRepeatEndsAtTheLastFrame() {
        QVERIFY(open(scene + "// timeline: frames 3 to 9, 60 per second\n" +
                     "// keys \"R\": 3 = 0.3, 9 = 0.9\n"));
        for (auto* button : panel()->findChildren<QToolButton*>())
            if (button->accessibleName() == "Repeat") button->click();
        emit panel()->playRequested(true);
        QTRY_VERIFY_WITH_TIMEOUT(!window().timeline()->isPlaying(), 20000);
        QCOMPARE(panel()->frame(), 9);
        QCOMPARE(driver_->numberBehind("#declare R = "), 0.9);
    }

    /// Numbers without a slot, and clock, ask for a parse of each frame; the text stays all the same.
    void clockAndStructureFollowByParses() {
        QVERIFY(open(scene + "sphere { <clock - 0.5, -1.2, 0>, 0.2 pigment { rgb 1 } }\n" + frames +
                     "// keys \"Count\": 0 = 1 hold, 20 = 5\n"));
        const QImage first = driver_->picture();
        drag(0, 30);
        QVERIFY(driver_->rests());
        QCOMPARE(driver_->numberBehind("#declare Count = "), 5.0);
        QCOMPARE(window().session()->scene()->objects.size(), 7u);
        QCOMPARE(window().session()->result()->options.clock, 0.75);
        QCOMPARE(window().session()->result()->options.frameNumber, 30);
        const QImage there = driver_->picture();
        QVERIFY(difference(first, there) > 0.002);
        undo();
        QVERIFY(driver_->rests());
        QCOMPARE(window().session()->result()->options.clock, 0.0);
        QVERIFY(difference(there, driver_->picture()) > 0.002);
        emit panel()->playRequested(true);
        QSignalSpy changed(window().session(), &SceneSession::sceneChanged);
        QTRY_VERIFY_WITH_TIMEOUT(changed.count() >= 4, 20000);
        undo();
        QVERIFY(!window().timeline()->isPlaying());
        QCOMPARE(driver_->numberBehind("#declare Count = "), 2.0);
        QVERIFY(driver_->rests());
    }

    void keysAreSetByMenuAndSlider() {
        QVERIFY(open(scene));
        QVERIFY(chooseKey("R"));
        QCOMPARE(text().toUtf8(), scene +
                                      "// timeline: frames 0 to 119, clock 0 to 1, 30 per second\n"
                                      "// keys \"R\": 0 = 0.5\n");
        QVERIFY(driver_->rests());
        QCOMPARE(view()->rows().size(), 1u);
        view()->setFocus();
        QTest::keyClick(view(), Qt::Key_End);
        QVERIFY(driver_->rests());
        driver_->drag(driver_->parameter("R"), 40);
        QVERIFY(driver_->rests());
        const double moved = value("R");
        QVERIFY(moved > 0.5);
        emit window().parameters()->slider(driver_->parameter("R"))->keyRequested();
        QCOMPARE(driver_->numberBehind("// keys \"R\": 0 = 0.5, 119 = "), moved);
        const QString both = text();
        undo();
        QVERIFY(!text().contains("119 = "));
        window().actions()->redo->trigger();
        QCOMPARE(text(), both);
        // Nothing differs from its keys now; a slider that was moved does.
        QVERIFY(chooseKey("What differs from its keys"));
        QCOMPARE(text(), both);
        QVERIFY(window().statusBar()->currentMessage().contains("Nothing differs"));
        driver_->drag(driver_->parameter("R"), -30);
        QVERIFY(chooseKey("What differs from its keys"));
        QCOMPARE(driver_->numberBehind("119 = "), value("R"));
        QVERIFY(value("R") < moved);
    }

    void theViewGetsKeysAndFollowsThem() {
        QVERIFY(open(scene + frames));
        QVERIFY(chooseKey("View"));
        QVERIFY(driver_->rests());
        QCOMPARE(driver_->numberBehind("// keys \"camera azimuth\": 0 = "), 0.0);
        QCOMPARE(driver_->numberBehind("// keys \"camera distance\": 0 = "), 4.0);
        QVERIFY(!text().contains("camera angle"));
        QCOMPARE(view()->rows().size(), 1u);
        QCOMPARE(view()->rows()[0].title, QString("Camera"));
        view()->setFocus();
        QTest::keyClick(view(), Qt::Key_End);
        QVERIFY(driver_->rests());
        driver_->dragViewport({200, 150}, {120, 0});
        QVERIFY(driver_->rests());
        const glm::dvec3 there = window().viewport()->camera().location;
        QVERIFY(chooseKey("View"));
        QVERIFY(driver_->rests());
        const QString keyed = text();
        const QImage last = driver_->picture();
        drag(40, 0);
        QVERIFY(driver_->rests());
        QVERIFY(glm::length(window().viewport()->camera().location - glm::dvec3(0, 0, -4)) < 1e-3);
        drag(0, 40);
        QVERIFY(driver_->rests());
        QVERIFY(glm::length(window().viewport()->camera().location - there) < 1e-2);
        QCOMPARE(text(), keyed);  // it is the view that moved
        undo();
        QCOMPARE(panel()->frame(), 0);
        QVERIFY(glm::length(window().viewport()->camera().location - glm::dvec3(0, 0, -4)) < 1e-3);
        QCOMPARE(text(), keyed);
        QVERIFY(driver_->rests());
    }

    void keysAreMovedEasedAndRemoved() {
        QVERIFY(open(scene + frames + keysOfR));
        drag(40, 20, 0);
        QVERIFY(driver_->rests());
        QVERIFY2(text().contains("// keys \"R\": 0 = 0.3 linear, 20 = 0.9\n"), qPrintable(text()));
        QCOMPARE(panel()->frame(), 20);
        QTest::mouseClick(view(), Qt::LeftButton, {}, view()->placeOf(0, 0));
        QCOMPARE(panel()->frame(), 0);
        QVERIFY(driver_->rests());
        auto* easing = panel()->findChild<QComboBox*>();
        QVERIFY(easing->isEnabled());
        QCOMPARE(easing->currentText(), QString("Even"));
        emit easing->activated(easing->findText("Slow start"));
        QVERIFY(text().contains("0 = 0.3 slow-start, 20 = 0.9"));
        view()->setFocus();
        QTest::keyClick(view(), Qt::Key_Delete);
        QVERIFY(text().contains("// keys \"R\": 20 = 0.9\n"));
        QVERIFY(!easing->isEnabled());
        undo();
        QVERIFY(text().contains("0 = 0.3 slow-start, 20 = 0.9"));
        QVERIFY(driver_->rests());
        QCOMPARE(view()->rows()[0].frames(timelineOf(text().toStdString())), (std::set<int>{0, 20}));
    }

    void framesClockAndRateAreWritten() {
        QVERIFY(open(scene));
        QVERIFY(type("Last frame of the animation", "59"));
        QVERIFY(type("Frames per second", "24"));
        QVERIFY(type("Clock of the last frame", "2.5"));
        QCOMPARE(text().toUtf8(), scene + "// timeline: frames 0 to 59, clock 0 to 2.5, 24 per second\n");
        QVERIFY(type("Present frame", "59"));
        QVERIFY(driver_->rests());
        QVERIFY(type("Last frame of the animation", "30"));
        QCOMPARE(panel()->frame(), 30);
        QVERIFY(driver_->rests());
    }

    void anotherDocumentHasItsOwn() {
        QVERIFY(open(scene + frames + keysOfR));
        emit panel()->playRequested(true);
        QVERIFY(driver_->openText(scene, "other.pov"));
        QVERIFY(!window().timeline()->isPlaying());
        QVERIFY(driver_->rests());
        QCOMPARE(text().toUtf8(), scene);
        QVERIFY(view()->rows().empty());
        QCOMPARE(window().session()->result()->options.clockOn, false);
        QVERIFY(!window().actions()->undo->isEnabled());
    }

    void keysWithoutANumberAreToldInTheirRow() {
        QVERIFY(open(scene + "// keys \"Gone\": 0 = 1\n"));
        QCOMPARE(view()->rows().size(), 1u);
        QVERIFY(view()->rows()[0].missing);
        const auto& found = window().session()->result()->diagnostics;
        QVERIFY(std::any_of(found.begin(), found.end(),
                            [](const Diagnostic& one) { return one.id == unknownKeysId; }));
    }

    /// While frames go by the panels below get scenes, too, and no picture is left out for them.
    void playingDoesNotStarveThePanels() {
        QVERIFY(open(scene + frames + keysOfR));
        window().docks()->bringUp(window().docks()->find("effects"));
        QSignalSpy changed(window().session(), &SceneSession::sceneChanged);
        int pictures = 0, values = 0;
        connect(window().session(), &SceneSession::sceneChanged, this, [&] { ++values; });
        const auto counted =
            connect(window().viewport(), &Viewport::progressed, this, [&](const RenderProgress& progress) {
                if (progress.finished) ++pictures;
            });
        emit panel()->playRequested(true);
        QTRY_VERIFY_WITH_TIMEOUT(values >= 12, 30000);
        QVERIFY2(pictures >= values - 1, qPrintable(QString("%1 %2").arg(pictures).arg(values)));
        disconnect(counted);
        window().timeline()->settle();
        QVERIFY(driver_->rests());
    }
};

QTEST_MAIN(TimelineWindowTest)
#include "timeline_window_test.moc"
