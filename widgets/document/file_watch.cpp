// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/document/file_watch.h"

#include <QFileInfo>

namespace isoscope {

FileWatch::FileWatch(QObject* parent) : QObject(parent) {
    timer_.setSingleShot(true);
    timer_.setInterval(pause);
    connect(&timer_, &QTimer::timeout, this, [this] {
        renew();
        emit touched();
    });
    for (auto signal : {&QFileSystemWatcher::fileChanged, &QFileSystemWatcher::directoryChanged})
        connect(&watcher_, signal, this, [this] { timer_.start(); });
}

void FileWatch::watch(const QString& path) {
    if (path == path_) return;
    path_ = path;
    timer_.stop();
    renew();
}

void FileWatch::renew() {
    // A file that was replaced is another one under the old name.
    const QStringList old = watcher_.files() + watcher_.directories();
    if (!old.isEmpty()) watcher_.removePaths(old);
    if (path_.isEmpty()) return;
    // Without the folder a removed file would never come back, nor a removed folder without the one around
    // it.
    QString folder = QFileInfo(path_).path();
    while (!QFileInfo::exists(folder) && QFileInfo(folder).path() != folder)
        folder = QFileInfo(folder).path();
    QStringList paths{folder};
    if (QFileInfo::exists(path_)) paths << path_;
    watcher_.addPaths(paths);
}

}  // namespace isoscope
