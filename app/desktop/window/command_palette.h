// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <QFrame>
#include <QList>
#include <QPointer>
#include <QString>

class QAction;
class QLineEdit;
class QMainWindow;
class QTreeWidget;

namespace isoscope {

/// A command of the menus: where it stands, “View › Theme › Dark”, what it tells of itself, and what it does.
struct PaletteCommand {
    QString path;
    QString help;  ///< plain text
    QAction* action;
};

/// How well what was typed names a command: 0 it is the name at the end of `path`, or empty; 1 that name
/// begins with it; 2 each of its words begins a word of `path`; 3 each is found in it; 4 each begins a word
/// of `path` or of `help`; 5 the letters of each are found in their order. Nothing where a letter is missing.
/// Upper and lower case are the same.
std::optional<int> paletteRank(const QString& path, const QString& typed, const QString& help = {});

/// All commands of the window's menus by words, over the top of the window: a field and the commands that it
/// names, best first, among equals those that were chosen last. Enter runs one with the focus where it was
/// before; Escape, a click elsewhere and any other loss of the focus close it. Deletes itself when closed.
class CommandPalette : public QFrame {
    Q_OBJECT
  public:
    /// Opens over `window`; one that is open is closed.
    static void toggle(QMainWindow* window);

    /// Paths of the commands in the list, best first.
    QStringList shown() const;

  protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

  private:
    explicit CommandPalette(QMainWindow* window);
    /// In the order of the menus.
    void collect();
    void fill(const QString& typed);
    void place();
    void move(int rows);
    /// The command of the current row; a row that cannot be chosen does nothing.
    void run();
    void leave();

    QMainWindow* window_;
    QPointer<QWidget> focusBefore_;
    QLineEdit* field_;
    QTreeWidget* list_;
    QList<PaletteCommand> commands_;
    QStringList recent_;  ///< paths, the last one first
};

}  // namespace isoscope
