// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QPoint>
#include <QString>
#include <QStringList>

class QWidget;

namespace isoscope::test {

/// Mouse and keys as a hand gives them: through the X server (xdotool), past the window manager, to whatever
/// window is there. The event loop runs meanwhile; what the program makes of it may still be a queued signal
/// away, so wait for facts (QTRY_VERIFY). `held` names modifiers that are down: "ctrl", "ctrl+shift".
class RealInput {
  public:
    enum Button { left = 1, middle = 2, right = 3 };

    /// False where there is no such display: skip the test.
    static bool available();

    void moveTo(const QWidget* widget, QPoint at) const;
    void click(const QWidget* widget, QPoint at, Button button = left) const;
    /// Where a busy machine parted the presses by more than Qt's interval, they are made again.
    void doubleClick(const QWidget* widget, QPoint at, Button button = left) const;
    /// Presses at `from`, goes by `by` in small steps and releases.
    void drag(const QWidget* widget, QPoint from, QPoint by, Button button = left,
              const QString& held = {}) const;
    /// Presses and goes, and leaves the button down; ended by release().
    void dragAndHold(const QWidget* widget, QPoint from, QPoint by, Button button = left,
                     const QString& held = {}) const;
    void release(Button button = left, const QString& held = {}) const;
    /// Notches: up is positive.
    void wheel(const QWidget* widget, QPoint at, int notches, const QString& held = {}) const;
    /// In X's names: "ctrl+shift+z", "Escape", "ctrl+plus".
    void key(const QString& combination) const;
    void type(const QString& text) const;

  private:
    static void run(const QStringList& arguments);
};

}  // namespace isoscope::test
