// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/document.h"

#include <QFile>
#include <QFileInfo>
#include <QSaveFile>
#include <QStringDecoder>
#include <QStringEncoder>

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
    return filePath_.isEmpty() ? tr("Untitled") : QFileInfo(filePath_).fileName();
}

QString Document::title() const { return name() + "[*]"; }

void Document::reset() {
    filePath_.clear();
    errorText_.clear();
    lineEnd_ = "\n";
    encoding_ = Encoding::utf8;
    modified_ = false;
    emit changed();
}

std::optional<QString> Document::load(const QString& path) {
    errorText_.clear();
    QFile file(path);
    if (QFileInfo(path).isDir()) {
        errorText_ = tr("%1 is a folder.").arg(path);
        return std::nullopt;
    }
    if (!file.open(QIODevice::ReadOnly)) {
        errorText_ = tr("%1 cannot be read: %2.").arg(path, file.errorString());
        return std::nullopt;
    }
    // One byte more than allowed: devices and growing files have no size to be asked for.
    QByteArray bytes = file.read(sizeLimit + 1);
    if (file.error() != QFileDevice::NoError) {
        errorText_ = tr("%1 cannot be read: %2.").arg(path, file.errorString());
        return std::nullopt;
    }
    if (bytes.size() > sizeLimit) {
        errorText_ = tr("%1 is larger than %2 MB: no scene text.").arg(path).arg(sizeLimit >> 20);
        return std::nullopt;
    }

    Encoding encoding = Encoding::utf8;
    if (bytes.startsWith(utf8Mark)) {
        encoding = Encoding::utf8WithMark;
        bytes.remove(0, utf8Mark.size());
    }
    QStringDecoder decoder(QStringDecoder::Utf8, QStringConverter::Flag::Stateless);
    QString text = decoder(bytes);
    if (decoder.hasError()) {
        // Older scenes are in Latin-1; any other bytes come back unchanged from it, too.
        if (encoding == Encoding::utf8WithMark) bytes.prepend(utf8Mark);
        encoding = Encoding::latin1;
        text = QString::fromLatin1(bytes);
    }

    lineEnd_ = commonLineEnd(text);
    if (lineEnd_ != "\n") text.replace(lineEnd_, "\n");
    encoding_ = encoding;
    filePath_ = QFileInfo(path).absoluteFilePath();
    modified_ = false;
    emit changed();
    return text;
}

bool Document::save(const QString& path, const QString& text) {
    errorText_.clear();
    QString written = text;
    if (lineEnd_ != "\n") written.replace("\n", lineEnd_);
    const Encoding encoding = encoding_ == Encoding::latin1 && !fitsLatin1(text) ? Encoding::utf8 : encoding_;
    QByteArray bytes = encoding == Encoding::latin1 ? written.toLatin1() : written.toUtf8();
    if (encoding == Encoding::utf8WithMark) bytes.prepend(utf8Mark);

    QSaveFile file(path);
    if (!file.open(QIODevice::WriteOnly) || file.write(bytes) != bytes.size() || !file.commit()) {
        errorText_ = tr("%1 cannot be written: %2.").arg(path, file.errorString());
        return false;
    }
    encoding_ = encoding;
    filePath_ = QFileInfo(path).absoluteFilePath();
    modified_ = false;
    emit changed();
    return true;
}

void Document::setModified(bool modified) {
    if (modified == modified_) return;
    modified_ = modified;
    emit changed();
}

}  // namespace isoscope
