// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QDialog>
#include <QString>
#include <vector>

class QAction;
class QKeySequenceEdit;
class QLabel;
class QLineEdit;
class QMenuBar;
class QPushButton;
class QTreeWidget;
class QTreeWidgetItem;

namespace isoscope {

class CommandKeys;

/// A command and what calls it: a line of the shortcut window.
struct ShortcutRow {
    QString name;
    QString keys;
    QAction* action = nullptr;  ///< whose keys can be changed; null for what mouse and text do
};

/// Commands of one menu or one part of the window, under its name.
struct ShortcutGroup {
    QString title;
    std::vector<ShortcutRow> rows;
};

/// All commands of the menus that have keys or may have some, by menu and under the menu's names; the
/// editor's own keys; and what keys and mouse do in picture, text and panels. Commands that `editable` does
/// not contain are there when they have keys.
std::vector<ShortcutGroup> shortcutGroups(const QMenuBar* menus, const QList<QAction*>& editable);

/// Shows shortcutGroups() with a field to search them. Below the list the keys of the current command can be
/// changed, taken away and set back; what already has the keys that are typed is told before they are taken
/// from it. Deletes itself when closed.
class ShortcutWindow : public QDialog {
    Q_OBJECT
  public:
    /// `keys` lives as long as the window.
    ShortcutWindow(const QMenuBar* menus, const QList<QAction*>& editable, CommandKeys* keys,
                   QWidget* parent);

    /// Makes the line of a command the current one, and puts the focus into the field of its keys.
    void edit(QAction* action);

  private:
    void build();
    QWidget* buildEditor();
    void fill(const QMenuBar* menus, const QList<QAction*>& editable);
    void widen();
    void showKeys();
    /// Of the current line.
    QAction* action() const;
    void showCurrent();
    /// Says what the keys in the field would do.
    void judge();
    void assign();
    /// Shows the lines in which every word occurs.
    void filter(const QString& words);

    QLineEdit* search_ = nullptr;
    QTreeWidget* table_ = nullptr;
    CommandKeys* keys_;
    QLabel* name_ = nullptr;
    QKeySequenceEdit* field_ = nullptr;
    QPushButton *set_ = nullptr, *remove_ = nullptr, *reset_ = nullptr, *resetAll_ = nullptr;
    QLabel* verdict_ = nullptr;
    QList<QAction*> actions_;  ///< of the lines, by the numbers that these bear
};

}  // namespace isoscope
