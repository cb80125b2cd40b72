// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QFileSystemWatcher>
#include <QObject>
#include <QTimer>

namespace isoscope {

/// Says when something may have happened to a file: written in place, replaced by another, removed or back
/// again. What did happen is the receiver's to look at; file systems that tell nothing (some of the network)
/// stay silent.
class FileWatch : public QObject {
    Q_OBJECT
  public:
    explicit FileWatch(QObject* parent = nullptr);

    /// Empty: none.
    void watch(const QString& path);

    /// Programs that save in several steps are waited for, in milliseconds.
    static constexpr int pause = 100;

  signals:
    /// Something happened to the file, or may have; emitted once, `pause` after the last event of a series.
    void touched();

  private:
    void renew();

    QString path_;
    QFileSystemWatcher watcher_;
    QTimer timer_;
};

}  // namespace isoscope
