// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <QPointF>

class QMouseEvent;

namespace isoscope {

/// Tells clicks from drags. A press that leaves its surroundings is a drag until its release, wherever that
/// happens; two presses are a double click only when neither of them was a drag. While a button is held, all
/// others count for nothing.
class ClickDetector {
  public:
    /// What a gesture was, from its press to its release.
    enum class Outcome { drag, click, doubleClick };

    /// A press that moves less than this, in pixels right or left and up or down together, is a click.
    static constexpr double reach = 4;

    /// Takes presses and what Qt calls double clicks (the second press). False for a press that counts for
    /// nothing: another button is held, or it is neither the left, the middle nor the right one.
    bool press(const QMouseEvent& event);
    /// Whether this is a drag by now.
    bool move(const QMouseEvent& event);
    /// Empty for the release of a button that does not count.
    std::optional<Outcome> release(const QMouseEvent& event);
    /// The release was delivered to no widget of the program: `event` has the button no longer.
    bool lost(const QMouseEvent& event) const;
    /// Ends the gesture as a drag.
    void cancel();

    /// Qt::NoButton between gestures.
    Qt::MouseButton button() const { return button_; }
    /// Where the latest press was.
    const QPointF& pressed() const { return pressed_; }

  private:
    Qt::MouseButton button_ = Qt::NoButton;
    QPointF pressed_;
    quint64 released_ = 0;  ///< when, by the events' clock
    bool dragged_ = false;
    bool second_ = false;  ///< press of a double click
};

}  // namespace isoscope
