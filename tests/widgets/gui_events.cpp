// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/widgets/gui_events.h"

#include <QCoreApplication>
#include <QKeyEvent>
#include <QStyle>
#include <QStyleOptionSlider>
#include <QTest>
#include <QWheelEvent>

namespace isoscope::test {

void type(QWidget* widget, const QString& text) {
    for (const QChar c : text) {
        const int key = c == '\n' ? Qt::Key_Return : 0;
        QKeyEvent press(QEvent::KeyPress, key, Qt::NoModifier, c == '\n' ? QString("\r") : QString(c));
        QCoreApplication::sendEvent(widget, &press);
        QKeyEvent release(QEvent::KeyRelease, key, Qt::NoModifier, QString(c));
        QCoreApplication::sendEvent(widget, &release);
    }
}

bool wheel(QWidget* widget, const QPoint& position, int notches, Qt::KeyboardModifiers modifiers) {
    QWheelEvent event(position, widget->mapToGlobal(position), {}, {0, 120 * notches}, Qt::NoButton,
                      modifiers, Qt::NoScrollPhase, false);
    QCoreApplication::sendEvent(widget, &event);
    return event.isAccepted();
}

QPoint handleCenter(QSlider* slider) {
    QStyleOptionSlider option;
    option.initFrom(slider);
    option.minimum = slider->minimum();
    option.maximum = slider->maximum();
    option.sliderPosition = option.sliderValue = slider->sliderPosition();
    return slider->style()
        ->subControlRect(QStyle::CC_Slider, &option, QStyle::SC_SliderHandle, slider)
        .center();
}

void dragSlider(QSlider* slider, int pixels, int steps, bool release) {
    const QPoint from = handleCenter(slider);
    QTest::mousePress(slider, Qt::LeftButton, {}, from);
    for (int i = 1; i <= steps; ++i) {
        const QPoint at = from + QPoint(pixels * i / steps, 0);
        QMouseEvent move(QEvent::MouseMove, at, slider->mapToGlobal(at), Qt::NoButton, Qt::LeftButton,
                         Qt::NoModifier);
        QCoreApplication::sendEvent(slider, &move);
        QTest::qWait(2);
    }
    if (release) QTest::mouseRelease(slider, Qt::LeftButton, {}, from + QPoint(pixels, 0));
}

bool showActive(QWidget* widget) {
    widget->show();
    widget->activateWindow();
    return QTest::qWaitForWindowActive(widget);
}

}  // namespace isoscope::test
