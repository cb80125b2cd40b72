// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/gallery/gallery_model.h"

#include <cmath>
#include <utility>

#include "widgets/thumbnail_renderer.h"

namespace isoscope {

GalleryModel::GalleryModel(QObject* parent) : QAbstractListModel(parent) {}

GalleryModel::~GalleryModel() = default;

void GalleryModel::setEntries(QList<GalleryEntry> entries) {
    beginResetModel();
    firstRequest_ += static_cast<int>(entries_.size());
    entries_ = std::move(entries);
    pictures_ = QList<QImage>(entries_.size());
    endResetModel();
}

QString GalleryModel::kindName(GalleryEntry::Kind kind) {
    switch (kind) {
        case GalleryEntry::Kind::function: return tr("Function");
        case GalleryEntry::Kind::pattern: return tr("Pattern");
        case GalleryEntry::Kind::example: return tr("Example");
        case GalleryEntry::Kind::povray: return tr("POV-Ray");
        case GalleryEntry::Kind::own: return tr("My collection");
        case GalleryEntry::Kind::lesson: return tr("Lesson");
    }
    return {};
}

void GalleryModel::startPictures(double devicePixelRatio) {
    if (renderer_) return;
    ratio_ = devicePixelRatio;
    renderer_ = new ThumbnailRenderer(static_cast<int>(std::lround(pictureSize * ratio_)), {}, this);
    connect(renderer_, &ThumbnailRenderer::ready, this, &GalleryModel::takePicture);
    if (rowCount() > 0) emit dataChanged(index(0), index(rowCount() - 1), {Qt::DecorationRole});
}

void GalleryModel::takePicture(int request, const QImage& image) {
    if (image.isNull()) return;
    ++rendered_;
    const int row = request - firstRequest_;
    if (row < 0 || row >= rowCount()) return;
    pictures_[row] = image;
    pictures_[row].setDevicePixelRatio(ratio_);
    emit dataChanged(index(row), index(row), {Qt::DecorationRole});
}

int GalleryModel::rowCount(const QModelIndex& parent) const {
    return parent.isValid() ? 0 : static_cast<int>(entries_.size());
}

QVariant GalleryModel::data(const QModelIndex& index, int role) const {
    if (!index.isValid() || index.row() >= rowCount()) return {};
    const GalleryEntry& entry = entries_[index.row()];
    switch (role) {
        case Qt::DisplayRole:
        case Qt::EditRole: return entry.title;
        case Qt::ToolTipRole:
            return QStringLiteral("<p><b>%1</b> (%2)</p><p>%3</p>")
                .arg(entry.title.toHtmlEscaped(), kindName(entry.kind), entry.sentence.toHtmlEscaped());
        case Qt::AccessibleTextRole:
            return QStringLiteral("%1, %2, %3").arg(entry.title, kindName(entry.kind), entry.sentence);
        case Qt::DecorationRole: return picture(index.row());
        case sentenceRole: return entry.sentence;
        case searchRole: return QStringList{entry.title, entry.sentence, kindName(entry.kind)}.join(' ');
        default: return {};
    }
}

Qt::ItemFlags GalleryModel::flags(const QModelIndex& index) const {
    const bool own = index.isValid() && entries_[index.row()].kind == GalleryEntry::Kind::own;
    return QAbstractListModel::flags(index) | (own ? Qt::ItemIsEditable : Qt::NoItemFlags);
}

bool GalleryModel::setData(const QModelIndex& index, const QVariant& value, int role) {
    const QString title = value.toString().simplified();
    if (role != Qt::EditRole || !index.isValid() || title.isEmpty() || title == entries_[index.row()].title)
        return false;
    emit renamed(index.row(), title);
    return true;
}

QImage GalleryModel::picture(int row) const {
    ++asked_;
    if (pictures_[row].isNull() && renderer_) {
        pictures_[row] = renderer_->thumbnail(firstRequest_ + row, entries_[row].text.toStdString());
        if (!pictures_[row].isNull()) pictures_[row].setDevicePixelRatio(ratio_);
    }
    return pictures_[row];
}

}  // namespace isoscope
