// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/document/history_store.h"

#include <QCryptographicHash>
#include <QDir>
#include <QFile>
#include <QStandardPaths>
#include <utility>

#include "core/text/whole_file.h"

namespace isoscope {

namespace {

/// Twice what a journal has at most.
constexpr qint64 largestFile = 4'000'000;

QString digestOf(const QString& text) {
    constexpr int digits = 32;
    return QString::fromLatin1(
        QCryptographicHash::hash(text.toUtf8(), QCryptographicHash::Sha256).toHex().left(digits));
}

QString fileOf(const QString& name, const QString& digest) {
    return QStringLiteral("%1-%2.steps").arg(name, digest);
}

}  // namespace

HistoryStore::HistoryStore(QString folder)
    : folder_(folder.isEmpty()
                  ? QStandardPaths::writableLocation(QStandardPaths::AppDataLocation) + "/history"
                  : std::move(folder)) {
    removeOld();
}

QString HistoryStore::nameOf(const QString& document) { return digestOf(document); }

bool HistoryStore::write(const QString& name, const QString& text, const QByteArray& steps) const {
    const QString file = fileOf(name, digestOf(text));
    const auto removeOthers = [&](const QString& kept) {
        for (const QString& other : QDir(folder_).entryList({fileOf(name, QStringLiteral("*"))}, QDir::Files))
            if (other != kept) QFile::remove(folder_ + '/' + other);
    };
    if (steps.isEmpty()) {
        removeOthers({});
        return true;
    }
    if (!QDir().mkpath(folder_)) return false;
    QFile::setPermissions(folder_, QFile::ReadOwner | QFile::WriteOwner | QFile::ExeOwner);
    // The old one stays until the new one is there.
    if (!writeWhole(QFile::encodeName(folder_ + '/' + file).toStdString(),
                    {steps.constData(), std::size_t(steps.size())}, {.ownerOnly = true, .durable = false})
             .empty())
        return false;
    removeOthers(file);
    return true;
}

std::optional<QByteArray> HistoryStore::find(const QString& name, const QString& text) const {
    const QString digest = digestOf(text);
    QStringList files{fileOf(name, digest)};
    files += QDir(folder_).entryList({fileOf(QStringLiteral("*"), digest)}, QDir::Files, QDir::Time);
    for (const QString& found : files) {
        QFile file(folder_ + '/' + found);
        if (file.size() <= largestFile && file.open(QIODevice::ReadOnly)) return file.readAll();
    }
    return {};
}

void HistoryStore::removeOld() const {
    const QStringList newestFirst = QDir(folder_).entryList({"*.steps"}, QDir::Files, QDir::Time);
    for (const QString& file : newestFirst.mid(mostFiles)) QFile::remove(folder_ + '/' + file);
}

}  // namespace isoscope
