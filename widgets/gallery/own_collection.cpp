// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/gallery/own_collection.h"

#include <QDir>
#include <QFile>
#include <QSaveFile>
#include <QStandardPaths>
#include <QUrl>
#include <utility>

#include "widgets/gallery/gallery_sources.h"

namespace isoscope {
namespace {

/// Longer titles make no better names, and encoded ones would not fit a file system.
constexpr qsizetype longestTitle = 60;

const QString ending = QStringLiteral(".scene");

}  // namespace

OwnCollection::OwnCollection(QString folder)
    : folder_(folder.isEmpty()
                  ? QStandardPaths::writableLocation(QStandardPaths::AppDataLocation) + "/collection"
                  : std::move(folder)) {}

QString OwnCollection::pathOf(const QString& title) const {
    return folder_ + QLatin1Char('/') + QString::fromLatin1(QUrl::toPercentEncoding(title, {}, ".")) + ending;
}

QList<GalleryEntry> OwnCollection::entries() const {
    QList<GalleryEntry> entries;
    const QDir folder(folder_);
    for (const QString& name : folder.entryList({QLatin1Char('*') + ending}, QDir::Files, QDir::Name)) {
        QFile file(folder.filePath(name));
        if (!file.open(QIODevice::ReadOnly)) continue;
        const QString text = QString::fromUtf8(file.readAll());
        const QString title = QUrl::fromPercentEncoding(name.chopped(ending.size()).toLatin1());
        entries.append({GalleryEntry::Kind::own, title, firstComment(text), text, nullptr, file.fileName(),
                        false, true});
    }
    return entries;
}

QString OwnCollection::freePath(const QString& title) const {
    const QString wanted = title.simplified().left(longestTitle);
    QString path = pathOf(wanted);
    for (int number = 2; QFile::exists(path); ++number)
        path = pathOf(QStringLiteral("%1 (%2)").arg(wanted).arg(number));
    return path;
}

bool OwnCollection::add(const QString& title, const QString& text) const {
    QDir().mkpath(folder_);
    QSaveFile file(freePath(title));
    const QByteArray bytes = text.toUtf8();
    return file.open(QIODevice::WriteOnly) && file.write(bytes) == bytes.size() && file.commit();
}

bool OwnCollection::rename(const QString& file, const QString& title) const {
    return isOwn(file) && !title.simplified().isEmpty() && QFile::rename(file, freePath(title));
}

bool OwnCollection::remove(const QString& file) const { return isOwn(file) && QFile::remove(file); }

bool OwnCollection::isOwn(const QString& file) const {
    return QFileInfo(file).absolutePath() == QDir(folder_).absolutePath();
}

}  // namespace isoscope
