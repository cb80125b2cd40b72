// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/pictures/picture_mime.h"

#include <QBuffer>
#include <QFile>
#include <QImage>
#include <QMimeData>
#include <QTemporaryDir>
#include <QUrl>

namespace isoscope {

namespace {

QByteArray pngOf(const QImage& picture) {
    QByteArray bytes;
    QBuffer buffer(&bytes);
    picture.save(&buffer, "PNG");
    return bytes;
}

const QString pngType = QStringLiteral("image/png");

}  // namespace

std::unique_ptr<QMimeData> pictureMimeData(const QImage& picture) {
    auto data = std::make_unique<QMimeData>();
    data->setImageData(picture);
    data->setData(pngType, pngOf(picture));
    return data;
}

std::unique_ptr<QMimeData> pictureFileMimeData(const QImage& picture, const QString& name) {
    std::unique_ptr<QMimeData> data = pictureMimeData(picture);
    // One folder for each drop: a program may read the file of the last one still.
    static std::vector<std::unique_ptr<QTemporaryDir>> folders;
    auto& folder = folders.emplace_back(std::make_unique<QTemporaryDir>());
    QFile file(folder->filePath(name + QStringLiteral(".png")));
    const QByteArray bytes = data->data(pngType);
    if (folder->isValid() && file.open(QIODevice::WriteOnly) && file.write(bytes) == bytes.size())
        data->setUrls({QUrl::fromLocalFile(file.fileName())});
    return data;
}

}  // namespace isoscope
