// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/document/recovery_store.h"

#include <algorithm>
#include <QCoreApplication>
#include <QDir>
#include <QJsonDocument>
#include <QJsonObject>
#include <QStandardPaths>
#include <QUuid>

#include "core/text/whole_file.h"

namespace isoscope {
namespace {

std::unique_ptr<QLockFile> lockFor(const QString& copy) {
    auto lock = std::make_unique<QLockFile>(copy + ".lock");
    // A long session is no stale one; a dead process is noticed at any age.
    lock->setStaleLockTime(0);
    return lock;
}

bool tryLock(QLockFile& lock) {
    if (lock.tryLock(0)) return true;
    qint64 process = 0;
    QString host, program;
    // A dead instance that had our process number (the rule in containers) looks alive to QLockFile. Removing
    // checks the kernel's lock, which only a living holder has.
    if (!lock.getLockInfo(&process, &host, &program) || process != QCoreApplication::applicationPid())
        return false;
    return lock.removeStaleLockFile() && lock.tryLock(0);
}

}  // namespace

RecoveryStore::RecoveryStore(Snapshot snapshot, QString folder, QObject* parent)
    : QObject(parent),
      snapshot_(std::move(snapshot)),
      folder_(folder.isEmpty()
                  ? QStandardPaths::writableLocation(QStandardPaths::AppDataLocation) + "/recovery"
                  : std::move(folder)),
      id_(QUuid::createUuid().toString(QUuid::WithoutBraces)) {
    timer_.setSingleShot(true);
    timer_.setInterval(interval);
    connect(&timer_, &QTimer::timeout, this, &RecoveryStore::flush);
    removeOld();
}

RecoveryStore::~RecoveryStore() = default;

std::vector<UnsavedText> RecoveryStore::abandoned() const {
    std::vector<UnsavedText> found;
    for (const QFileInfo& file : QDir(folder_).entryInfoList({"*.json"}, QDir::Files)) {
        const QString id = file.completeBaseName();
        if (id == id_) continue;
        const auto lock = lockFor(path(id));
        if (!tryLock(*lock)) continue;
        if (auto text = read(id)) found.push_back(*std::move(text));
    }
    std::sort(found.begin(), found.end(),
              [](const UnsavedText& a, const UnsavedText& b) { return a.saved > b.saved; });
    return found;
}

std::optional<UnsavedText> RecoveryStore::take(const QString& id) {
    if (id == id_) return std::nullopt;
    auto lock = lockFor(path(id));
    if (!tryLock(*lock)) return std::nullopt;
    auto text = read(id);
    if (!text) return std::nullopt;
    timer_.stop();
    waiting_ = false;
    if (lock_) QFile::remove(path(id_));
    lock_ = std::move(lock);
    id_ = id;
    return text;
}

void RecoveryStore::discard(const QString& id) {
    if (id == id_) return;
    const auto lock = lockFor(path(id));
    if (tryLock(*lock)) QFile::remove(path(id));
}

void RecoveryStore::textChanged() {
    // Not restarted by later changes: somebody who types without a pause is kept safe, too.
    waiting_ = true;
    if (!timer_.isActive()) timer_.start();
}

void RecoveryStore::flush() {
    timer_.stop();
    if (!waiting_) return;
    UnsavedText text = snapshot_();
    text.saved = QDateTime::currentDateTimeUtc();
    // A failed copy stays due: the next change or loss of focus tries again.
    waiting_ = !write(text);
    if (waiting_)
        emit failed(errorText_);
    else
        emit kept();
}

void RecoveryStore::markSaved() {
    timer_.stop();
    waiting_ = false;
    if (!lock_) return;
    QFile::remove(path(id_));
    lock_.reset();
    // A new name: another instance may be looking at the old one just now.
    id_ = QUuid::createUuid().toString(QUuid::WithoutBraces);
    emit kept();
}

QString RecoveryStore::path(const QString& id) const { return folder_ + '/' + id + ".json"; }

bool RecoveryStore::write(const UnsavedText& text) {
    errorText_.clear();
    const auto fail = [this](const QString& reason) {
        errorText_ = tr("Unsaved text cannot be kept in %1: %2.").arg(folder_, reason);
        return false;
    };
    if (!makeFolder()) return fail(tr("the folder cannot be made"));
    if (!lock_) {
        auto lock = lockFor(path(id_));
        if (!tryLock(*lock)) return fail(tr("its lock cannot be taken"));
        lock_ = std::move(lock);
    }
    const QJsonObject object{{"filePath", text.filePath},
                             {"base", QString::fromLatin1(text.base.toHex())},
                             {"saved", text.saved.toString(Qt::ISODateWithMs)},
                             {"text", text.text}};
    const QByteArray bytes = QJsonDocument(object).toJson();
    // Safe from a kill at once; waiting for the disk every second would be felt.
    const std::string reason =
        writeWhole(QFile::encodeName(path(id_)).toStdString(), {bytes.constData(), std::size_t(bytes.size())},
                   {.ownerOnly = true, .durable = false});
    return reason.empty() || fail(QString::fromLocal8Bit(reason));
}

bool RecoveryStore::makeFolder() const {
    if (!QDir().mkpath(folder_)) return false;
    // Earlier versions let everybody read it. Not every file system knows modes.
    QFile::setPermissions(folder_, QFile::ReadOwner | QFile::WriteOwner | QFile::ExeOwner);
    return true;
}

std::optional<UnsavedText> RecoveryStore::read(const QString& id) const {
    QFile file(path(id));
    if (!file.open(QIODevice::ReadOnly)) return std::nullopt;
    const QJsonObject object = QJsonDocument::fromJson(file.readAll()).object();
    if (!object.value("text").isString()) return std::nullopt;
    UnsavedText text;
    text.id = id;
    text.filePath = object.value("filePath").toString();
    text.text = object.value("text").toString();
    text.base = QByteArray::fromHex(object.value("base").toString().toLatin1());
    text.saved = QDateTime::fromString(object.value("saved").toString(), Qt::ISODateWithMs);
    return text;
}

/// When the copies that are there now were first offered, at an earlier start that is a day ago at least;
/// none where there was no such start. Whoever comes back after months, or whose clock was wrong, is offered
/// a text before it is old.
QDateTime RecoveryStore::beginOffer() const {
    QFile stamp(folder_ + "/offered");
    const QDateTime now = QDateTime::currentDateTimeUtc(), before = QFileInfo(stamp).lastModified();
    if (before.isValid() && before <= now && before.addDays(1) > now) return {};
    if (stamp.open(QIODevice::WriteOnly)) stamp.setFileTime(now, QFileDevice::FileModificationTime);
    return before.isValid() && before <= now ? before : QDateTime();
}

void RecoveryStore::removeOld() const {
    if (QDir(folder_).entryList({"*.json", "*.json.lock"}, QDir::Files).isEmpty()) {
        QFile::remove(folder_ + "/offered");
        return;
    }
    const QDateTime offered = beginOffer();
    for (const QFileInfo& file : QDir(folder_).entryInfoList({"*.json"}, QDir::Files)) {
        if (!offered.isValid() || file.lastModified() >= offered.addDays(-keptDays)) continue;
        const auto lock = lockFor(file.absoluteFilePath());
        if (tryLock(*lock)) QFile::remove(file.absoluteFilePath());
    }
    // Locks of instances that died between locking and writing.
    for (const QFileInfo& file : QDir(folder_).entryInfoList({"*.json.lock"}, QDir::Files)) {
        const QString copy = file.absolutePath() + '/' + file.completeBaseName();
        if (QFile::exists(copy)) continue;
        const auto lock = lockFor(copy);
        if (tryLock(*lock)) lock->unlock();
    }
}

}  // namespace isoscope
