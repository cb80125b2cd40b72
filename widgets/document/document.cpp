// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/document/document.h"

#include <sys/stat.h>

#include <QCryptographicHash>
#include <QFile>
#include <QFileInfo>
#include <QStringDecoder>
#include <QStringEncoder>

#include "core/text/whole_file.h"

namespace isoscope {
namespace {

const QByteArray utf8Mark("\xef\xbb\xbf");

/// The line end that all lines of the text have; "\n" for none or several kinds.
QString commonLineEnd(const QString& text) {
    const qsizetype both = text.count("\r\n");
    const qsizetype returns = text.count('\r');
    const qsizetype feeds = text.count('\n');
    if (both > 0 && returns == both && feeds == both) return "\r\n";
    if (returns > 0 && feeds == 0) return "\r";
    return "\n";
}

bool fitsLatin1(const QString& text) {
    for (const QChar character : text)
        if (character.unicode() > 0xff) return false;
    return true;
}

}  // namespace

Document::Document(QObject* parent) : QObject(parent) {}

QString Document::name() const {
    if (!filePath_.isEmpty()) return QFileInfo(filePath_).fileName();
    return unsavedName_.isEmpty() ? tr("Untitled") : unsavedName_;
}

QString Document::title() const { return name() + "[*]"; }

void Document::reset(const QString& name) {
    filePath_.clear();
    unsavedName_ = name;
    errorText_.clear();
    lineEnd_ = "\n";
    encoding_ = Encoding::utf8;
    modified_ = missing_ = apart_ = false;
    emit changed();
}

Document::Stamp Document::stampOf(const QString& path) {
    struct stat state;
    if (::stat(QFile::encodeName(path).constData(), &state) != 0) return {};
#ifdef __APPLE__
    const timespec& time = state.st_mtimespec;
#else
    const timespec& time = state.st_mtim;
#endif
    return {state.st_size, time.tv_sec, time.tv_nsec, state.st_ino};
}

Document::Content Document::contentOf(const QString& path) {
    Content content;
    // Before reading: what changes meanwhile is noticed later.
    content.stamp = stampOf(path);
    QFile file(path);
    if (QFileInfo(path).isDir()) {
        content.problem = tr("%1 is a folder.").arg(path);
        return content;
    }
    if (file.open(QIODevice::ReadOnly)) {
        // One byte more than allowed: devices and growing files have no size to be asked for.
        content.bytes = file.read(sizeLimit + 1);
        if (content.bytes.size() > sizeLimit)
            content.problem = tr("%1 is larger than %2 MB: no scene text.").arg(path).arg(sizeLimit >> 20);
    }
    if (file.error() != QFileDevice::NoError)
        content.problem = tr("%1 cannot be read: %2.").arg(path, file.errorString());
    return content;
}

void Document::remember(const QByteArray& bytes, const Stamp& stamp) {
    digest_ = QCryptographicHash::hash(bytes, QCryptographicHash::Sha256);
    stamp_ = stamp;
    missing_ = apart_ = false;
}

std::optional<QString> Document::load(const QString& path) {
    const Content content = contentOf(path);
    errorText_ = content.problem;
    if (!content.problem.isEmpty()) return std::nullopt;
    auto [text, encoding] = decoded(content.bytes);
    lineEnd_ = commonLineEnd(text);
    if (lineEnd_ != "\n") text.replace(lineEnd_, "\n");
    encoding_ = encoding;
    filePath_ = QFileInfo(path).absoluteFilePath();
    modified_ = false;
    remember(content.bytes, content.stamp);
    emit changed();
    return text;
}

Document::Decoded Document::decoded(QByteArray bytes) {
    Encoding encoding = Encoding::utf8;
    if (bytes.startsWith(utf8Mark)) {
        encoding = Encoding::utf8WithMark;
        bytes.remove(0, utf8Mark.size());
    }
    QStringDecoder decoder(QStringDecoder::Utf8, QStringConverter::Flag::Stateless);
    QString text = decoder(bytes);
    if (!decoder.hasError()) return {text, encoding};
    // Older scenes are in Latin-1; any other bytes come back unchanged from it, too.
    if (encoding == Encoding::utf8WithMark) bytes.prepend(utf8Mark);
    return {QString::fromLatin1(bytes), Encoding::latin1};
}

bool Document::save(const QString& path, const QString& text) {
    errorText_.clear();
    QString written = text;
    if (lineEnd_ != "\n") written.replace("\n", lineEnd_);
    const Encoding encoding = encoding_ == Encoding::latin1 && !fitsLatin1(text) ? Encoding::utf8 : encoding_;
    QByteArray bytes = encoding == Encoding::latin1 ? written.toLatin1() : written.toUtf8();
    if (encoding == Encoding::utf8WithMark) bytes.prepend(utf8Mark);

    const std::string reason =
        writeWhole(QFile::encodeName(path).toStdString(), {bytes.constData(), std::size_t(bytes.size())});
    if (!reason.empty()) {
        errorText_ = tr("%1 cannot be written: %2.").arg(path, QString::fromLocal8Bit(reason));
        return false;
    }
    encoding_ = encoding;
    filePath_ = QFileInfo(path).absoluteFilePath();
    modified_ = false;
    remember(bytes, stampOf(path));
    emit changed();
    return true;
}

Document::OnDisk Document::onDisk(bool thorough) const {
    if (filePath_.isEmpty()) return OnDisk::same;
    const Stamp stamp = stampOf(filePath_);
    if (stamp.size < 0) return OnDisk::missing;
    if (!thorough && stamp == stamp_) return OnDisk::same;
    const Content content = contentOf(filePath_);
    if (!content.problem.isEmpty()) return QFile::exists(filePath_) ? OnDisk::changed : OnDisk::missing;
    if (QCryptographicHash::hash(content.bytes, QCryptographicHash::Sha256) != digest_)
        return OnDisk::changed;
    stamp_ = content.stamp;
    return OnDisk::same;
}

std::optional<QString> Document::textOnDisk() const {
    const Content content = contentOf(filePath_);
    if (!content.problem.isEmpty()) return std::nullopt;
    QString text = decoded(content.bytes).text;
    if (const QString lineEnd = commonLineEnd(text); lineEnd != "\n") text.replace(lineEnd, "\n");
    return text;
}

QByteArray Document::diskDigest() const {
    const Content content = contentOf(filePath_);
    return content.problem.isEmpty() ? QCryptographicHash::hash(content.bytes, QCryptographicHash::Sha256)
                                     : QByteArrayLiteral("none");
}

void Document::acceptDisk() {
    const Content content = contentOf(filePath_);
    if (!content.problem.isEmpty()) return;
    remember(content.bytes, content.stamp);
    apart_ = true;
    emit changed();
}

void Document::setDigest(const QByteArray& digest) {
    digest_ = digest;
    stamp_ = {};
}

void Document::setMissing(bool missing) {
    if (missing == missing_) return;
    missing_ = missing;
    emit changed();
}

void Document::setModified(bool modified) {
    if (modified == modified_) return;
    modified_ = modified;
    emit changed();
}

}  // namespace isoscope
