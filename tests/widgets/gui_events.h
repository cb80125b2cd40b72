// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QPoint>
#include <QSlider>
#include <QString>
#include <QWidget>

namespace isoscope::test {

/// Types any text; QTest::keyClicks stops the program at characters outside Latin-1.
void type(QWidget* widget, const QString& text);

/// Turns the wheel by whole notches; true when somebody took the event.
bool wheel(QWidget* widget, const QPoint& position, int notches, Qt::KeyboardModifiers modifiers = {});

/// Where the handle is, in the slider.
QPoint handleCenter(QSlider* slider);

/// Drags the handle with the mouse, in steps; the button stays down when `release` is false.
void dragSlider(QSlider* slider, int pixels, int steps = 20, bool release = true);

/// Whether the widget is on screen and has the focus, for keys that depend on it.
bool showActive(QWidget* widget);

}  // namespace isoscope::test
