// SPDX-License-Identifier: GPL-3.0-or-later
#include <QAbstractButton>
#include <QAction>
#include <QDoubleSpinBox>
#include <QSlider>
#include <QTest>

#include "app/desktop/window/actions.h"
#include "tests/app/window_driver.h"
#include "widgets/document/scene_session.h"
#include "widgets/editor/scene_editor.h"
#include "widgets/numbers/number_popup.h"
#include "widgets/numbers/number_tool.h"
#include "widgets/parameters/parameter_panel.h"
#include "widgets/parameters/parameter_slider.h"
#include "widgets/viewport/viewport.h"

using namespace isoscope;
using namespace isoscope::test;

namespace {

const QString text = QStringLiteral(
    "#declare Radius = 0.5;\n"
    "camera { location <0, 0, -4> look_at 0 }\n"
    "light_source { <5, 5, -5> rgb 1 }\n"
    "isosurface {\n"
    "  function { x*x + y*y + z*z - 0.5 - Radius + 1e-3*x }\n"
    "  threshold -0.25\n"
    "  max_gradient 4\n"
    "  pigment { rgb <1, 0.3, 0> }\n"
    "  translate -0.1*x\n"
    "}\n");

}  // namespace

/// Any number of the text is a slider: by the handle, by key, and by dragging with Ctrl.
class NumberPopupTest : public QObject {
    Q_OBJECT

    std::unique_ptr<WindowDriver> driver_;

    SceneEditor* editor() const { return driver_->window().editor(); }
    QString shown() const { return editor()->sceneText(); }
    /// With the caret behind `before`.
    void setCaretBehind(const QString& before) const {
        const auto at = shown().toUtf8().indexOf(before.toUtf8());
        QVERIFY2(at >= 0, qPrintable(before));
        editor()->SendScintilla(QsciScintilla::SCI_GOTOPOS,
                                static_cast<unsigned long>(at + before.toUtf8().size()));
        editor()->setFocus();
    }
    QPoint placeBehind(const QString& before) const {
        const auto at = static_cast<long>(shown().toUtf8().indexOf(before.toUtf8()) + before.toUtf8().size());
        return {
            static_cast<int>(editor()->SendScintilla(QsciScintilla::SCI_POINTXFROMPOSITION, 0UL, at)) + 2,
            static_cast<int>(editor()->SendScintilla(QsciScintilla::SCI_POINTYFROMPOSITION, 0UL, at)) + 6};
    }
    NumberPopup* opened() const {
        (*driver_)->actions()->adjustNumber->trigger();
        return driver_->window().findChild<NumberPopup*>();
    }

  private slots:
    /// The text keeps how any number moves, also one without a row among the parameters.
    void theNoteOfTheNumberCounts() {
        setCaretBehind("translate -0.1");
        NumberPopup* popup = opened();
        QVERIFY(popup && !popup->slider()->hasNote());
        popup->slider()->changeNote(SliderNote{-1, 1, 0.25, false, 2, false});
        popup->close();
        QTRY_VERIFY(!driver_->window().findChild<NumberPopup*>());
        // Code follows on the line: there is no place for a comment of its own.
        QCOMPARE(shown(), text);
        setCaretBehind("threshold -0.25");
        popup = opened();
        QVERIFY(popup);
        popup->slider()->changeNote(SliderNote{-1, 1, 0.25, false, 2, false});
        const QString noted = QString(text).replace("-0.25\n", "-0.25  // [-1:1:0.25 decimals 2]\n");
        QCOMPARE(shown(), noted);
        popup->close();
        QTRY_VERIFY(!driver_->window().findChild<NumberPopup*>());
        QVERIFY(driver_->rests());
        setCaretBehind("threshold -0.25");
        popup = opened();
        QVERIFY(popup && popup->slider()->note() == (SliderNote{-1, 1, 0.25, false, 2, false}));
        QTest::keyClick(popup->slider()->findChild<QSlider*>(), Qt::Key_Right);
        QCOMPARE(shown(), QString(noted).replace("-0.25 ", "0.00 "));
        QTest::keyClick(popup, Qt::Key_Escape);
        QCOMPARE(shown(), noted);
        (*driver_)->actions()->undo->trigger();
        QCOMPARE(shown(), text);
    }

    void init() {
        driver_ = std::make_unique<WindowDriver>();
        editor()->setSceneText(text);
        QTRY_VERIFY(!(*driver_)->session()->busy());
        QVERIFY(driver_->rests());
    }
    void cleanup() { driver_.reset(); }

    void anyNumberHasASlider_D11_data() {
        QTest::addColumn<QString>("before");
        QTest::addColumn<double>("value");
        QTest::addColumn<double>("wanted");
        QTest::addColumn<QString>("after");
        QTest::newRow("formula") << QStringLiteral("z*z - ") << 0.5 << 0.75 << QStringLiteral("z*z - 0.75");
        QTest::newRow("formula, exponent")
            << QStringLiteral("Radius + ") << 1e-3 << 2e-3 << QStringLiteral("Radius + 0.002*x");
        QTest::newRow("colour") << QStringLiteral("rgb <1, ") << 0.3 << 0.5 << QStringLiteral("<1, 0.5, 0>");
        QTest::newRow("camera") << QStringLiteral("<0, 0, ") << -4.0 << -5.0 << QStringLiteral("<0, 0, -5>");
        QTest::newRow("light") << QStringLiteral("<5, ") << 5.0 << 6.0 << QStringLiteral("<5, 6, -5>");
        QTest::newRow("setting behind its word")
            << QStringLiteral("threshold ") << -0.25 << 0.1 << QStringLiteral("threshold 0.1\n");
        QTest::newRow("transform") << QStringLiteral("translate ") << -0.1 << 0.1
                                   << QStringLiteral("translate 0.1*x");
        QTest::newRow("declared") << QStringLiteral("Radius = ") << 0.5 << 0.6
                                  << QStringLiteral("Radius = 0.6;");
    }
    void anyNumberHasASlider_D11() {
        QFETCH(QString, before);
        QFETCH(double, value);
        QFETCH(double, wanted);
        QFETCH(QString, after);
        WindowDriver& d = *driver_;
        const QImage picture = d.picture();
        setCaretBehind(before);
        NumberPopup* popup = opened();
        QVERIFY(popup);
        QCOMPARE(popup->slider()->value(), value);
        QVERIFY(popup->slider()->minimum() < value && popup->slider()->maximum() > value);
        auto* box = popup->findChild<QDoubleSpinBox*>();
        box->setValue(wanted);
        QVERIFY2(shown().contains(after), qPrintable(shown()));
        QTest::keyClick(popup, Qt::Key_Return);
        QTRY_VERIFY(!d->findChild<NumberPopup*>());
        QTRY_VERIFY(!d->session()->busy());
        QVERIFY(d.rests());
        QVERIFY(difference(d.picture(), picture) > 0);
        d->actions()->undo->trigger();
        QCOMPARE(shown(), text);
    }

    void oneDragIsOneStepAndEscapeBringsTheFirstTextBack_D10() {
        setCaretBehind(QStringLiteral("z*z - "));
        NumberPopup* popup = opened();
        QVERIFY(popup);
        auto* slider = popup->findChild<QSlider*>();
        for (int drag = 0; drag < 2; ++drag) {
            slider->setSliderDown(true);
            for (int i = 0; i < 5; ++i) slider->setValue(slider->value() + 20);
            slider->setSliderDown(false);
        }
        const QString twice = shown();
        QVERIFY(twice != text);
        editor()->undo();
        QVERIFY(shown() != text && shown() != twice);
        editor()->redo();
        QCOMPARE(shown(), twice);
        QTest::keyClick(popup, Qt::Key_Escape);
        QCOMPARE(shown(), text);
        QTRY_VERIFY(!(*driver_)->findChild<NumberPopup*>());
    }

    void draggingWithControlChangesTheNumber_D10() {
        WindowDriver& d = *driver_;
        QWidget* area = editor()->viewport();
        const QPoint place = placeBehind(QStringLiteral("z*z - "));
        QTest::mousePress(area, Qt::LeftButton, Qt::ControlModifier, place);
        QMouseEvent move(QEvent::MouseMove, place + QPoint(20, 0), area->mapToGlobal(place + QPoint(20, 0)),
                         Qt::NoButton, Qt::LeftButton, Qt::ControlModifier);
        QCoreApplication::sendEvent(area, &move);
        QVERIFY2(shown().contains(QStringLiteral("z*z - 1.0 -")), qPrintable(shown()));
        QTest::mouseRelease(area, Qt::LeftButton, Qt::ControlModifier, place + QPoint(20, 0));
        d->actions()->undo->trigger();
        QCOMPARE(shown(), text);
        // Escape takes a drag back that is under way.
        QTest::mousePress(area, Qt::LeftButton, Qt::ControlModifier, place);
        QCoreApplication::sendEvent(area, &move);
        QVERIFY(shown() != text);
        QTest::keyClick(editor(), Qt::Key_Escape);
        QCOMPARE(shown(), text);
        QTest::mouseRelease(area, Qt::LeftButton, Qt::ControlModifier, place);
        QCOMPARE(shown(), text);
    }

    void aClickWithControlOpensTheSlider_D10() {
        QTest::mouseClick(editor()->viewport(), Qt::LeftButton, Qt::ControlModifier,
                          placeBehind(QStringLiteral("rgb <1, ")));
        auto* popup = (*driver_)->findChild<NumberPopup*>();
        QVERIFY(popup);
        QCOMPARE(popup->slider()->value(), 0.3);
        popup->close();
        QCOMPARE(shown(), text);
    }

    void theHandleIsUnderTheNumberAtTheCaret_D10() {
        auto* tool = (*driver_)->findChild<NumberTool*>();
        setCaretBehind(QStringLiteral("z*z - 0"));
        QTRY_VERIFY(tool->handle()->isVisible());
        QTest::mouseClick(tool->handle(), Qt::LeftButton);
        QVERIFY(tool->popup());
        QCOMPARE(tool->popup()->slider()->value(), 0.5);
        tool->popup()->close();
        setCaretBehind(QStringLiteral("isosurface"));
        QTRY_VERIFY(!tool->handle()->isVisible());
    }

    void keysStepTheNumberAtTheCaret() {
        setCaretBehind(QStringLiteral("threshold -0."));
        QTest::keyClick(editor(), Qt::Key_Up, Qt::ControlModifier);
        QVERIFY(shown().contains(QStringLiteral("threshold -0.24")));
        for (int i = 0; i < 3; ++i) QTest::keyClick(editor(), Qt::Key_PageUp, Qt::ControlModifier);
        QVERIFY2(shown().contains(QStringLiteral("threshold 0.06")), qPrintable(shown()));
        QTest::keyClick(editor(), Qt::Key_Down, Qt::ControlModifier | Qt::ShiftModifier);
        QVERIFY(shown().contains(QStringLiteral("threshold 0.059")));
        // A run of them is one step.
        editor()->undo();
        QCOMPARE(shown(), text);
        // Where there is no number nothing happens.
        setCaretBehind(QStringLiteral("isosurface"));
        QTest::keyClick(editor(), Qt::Key_Up, Qt::ControlModifier);
        QCOMPARE(shown(), text);
        QVERIFY(!opened());
    }
};

QTEST_MAIN(NumberPopupTest)
#include "number_popup_test.moc"
