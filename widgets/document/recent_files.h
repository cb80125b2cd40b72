// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QStringList>

class QMenu;

namespace isoscope {

/// The files opened last, newest first, kept in QSettings under "recentFiles".
class RecentFiles : public QObject {
    Q_OBJECT
  public:
    explicit RecentFiles(QObject* parent = nullptr);

    static constexpr int limit = 10;

    /// Absolute paths; files that are gone stay listed until they fail to open.
    QStringList paths() const { return paths_; }
    void add(const QString& path);
    void remove(const QString& path);
    void clear();

    /// Keeps the menu filled with numbered entries and "Clear list"; an empty list shows a disabled line.
    void fill(QMenu* menu);

  signals:
    /// An entry of a menu was chosen; `path` is absolute.
    void openRequested(const QString& path);
    /// The list was changed, and is stored.
    void changed();

  private:
    void store();
    void rebuild(QMenu* menu);

    QStringList paths_;
};

}  // namespace isoscope
