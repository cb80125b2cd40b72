// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>

class QAction;
class QKeyEvent;
class QMainWindow;
class QWidget;

namespace isoscope {

class Actions;

/// Sees to it that the keys of a menu command reach it wherever the focus is in the window: no panel, slider
/// or number box keeps them for itself. What remains a text field's own are the clipboard commands, which act
/// on the field, and undo and redo, except in number boxes: their numbers are changes of the scene.
class ShortcutRouter : public QObject {
    Q_OBJECT
  public:
    ShortcutRouter(QMainWindow* window, const Actions* actions);

    /// Whether a press of these keys belongs to the field with the focus and not to the menu.
    static bool isFieldCommand(const QWidget* focus, const QKeyEvent& event);

  protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

  private:
    bool isCommand(const QKeyEvent& event) const;

    QMainWindow* window_;
    const Actions* actions_;
};

}  // namespace isoscope
