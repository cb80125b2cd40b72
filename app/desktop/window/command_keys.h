// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QHash>
#include <QKeySequence>
#include <QList>
#include <QObject>
#include <QString>

class QAction;

namespace isoscope {

class Actions;

/// The keys of the window's commands as a person has chosen them: a command has one key or none beside those
/// that it comes with. No key calls two commands. What differs from what the program comes with is stored.
class CommandKeys : public QObject {
    Q_OBJECT
  public:
    /// Takes the present keys for those that the program comes with, then gives the stored ones.
    CommandKeys(const Actions* actions, QObject* parent);

    /// Why these keys can be no command's: letters, what the text needs; empty when they can.
    static QString refusal(const QKeySequence& keys);
    /// The command that these keys call now; null for none.
    QAction* owner(const QKeySequence& keys) const;
    /// Whether a command has the keys that it came with.
    bool isUsual(const QAction* action) const;

    /// The command gets these keys in place of all that it has; a command that had them loses them. Empty
    /// ones take its keys away. False, with nothing changed, where refusal() has a reason.
    bool assign(QAction* action, const QKeySequence& keys);
    /// Back to what the command came with; others that have these keys now lose them.
    void reset(QAction* action);
    /// All commands.
    void resetAll();

  signals:
    /// Keys of one or more commands.
    void changed();

  private:
    void read();
    void give(QAction* action, const QList<QKeySequence>& keys);
    void takeFromOthers(const QAction* action, const QList<QKeySequence>& keys);
    void store(const QAction* action) const;

    const Actions* actions_;
    QHash<const QAction*, QList<QKeySequence>> usual_;
};

}  // namespace isoscope
