// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/document/recent_files.h"

#include <QDir>
#include <QFileInfo>
#include <QMenu>
#include <QSettings>

namespace isoscope {
namespace {

const QString settingsKey = QStringLiteral("recentFiles");

/// The path with the home folder as ~, and & doubled because menus take it for a mnemonic.
QString menuText(int number, const QString& path) {
    QString shown = path;
    const QString home = QDir::homePath();
    if (shown.startsWith(home + '/')) shown.replace(0, home.size(), "~");
    shown.replace('&', "&&");
    const QString mark = number < 10 ? "&" + QString::number(number) : QString::number(number);
    return mark + "  " + shown;
}

}  // namespace

RecentFiles::RecentFiles(QObject* parent) : QObject(parent) {
    for (const QString& path : QSettings().value(settingsKey).toStringList())
        if (!path.isEmpty() && !paths_.contains(path) && paths_.size() < limit) paths_ << path;
}

void RecentFiles::add(const QString& path) {
    if (path.isEmpty()) return;
    const QString absolute = QFileInfo(path).absoluteFilePath();
    paths_.removeAll(absolute);
    paths_.prepend(absolute);
    while (paths_.size() > limit) paths_.removeLast();
    store();
}

void RecentFiles::remove(const QString& path) {
    if (paths_.removeAll(QFileInfo(path).absoluteFilePath()) > 0) store();
}

void RecentFiles::clear() {
    paths_.clear();
    store();
}

void RecentFiles::fill(QMenu* menu) {
    menu->setToolTipsVisible(true);
    rebuild(menu);
    connect(this, &RecentFiles::changed, menu, [this, menu] { rebuild(menu); });
}

void RecentFiles::store() {
    QSettings().setValue(settingsKey, paths_);
    emit changed();
}

void RecentFiles::rebuild(QMenu* menu) {
    menu->clear();
    int number = 0;
    for (const QString& path : paths_) {
        QAction* action = menu->addAction(menuText(++number, path));
        action->setToolTip(path);
        connect(action, &QAction::triggered, this, [this, path] { emit openRequested(path); });
    }
    if (paths_.isEmpty()) {
        menu->addAction(tr("No files yet"))->setEnabled(false);
        return;
    }
    menu->addSeparator();
    QAction* clearing = menu->addAction(tr("Clear list"));
    clearing->setToolTip(tr("Forget these files; nothing is deleted"));
    // Queued: the action must not be deleted while it is being triggered.
    connect(clearing, &QAction::triggered, this, &RecentFiles::clear, Qt::QueuedConnection);
}

}  // namespace isoscope
