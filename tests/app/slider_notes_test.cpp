// SPDX-License-Identifier: GPL-3.0-or-later
#include <QAction>
#include <QLineEdit>
#include <QTest>
#include <QToolButton>

#include "app/desktop/window/actions.h"
#include "tests/app/window_driver.h"
#include "widgets/document/scene_session.h"
#include "widgets/editor/scene_editor.h"
#include "widgets/parameters/parameter_panel.h"
#include "widgets/parameters/parameter_slider.h"
#include "widgets/parameters/slider_note_popup.h"

using namespace isoscope;
using namespace isoscope::test;

namespace {

const QByteArray scene =
    "#declare R = 0.5; // [0:2:0.25] radius\n"
    "#declare S = 0.25;\r\n"
    "#declare T = 1; // [0:4 locked]\n"
    "isosurface { function { x*x + y*y + S*z*z - R*T } threshold 0.1 max_gradient 4 accuracy 0.01\n"
    "  contained_by { box { -2, 2 } } }\n";

}  // namespace

/// Ranges, steps and locks that stand in the text, in the real window.
class SliderNotesTest : public QObject {
    Q_OBJECT

    std::unique_ptr<WindowDriver> driver_;

    MainWindow& window() const { return driver_->window(); }
    QString text() const { return window().editor()->sceneText(); }
    ParameterSlider* row(const char* name) const {
        return window().parameters()->slider(driver_->parameter(name));
    }
    void undo() const { window().actions()->undo->trigger(); }

  private slots:
    void init() {
        driver_ = std::make_unique<WindowDriver>();
        QVERIFY(driver_->openText(scene));
        QVERIFY(driver_->rests());
    }
    void cleanup() { driver_.reset(); }

    void theTextSaysHowSlidersMove() {
        QVERIFY(row("R")->note() == (SliderNote{0, 2, 0.25}));
        QVERIFY(!row("S")->hasNote());
        QVERIFY(row("T")->isLocked());
        driver_->drag(driver_->parameter("R"), 60);
        QCOMPARE(std::fmod(row("R")->value(), 0.25), 0.0);
        QVERIFY(row("R")->value() > 0.5);
        // What is typed counts as well.
        driver_->typeBehind("// [0:2", "0");
        QTRY_COMPARE(row("R")->maximum(), 20.0);
    }

    void aChangedRangeIsOneStepAndKeepsTheRest() {
        const QString before = text();
        row("S")->editNote();
        auto* popup = row("S")->findChild<SliderNotePopup*>();
        QVERIFY(popup && QTest::qWaitForWindowExposed(popup));
        QWidget* field = popup->focusWidget();
        QTest::keyClicks(field, "-1");
        QTest::keyClick(field, Qt::Key_Tab);
        QTest::keyClicks(popup->focusWidget(), "3");
        QTest::keyClick(popup->focusWidget(), Qt::Key_Return);
        QString expected = before;
        QCOMPARE(text(), expected.replace("S = 0.25;\r", "S = 0.25;  // [-1:3]\r"));
        QVERIFY(driver_->rests());
        QVERIFY(row("S")->note() == (SliderNote{-1, 3}));
        // The slider still knows its number.
        driver_->drag(driver_->parameter("S"), 30);
        QCOMPARE(driver_->numberBehind("S = "), row("S")->value());
        undo();
        QCOMPARE(text(), expected);
        undo();
        QCOMPARE(text(), before);
        QTRY_VERIFY(!row("S")->hasNote());
        QCOMPARE(row("S")->minimum(), 0.0);
        QVERIFY(!window().isWindowModified());
    }

    void aLockIsWrittenAndTakenAway() {
        row("R")->changeNote(SliderNote{0, 2, 0.25, false, -1, true});
        QVERIFY(text().startsWith("#declare R = 0.5; // [0:2:0.25 locked] radius\n"));
        row("R")->changeNote(std::nullopt);
        QVERIFY(text().startsWith("#declare R = 0.5; // radius\n"));
        QVERIFY(driver_->rests());
        QVERIFY(!row("R")->hasNote());
        QCOMPARE(row("R")->value(), 0.5);
    }

    /// The number before another one on its line has no comment of its own.
    void aRangeWithoutAPlaceIsKeptBesideTheText() {
        const QString before = text();
        row("threshold")->setRange(-3, 3);
        QCOMPARE(text(), before);
        driver_->typeBehind("#declare S = 0.2", "2");
        QVERIFY(driver_->rests());
        QCOMPARE(row("threshold")->maximum(), 3.0);
    }

    void randomiseIsOneStepAndLeavesSettingsAlone() {
        const QString before = text();
        window().parameters()->randomise();
        QVERIFY(driver_->rests());
        QVERIFY(text() != before);
        for (const char* same : {"T = 1;", "max_gradient 4", "accuracy 0.01", "box { -2, 2 }"})
            QVERIFY2(text().contains(same), same);
        QCOMPARE(driver_->numberBehind("S = "), row("S")->value());
        QCOMPARE(driver_->numberBehind("R = "), row("R")->value());
        QCOMPARE(std::fmod(row("R")->value(), 0.25), 0.0);
        undo();
        QCOMPARE(text(), before);
        QVERIFY(!window().actions()->undo->isEnabled());
    }

    void resetBringsWhatWasOpened() {
        driver_->drag(driver_->parameter("R"), 60);
        driver_->drag(driver_->parameter("S"), 60);
        // An error that takes the rows away for a moment changes nothing of that.
        window().editor()->setSelection(0, 0, 0, 0);
        QTest::keyClicks(window().editor(), "}");
        QVERIFY(driver_->rests());
        QTest::keyClick(window().editor(), Qt::Key_Backspace);
        QVERIFY(driver_->rests());
        window().parameters()->resetAll();
        QVERIFY(driver_->rests());
        QCOMPARE(text().toUtf8(), scene);
        undo();
        QVERIFY(driver_->numberBehind("R = ") > 0.5);
        QVERIFY(driver_->numberBehind("S = ") > 0.25);
    }
};

QTEST_MAIN(SliderNotesTest)
#include "slider_notes_test.moc"
