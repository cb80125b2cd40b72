// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/desktop/window/shortcut_router.h"

#include <algorithm>
#include <QAbstractSpinBox>
#include <QAction>
#include <QApplication>
#include <QDockWidget>
#include <QKeyEvent>
#include <QLabel>
#include <QLineEdit>
#include <QMainWindow>

#include "app/desktop/window/actions.h"
#include "widgets/editor/editor_keys.h"

namespace isoscope {

ShortcutRouter::ShortcutRouter(QMainWindow* window, const Actions* actions)
    : QObject(window), window_(window), actions_(actions) {
    qApp->installEventFilter(this);
}

bool ShortcutRouter::isFieldCommand(const QWidget* focus, const QKeyEvent& event) {
    const auto is = [&](std::initializer_list<QKeySequence::StandardKey> keys) {
        return std::any_of(keys.begin(), keys.end(), [&](auto key) { return event.matches(key); });
    };
    if (qobject_cast<const QLabel*>(focus)) return is({QKeySequence::Copy, QKeySequence::SelectAll});
    const bool number = qobject_cast<const QAbstractSpinBox*>(focus) != nullptr;
    if (!number && !qobject_cast<const QLineEdit*>(focus)) return false;
    return is({QKeySequence::Cut, QKeySequence::Copy, QKeySequence::Paste, QKeySequence::SelectAll}) ||
           (!number && is({QKeySequence::Undo, QKeySequence::Redo}));
}

bool ShortcutRouter::isCommand(const QKeyEvent& event) const {
    // A letter in a field is a letter, also where it is a command elsewhere.
    if (typesText(event) && event.key() < Qt::Key_Escape) return false;
    const QKeySequence keys(
        QKeyCombination(event.modifiers() & ~Qt::KeypadModifier, static_cast<Qt::Key>(event.key())));
    return std::any_of(actions_->all().begin(), actions_->all().end(), [&](const QAction* action) {
        return action->isEnabled() && action->shortcuts().contains(keys);
    });
}

bool ShortcutRouter::eventFilter(QObject* watched, QEvent* event) {
    if (event->type() != QEvent::ShortcutOverride) return false;
    const auto* widget = qobject_cast<QWidget*>(watched);
    const auto& key = *static_cast<QKeyEvent*>(event);
    const bool ours = widget && (widget->window() == window_ || qobject_cast<QDockWidget*>(widget->window()));
    if (!ours || isFieldCommand(widget, key) || !isCommand(key)) return false;
    event->ignore();
    return true;
}

}  // namespace isoscope
