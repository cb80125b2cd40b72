// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/parameters/parameter_slider.h"

#include <cmath>
#include <limits>
#include <QLabel>
#include <QLineEdit>
#include <QSignalSpy>
#include <QSlider>
#include <QTest>
#include <QToolButton>

#include "tests/widgets/gui_events.h"
#include "widgets/numbers/number_box.h"
#include "widgets/numbers/number_text.h"
#include "widgets/numbers/slider_scale.h"
#include "widgets/parameters/slider_note_popup.h"

using namespace isoscope;
using namespace isoscope::test;

namespace {

SceneParameter make(double value, double minimum, double maximum) {
    SceneParameter parameter;
    parameter.role = ParameterRole::argument;
    parameter.group = "f_torus";
    parameter.name = "Major Radius";
    parameter.value = value;
    parameter.minimum = minimum;
    parameter.maximum = maximum;
    return parameter;
}

}  // namespace

class ParameterSliderTest : public QObject {
    Q_OBJECT

    std::unique_ptr<ParameterSlider> row_;

    void show(const SceneParameter& parameter) {
        row_ = std::make_unique<ParameterSlider>(parameter);
        row_->resize(320, row_->sizeHint().height());
        QVERIFY(showActive(row_.get()));
    }
    QSlider* slider() const { return row_->findChild<QSlider*>(); }
    NumberBox* box() const { return row_->findChild<NumberBox*>(); }
    QLabel* label(const QString& text) const {
        for (QLabel* label : row_->findChildren<QLabel*>())
            if (label->text() == text) return label;
        return nullptr;
    }
    /// Slider and box show the row's value.
    bool agrees() const {
        const SliderScale scale(row_->minimum(), row_->maximum(), SliderScale::Kind::linear);
        return box()->value() == row_->value() && slider()->value() == scale.step(row_->value());
    }

  private slots:
    void cleanup() { row_.reset(); }

    /// 1e300 stood as 1e15 in the box, and a step of the slider wrote that.
    void hugeNumbersAreShownAsTheyAre() {
        show(make(1e300, 0, 4e300));
        QCOMPARE(box()->value(), 1e300);
        QCOMPARE(box()->text(), QStringLiteral("1e300"));
        QVERIFY(agrees());
        QSignalSpy changed(row_.get(), &ParameterSlider::valueChanged);
        slider()->setValue(slider()->value() + 10);
        QCOMPARE(changed.count(), 1);
        QVERIFY(std::abs(changed[0][0].toDouble() / 1e300 - 1.04) < 0.01);
        show(make(-1e308, -1e308, 0));
        QCOMPARE(box()->value(), -1e308);
        QCOMPARE(row_->value(), -1e308);
    }

    /// The box has no largest number, and still takes none that a double cannot hold.
    void aNumberBeyondDoublesIsNotTaken() {
        show(make(0.8, 0.1, 2));
        int position = 0;
        QString largest = QStringLiteral("1.7e308"), beyond = QStringLiteral("1e309");
        QCOMPARE(box()->validate(largest, position), QValidator::Acceptable);
        QCOMPARE(box()->validate(beyond, position), QValidator::Intermediate);
        QCOMPARE(box()->valueFromText(beyond), 0.8);
        QVERIFY(box()->sizeHint().width() > box()->fontMetrics().horizontalAdvance("-1.797693134862"));
    }

    void showsItsParameter() {
        show(make(0.8, 0.1, 2));
        QCOMPARE(row_->value(), 0.8);
        QCOMPARE(box()->text(), QString("0.8"));
        QVERIFY(label("Major Radius"));
        QVERIFY(label("0.1"));
        QVERIFY(label("2"));
        QVERIFY(agrees());
        QCOMPARE(box()->accessibleName(), QString("f_torus Major Radius"));
    }

    void mouseDragsAreOneDrag() {
        show(make(0.8, 0, 2));
        QSignalSpy changed(row_.get(), &ParameterSlider::valueChanged),
            started(row_.get(), &ParameterSlider::dragStarted),
            finished(row_.get(), &ParameterSlider::dragFinished);
        dragSlider(slider(), 60, 20, false);
        QCOMPARE(started.count(), 1);
        QVERIFY(row_->isDragging());
        QTest::qWait(500);  // a mouse that rests still holds it
        QCOMPARE(finished.count(), 0);
        QTest::mouseRelease(slider(), Qt::LeftButton, {}, handleCenter(slider()));
        QCOMPARE(finished.count(), 1);
        QVERIFY(changed.count() >= 10);
        QCOMPARE(changed.last()[0].toDouble(), row_->value());
        QVERIFY(row_->value() > 1);
        QVERIFY(agrees());
        QVERIFY(numberText(row_->value()).size() <= 5);
    }

    void aClickBringsTheHandle() {
        show(make(0, 0, 1));
        QTest::mouseClick(slider(), Qt::LeftButton, {},
                          QPoint(slider()->width() / 2, slider()->height() / 2));
        QVERIFY2(std::abs(row_->value() - 0.5) < 0.02, qPrintable(QString::number(row_->value())));
        QVERIFY(!row_->isDragging());
    }

    void keysAreOneDragUntilAPause() {
        show(make(0.8, 0, 2));
        QSignalSpy started(row_.get(), &ParameterSlider::dragStarted),
            finished(row_.get(), &ParameterSlider::dragFinished);
        slider()->setFocus();
        for (int i = 0; i < 5; ++i) QTest::keyClick(slider(), Qt::Key_Right);
        QCOMPARE(row_->value(), 0.81);
        QCOMPARE(started.count(), 1);
        QCOMPARE(finished.count(), 0);
        QTRY_COMPARE(finished.count(), 1);
        QTest::keyClick(slider(), Qt::Key_Left);
        QCOMPARE(started.count(), 2);
    }

    void wheelNeedsTheFocus() {
        show(make(0.8, 0, 2));
        row_->setFocusPolicy(Qt::StrongFocus);
        row_->setFocus();
        QVERIFY(!wheel(slider(), slider()->rect().center(), 1));
        QVERIFY(!wheel(box(), box()->rect().center(), 1));
        QCOMPARE(row_->value(), 0.8);
        slider()->setFocus();
        QVERIFY(wheel(slider(), slider()->rect().center(), 1));
        QVERIFY(row_->value() > 0.8);
        QVERIFY(agrees());
    }

    void typedNumbersAreKeptExactly() {
        show(make(0.8, 0, 2));
        QSignalSpy changed(row_.get(), &ParameterSlider::valueChanged);
        box()->setFocus();
        box()->selectAll();
        QTest::keyClicks(box(), "1.23456789");
        QCOMPARE(changed.count(), 0);  // not before it is whole
        QTest::keyClick(box(), Qt::Key_Return);
        QCOMPARE(changed.count(), 1);
        QCOMPARE(row_->value(), 1.23456789);
        QCOMPARE(box()->text(), QString("1.23456789"));
        QVERIFY(agrees());
    }

    void typedNumbersOutsideWidenTheRange() {
        show(make(0.8, 0, 2));
        box()->setFocus();
        box()->selectAll();
        QTest::keyClicks(box(), "-7e0");
        QTest::keyClick(box(), Qt::Key_Return);
        QCOMPARE(row_->value(), -7.0);
        QCOMPARE(row_->minimum(), -7.0);
        QVERIFY(agrees());
    }

    void nonsenseIsNotTyped() {
        show(make(0.8, 0, 2));
        QSignalSpy changed(row_.get(), &ParameterSlider::valueChanged);
        box()->setFocus();
        box()->selectAll();
        QTest::keyClicks(box(), "nan,1e");
        QTest::keyClick(box(), Qt::Key_Return);
        QVERIFY(std::isfinite(row_->value()));
        box()->selectAll();
        QTest::keyClicks(box(), "1e400");
        QTest::keyClick(box(), Qt::Key_Return);
        QVERIFY(std::isfinite(row_->value()));
        QVERIFY(agrees());
    }

    void valuesFromOutsideAreSilent() {
        show(make(0.8, 0, 2));
        QSignalSpy changed(row_.get(), &ParameterSlider::valueChanged),
            started(row_.get(), &ParameterSlider::dragStarted);
        row_->setParameter(make(5, 0, 2));
        QCOMPARE(row_->value(), 5.0);
        QCOMPARE(row_->maximum(), 5.0);
        QVERIFY(agrees());
        row_->setParameter(make(1, 0, 2));
        QCOMPARE(row_->maximum(), 2.0);
        row_->setValue(1.5);
        QCOMPARE(box()->text(), QString("1.5"));
        QCOMPARE(changed.count() + started.count(), 0);
    }

    void aDragIsNotDisturbed() {
        show(make(0.8, 0, 2));
        dragSlider(slider(), 40, 10, false);
        const double dragged = row_->value();
        row_->setParameter(make(0.1, -50, 50));
        QCOMPARE(row_->value(), dragged);
        QCOMPARE(row_->maximum(), 2.0);
        QTest::mouseRelease(slider(), Qt::LeftButton, {}, handleCenter(slider()));
    }

    void derivedEndsStayWhileTheyHoldTheValue() {
        SceneParameter threshold = make(0.5, -1, 1);
        threshold.role = ParameterRole::threshold;
        show(threshold);
        threshold.value = 0.9;
        threshold.minimum = -1.8;
        threshold.maximum = 1.8;
        row_->setParameter(threshold);
        QCOMPARE(row_->maximum(), 1.0);
        threshold.value = 3;
        threshold.minimum = -6;
        threshold.maximum = 6;
        row_->setParameter(threshold);
        QCOMPARE(row_->maximum(), 6.0);
    }

    void doubleClickOnTheNameResets() {
        show(make(0.8, 0, 2));
        dragSlider(slider(), 40);
        QSignalSpy changed(row_.get(), &ParameterSlider::valueChanged);
        QTest::mouseDClick(label("Major Radius"), Qt::LeftButton);
        QCOMPARE(row_->value(), 0.8);
        QCOMPARE(changed.count(), 1);
        QVERIFY(agrees());
    }

    void endsAreEditedInPlace() {
        show(make(0.8, 0, 2));
        QTest::mouseDClick(label("2"), Qt::LeftButton);
        auto* field = qobject_cast<QLineEdit*>(QApplication::focusWidget());
        QVERIFY(field && !row_->findChildren<QLineEdit*>().isEmpty());
        field->selectAll();
        QTest::keyClicks(field, "10");
        QTest::keyClick(field, Qt::Key_Return);
        QCOMPARE(row_->maximum(), 10.0);
        QVERIFY(label("10"));
        QVERIFY(agrees());
        row_->setParameter(make(0.9, 0, 2));  // the next parse knows nothing of it
        QCOMPARE(row_->maximum(), 10.0);
    }

    void escapeLeavesTheEnd() {
        show(make(0.8, 0, 2));
        QTest::mouseDClick(label("2"), Qt::LeftButton);
        auto* field = qobject_cast<QLineEdit*>(QApplication::focusWidget());
        QVERIFY(field);
        QTest::keyClicks(field, "77");
        QTest::keyClick(field, Qt::Key_Escape);
        QCOMPARE(row_->maximum(), 2.0);
        QVERIFY(slider()->hasFocus());
    }

    void impossibleEndsAreIgnored() {
        show(make(0.8, 0, 2));
        row_->setRange(3, 1);
        row_->setRange(1, 1);
        row_->setRange(std::nan(""), 1);
        row_->setRange(0, std::numeric_limits<double>::infinity());
        QCOMPARE(row_->minimum(), 0.0);
        QCOMPARE(row_->maximum(), 2.0);
    }

    void logarithmicScalesMoveByRatios() {
        SceneParameter accuracy = make(0.001, 1e-6, 1);
        accuracy.logarithmic = true;
        show(accuracy);
        QCOMPARE(slider()->value(), 500);
        row_->setRange(0, 1);  // no logarithm of zero
        QCOMPARE(row_->minimum(), 1e-6);
        slider()->setFocus();
        QTest::keyClick(slider(), Qt::Key_Home);
        QCOMPARE(row_->value(), 1e-6);
        QCOMPARE(box()->text(), QString("1e-6"));
    }

    void integralParametersStayWhole() {
        SceneParameter octaves = make(3, 1, 15);
        octaves.integral = true;
        show(octaves);
        slider()->setFocus();
        QTest::keyClick(slider(), Qt::Key_Right);
        QCOMPARE(row_->value(), 4.0);
        box()->stepUp();
        QCOMPARE(row_->value(), 5.0);
        box()->setFocus();
        box()->selectAll();
        QTest::keyClicks(box(), "2.5");
        QTest::keyClick(box(), Qt::Key_Return);
        QCOMPARE(row_->value(), std::floor(row_->value()));
    }

    void aNoteDecidesHowTheSliderMoves() {
        show(make(0.8, 0, 2));
        row_->setParameter(make(0.8, 0, 2), SliderNote{-1, 4, 0.25, false, 2, false});
        QCOMPARE(row_->minimum(), -1.0);
        QCOMPARE(row_->maximum(), 4.0);
        QCOMPARE(slider()->maximum(), 20);
        QCOMPARE(box()->text(), QString("0.80"));
        slider()->setFocus();
        QTest::keyClick(slider(), Qt::Key_Right);
        QCOMPARE(row_->value(), 1.0);
        QCOMPARE(box()->text(), QString("1.00"));
        box()->setFocus();
        box()->selectAll();
        QTest::keyClicks(box(), "0.123");
        QTest::keyClick(box(), Qt::Key_Return);
        QCOMPARE(row_->value(), 0.12);
        // The text takes it back.
        QTRY_VERIFY(!row_->isDragging());
        row_->setParameter(make(0.8, 0, 2));
        QCOMPARE(row_->maximum(), 2.0);
        QCOMPARE(box()->text(), QString("0.8"));
    }

    void aNoteCanMakeItLogarithmic() {
        show(make(0.1, 0, 2));
        row_->setParameter(make(0.1, 0, 2), SliderNote{0.01, 1, 0, true});
        QCOMPARE(slider()->value(), 500);
        QVERIFY(row_->note() == (SliderNote{0.01, 1, 0, true}));
    }

    void aLockedSliderDoesNotMove() {
        show(make(0.8, 0, 2));
        QSignalSpy changed(row_.get(), &ParameterSlider::valueChanged);
        row_->setParameter(make(0.8, 0, 2), SliderNote{0, 2, 0, false, -1, true});
        QVERIFY(row_->isLocked());
        dragSlider(slider(), 40);
        QTest::keyClick(box(), Qt::Key_Up);
        row_->randomise();
        row_->resetToInitial();
        QCOMPARE(row_->value(), 0.8);
        QCOMPARE(changed.count(), 0);
        // The button that shows the lock opens it.
        QSignalSpy noted(row_.get(), &ParameterSlider::noteChanged);
        QToolButton* lock = nullptr;
        for (auto* button : row_->findChildren<QToolButton*>())
            if (button->accessibleName() == "Unlock f_torus Major Radius") lock = button;
        QVERIFY(lock && lock->isVisible());
        QTest::mouseClick(lock, Qt::LeftButton);
        QCOMPARE(noted.count(), 1);
        QVERIFY(!lock->isVisible());
        dragSlider(slider(), 40);
        QVERIFY(row_->value() > 0.8);
    }

    void fieldsOfANoteAreChecked() {
        show(make(0.8, 0, 2));
        QSignalSpy noted(row_.get(), &ParameterSlider::noteChanged);
        row_->editNote();
        auto* popup = row_->findChild<SliderNotePopup*>();
        QVERIFY(popup && QTest::qWaitForWindowExposed(popup));
        const auto type = [popup](const char* name, const char* text) {
            for (auto* field : popup->findChildren<QLineEdit*>()) {
                if (field->accessibleName() != QString(name) + " of f_torus Major Radius") continue;
                field->setFocus();
                field->selectAll();
                QTest::keyClick(field, Qt::Key_Delete);
                QTest::keyClicks(field, text);
                QTest::keyClick(field, Qt::Key_Return);
            }
        };
        const QList<std::array<const char*, 2>> bad{{"From", "x"},     {"From", "3"}, {"To", "nan"},
                                                    {"Step", "-1"},    {"Step", "9"}, {"Decimals", "1.5"},
                                                    {"Decimals", "99"}};
        const QHash<QString, const char*> good{{"From", "0"}, {"To", "2"}, {"Step", ""}, {"Decimals", ""}};
        for (const auto& [field, text] : bad) {
            type(field, text);
            QVERIFY2(popup->isVisible() && noted.isEmpty(), text);
            for (auto* other : popup->findChildren<QLineEdit*>())
                if (other->accessibleName().startsWith(field)) other->setText(good[field]);
        }
        type("Step", "0.5");
        QCOMPARE(noted.count(), 1);
        QVERIFY(row_->note() == (SliderNote{0, 2, 0.5}));
        row_->editNote();
        popup = row_->findChildren<SliderNotePopup*>().last();
        QVERIFY(QTest::qWaitForWindowExposed(popup));
        QTest::keyClicks(popup->findChild<QLineEdit*>(), "1");
        QTest::keyClick(popup->findChild<QLineEdit*>(), Qt::Key_Escape);
        QVERIFY(!popup->isVisible());
        QCOMPARE(noted.count(), 1);
    }

    void expressionsOfferANumber() {
        SceneParameter expression = make(0.8, 0, 2);
        expression.expression = true;
        expression.text = "R*sin(clock)";
        show(expression);
        QVERIFY(!slider());
        QVERIFY(label("R*sin(clock)"));
        QSignalSpy asked(row_.get(), &ParameterSlider::replaceExpressionRequested);
        row_->findChild<QToolButton*>()->click();
        QCOMPARE(asked.count(), 1);
        QVERIFY(!row_->canShow(make(0.8, 0, 2)));
    }
};

QTEST_MAIN(ParameterSliderTest)
#include "parameter_slider_test.moc"
