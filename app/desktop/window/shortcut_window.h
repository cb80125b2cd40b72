// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QDialog>
#include <QString>
#include <vector>

class QLineEdit;
class QMenuBar;
class QTreeWidget;

namespace isoscope {

/// A command and what calls it: a line of the shortcut window.
struct ShortcutRow {
    QString name;
    QString keys;
};

/// Commands of one menu or one part of the window, under its name.
struct ShortcutGroup {
    QString title;
    std::vector<ShortcutRow> rows;
};

/// All commands of the menus that have keys, by menu and under the menu's names; the editor's own keys; and
/// what keys and mouse do in picture, text and panels.
std::vector<ShortcutGroup> shortcutGroups(const QMenuBar* menus);

/// Shows shortcutGroups() with a field to search them. Deletes itself when closed.
class ShortcutWindow : public QDialog {
    Q_OBJECT
  public:
    ShortcutWindow(const QMenuBar* menus, QWidget* parent);

  private:
    void fill(const QMenuBar* menus);
    /// Shows the lines in which every word occurs.
    void filter(const QString& words);

    QLineEdit* search_ = nullptr;
    QTreeWidget* table_ = nullptr;
};

}  // namespace isoscope
