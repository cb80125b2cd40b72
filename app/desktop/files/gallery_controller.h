// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>

#include "widgets/gallery/own_collection.h"

namespace isoscope {

class DocumentController;
class GalleryPanel;
class InsertionController;
class NoticeBar;
class SceneEditor;

/// Fills the gallery when it is first shown, opens what is chosen there, and keeps the person's collection.
class GalleryController : public QObject {
    Q_OBJECT
  public:
    /// All parts outlive the controller.
    struct Parts {
        GalleryPanel* panel;
        DocumentController* documents;
        InsertionController* insertions;
        SceneEditor* editor;
        NoticeBar* notices;
    };
    GalleryController(const Parts& parts, QObject* parent);

  signals:
    /// For the status line.
    void said(const QString& message);

  private:
    void fill();
    void open(const GalleryEntry& entry);
    void addPresent();
    void remove(const GalleryEntry& entry);

    Parts parts_;
    OwnCollection own_;
    QList<GalleryEntry> builtIn_;  ///< all but the own ones
};

}  // namespace isoscope
