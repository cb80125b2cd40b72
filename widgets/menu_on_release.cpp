// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/menu_on_release.h"

#include <QApplication>
#include <QContextMenuEvent>
#include <QMouseEvent>
#include <QTimer>
#include <QWidget>

#include "widgets/click_detector.h"

namespace isoscope {

MenuOnRelease::MenuOnRelease(QObject* parent) : QObject(parent) { qApp->installEventFilter(this); }

MenuOnRelease::~MenuOnRelease() = default;

bool MenuOnRelease::eventFilter(QObject* watched, QEvent* event) {
    switch (event->type()) {
        case QEvent::ContextMenu:
            return hold(qobject_cast<QWidget*>(watched), *static_cast<QContextMenuEvent*>(event));
        case QEvent::MouseButtonPress:
        case QEvent::MouseButtonDblClick:
            // A new gesture; or a second button, and the hand does something else than asking for a menu.
            asked_.reset();
            return false;
        case QEvent::MouseMove:
        case QEvent::MouseButtonRelease:
            if (asked_) follow(*static_cast<QMouseEvent*>(event));
            return false;
        default: return false;
    }
}

bool MenuOnRelease::hold(QWidget* widget, const QContextMenuEvent& event) {
    if (!widget || event.reason() != QContextMenuEvent::Mouse) return false;
    const Qt::MouseButtons held = QGuiApplication::mouseButtons();
    if (!held.testFlag(Qt::RightButton)) return false;
    // In the middle of a drag with another button a menu is not wanted.
    if (held != Qt::RightButton) return true;
    widget_ = widget;
    asked_ = std::make_unique<QContextMenuEvent>(event.reason(), event.pos(), event.globalPos(),
                                                 event.modifiers());
    return true;
}

void MenuOnRelease::follow(const QMouseEvent& event) {
    const QPointF way = event.globalPosition() - QPointF(asked_->globalPos());
    if (way.manhattanLength() >= ClickDetector::reach) return asked_.reset();
    if (event.type() != QEvent::MouseButtonRelease || event.button() != Qt::RightButton) return;
    // Behind the release, which the widget is to see first.
    QTimer::singleShot(0, this, [this, asked = std::shared_ptr<QContextMenuEvent>(std::move(asked_))] {
        if (widget_) QCoreApplication::sendEvent(widget_, asked.get());
    });
}

}  // namespace isoscope
