// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QAbstractListModel>
#include <QImage>
#include <QList>

#include "widgets/gallery/gallery_entry.h"

namespace isoscope {

class ThumbnailRenderer;

/// The entries of the gallery as a list. A picture is read or asked for when it is first shown.
class GalleryModel : public QAbstractListModel {
    Q_OBJECT
  public:
    /// Data besides Qt's roles: the sentence, and what a search reads.
    enum Role { sentenceRole = Qt::UserRole + 1, searchRole };

    explicit GalleryModel(QObject* parent = nullptr);
    ~GalleryModel() override;

    /// The picture's edge in logical pixels.
    static constexpr int pictureSize = 96;

    /// Takes the place of all entries.
    void setEntries(QList<GalleryEntry> entries);
    const GalleryEntry& entry(int row) const { return entries_[row]; }
    /// The kind as a word: "Function".
    static QString kindName(GalleryEntry::Kind kind);
    /// Pictures are rendered for this ratio of device to logical pixels; starts the renderer at the first
    /// call.
    void startPictures(double devicePixelRatio);
    /// Pictures that the background had to render; those of the cache do not count.
    int renderedPictures() const { return rendered_; }

    /// How often entries were painted: asked for their pictures.
    int picturesAsked() const { return asked_; }

    /// 0 below a row: the list is flat.
    int rowCount(const QModelIndex& parent = {}) const override;
    QVariant data(const QModelIndex& index, int role) const override;
    /// Entries of the own collection can be given another title.
    Qt::ItemFlags flags(const QModelIndex& index) const override;
    bool setData(const QModelIndex& index, const QVariant& value, int role) override;

  signals:
    /// Another title was typed, which the entry does not have yet.
    void renamed(int row, const QString& title);

  private:
    QImage picture(int row) const;
    void takePicture(int request, const QImage& image);

    QList<GalleryEntry> entries_;
    int firstRequest_ = 0;  ///< row 0 asks by this number, so that answers to earlier entries are known
    int rendered_ = 0;
    mutable int asked_ = 0;
    ThumbnailRenderer* renderer_ = nullptr;
    double ratio_ = 1;
    mutable QList<QImage> pictures_;
};

}  // namespace isoscope
