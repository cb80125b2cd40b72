// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QList>
#include <QString>

#include "widgets/gallery/gallery_entry.h"

namespace isoscope {

/// The scenes that a person keeps for the gallery: a file each, named by its title, in the folder of the
/// program's data.
class OwnCollection {
  public:
    /// `folder` empty means "collection" in the folder of the program's data.
    explicit OwnCollection(QString folder = {});

    /// All, by title. Files that cannot be read are left out.
    QList<GalleryEntry> entries() const;
    /// Keeps a text; a title that is taken gets a number behind. False when it cannot be written.
    bool add(const QString& title, const QString& text) const;
    /// Another title for a scene of the collection; one that is taken gets a number behind. False when there
    /// is no such file, or it cannot be renamed.
    bool rename(const QString& file, const QString& title) const;
    /// False when there is no such file, or it cannot be removed; add() takes it back.
    bool remove(const QString& file) const;

  private:
    bool isOwn(const QString& file) const;
    QString pathOf(const QString& title) const;
    /// A path that no scene has.
    QString freePath(const QString& title) const;

    QString folder_;
};

}  // namespace isoscope
