// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/click_detector.h"

#include <QGuiApplication>
#include <QMouseEvent>
#include <QStyleHints>

namespace isoscope {

bool ClickDetector::press(const QMouseEvent& event) {
    constexpr Qt::MouseButtons known = Qt::LeftButton | Qt::MiddleButton | Qt::RightButton;
    if (button_ != Qt::NoButton && !lost(event)) return false;
    if (!known.testFlag(event.button())) return false;
    // Two quick strokes from the same place look like a double click to Qt.
    const auto since = static_cast<qint64>(event.timestamp() - released_);
    const bool behindDrag = dragged_ && since < QGuiApplication::styleHints()->mouseDoubleClickInterval();
    second_ = event.type() == QEvent::MouseButtonDblClick && !behindDrag;
    dragged_ = false;
    button_ = event.button();
    pressed_ = event.position();
    return true;
}

bool ClickDetector::move(const QMouseEvent& event) {
    if (button_ == Qt::NoButton) return false;
    dragged_ = dragged_ || (event.position() - pressed_).manhattanLength() >= reach;
    return dragged_;
}

std::optional<ClickDetector::Outcome> ClickDetector::release(const QMouseEvent& event) {
    if (button_ == Qt::NoButton || event.button() != button_) return std::nullopt;
    move(event);
    button_ = Qt::NoButton;
    released_ = event.timestamp();
    return dragged_ ? Outcome::drag : second_ ? Outcome::doubleClick : Outcome::click;
}

bool ClickDetector::lost(const QMouseEvent& event) const {
    // A press has its own button among those held: of that one the release was missed.
    return button_ != Qt::NoButton && (!event.buttons().testFlag(button_) || event.button() == button_);
}

void ClickDetector::cancel() {
    button_ = Qt::NoButton;
    dragged_ = true;
}

}  // namespace isoscope
