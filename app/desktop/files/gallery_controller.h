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
class StartPage;

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
        QWidget* host;  ///< what the start page covers
    };
    GalleryController(const Parts& parts, QObject* parent);

    /// The gallery over the whole picture, made when it is first wanted.
    void showPage();
    /// Null before it was wanted.
    StartPage* page() const { return page_; }

  signals:
    /// For the status line.
    void said(const QString& message);
    /// By the button of the start page.
    void lessonsRequested();

  private:
    void load();
    void fill();
    void connectPanel(GalleryPanel* panel);
    void open(const GalleryEntry& entry);
    void addPresent();
    void remove(const GalleryEntry& entry);
    void rename(const GalleryEntry& entry, const QString& title);

    Parts parts_;
    StartPage* page_ = nullptr;
    OwnCollection own_;
    QList<GalleryEntry> builtIn_;  ///< all but the own ones
};

}  // namespace isoscope
