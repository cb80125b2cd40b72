// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <QList>
#include <QObject>
#include <QPointer>
#include <QString>
#include <string>
#include <utility>
#include <vector>

#include "core/exchange/isosurface_export.h"
#include "core/scene/camera.h"
#include "widgets/viewport/view_overlay.h"

class QWidget;

namespace isoscope {

class Document;
class GradientProofs;
class NoticeBar;
class PictureQueue;
class PictureQueueWindow;
class SceneEditor;
class SceneSession;
class Viewport;

/// Takes what is shown out of the program: the isosurface, a scene for POV-Ray, a picture, a mesh; and the
/// view into the text.
class ExportController : public QObject {
    Q_OBJECT
  public:
    /// What is exported, and where questions are asked; the controller owns none of them and is a child of
    /// `window`.
    struct Parts {
        QWidget* window;
        SceneEditor* editor;
        SceneSession* session;
        Viewport* viewport;
        Document* document;
        NoticeBar* notices;
    };
    explicit ExportController(const Parts& parts);

    /// The isosurface around the caret, else the first, with its declarations; of a VirtuaLight text all
    /// objects.
    IsosurfaceExport isosurface() const;
    /// The whole scene with the present view.
    QString sceneText() const;
    void copyIsosurface();
    void exportInclude();
    void exportScene();
    /// The objects of the text in VirtuaLight's notation.
    void exportVirtualightText();
    void exportImage();
    /// The present text as POV-Ray is to draw it to show what `shown` shows.
    PovrayTask povrayTask(const RenderRequest& shown) const;
    /// The picture as it is shown, marks included, to the clipboard.
    void copyPicture();
    /// Lets the picture be dropped elsewhere, as an image or a PNG file; returns when it is.
    void dragPicture();
    /// The window that lists the pictures of the queue.
    void showQueue();
    /// Pictures that are drawn into files; lives as long as the controller.
    PictureQueue* queue() const { return queue_; }
    /// The scene whose numbers follow `clock`, and the `.ini` file that makes POV-Ray draw it, beside it.
    void exportAnimation();
    /// The frames of the timeline as pictures, and as a film.
    void exportFrames();
    /// The isosurfaces of the picture as triangles.
    void exportMesh();
    /// Puts the present view into the camera block of the text, or adds one. Waits for a parse when the text
    /// is newer.
    void writeView();

    /// Whether isosurfaces get a comment of what is proven of them, by these proofs; without proofs they get
    /// none.
    void setNoted(bool noted) { noted_ = noted; }
    void setProofs(std::shared_ptr<GradientProofs> proofs) { proofs_ = std::move(proofs); }

    /// Of the last image that was exported, also by an earlier run; 800 x 600 before the first.
    static QSize exportSize();

  signals:
    /// See exportSize().
    void exportSizeChanged(QSize size);
    void said(const QString& message);

  private:
    /// The present text as it is understood, even while the session waits for a pause in typing; null when
    /// there is no text yet.
    std::shared_ptr<const ParseResult> presentResult() const;
    void writeViewNow();
    Camera presentCamera() const;
    /// Whether the text is VirtuaLight's; then the user was asked for a file, and it is written.
    bool exportsVirtualight(const QString& title, const QString& suffix);
    /// Empty when the user changes their mind.
    QString chooseFile(const QString& title, const QString& suffix);
    void writeText(const QString& title, const QString& suffix, const QString& text);
    /// Calls `write`, which returns why it failed, unless the document itself stands at `path`. A file there
    /// that no export made, or an image beside it that is none, is named and asked about first.
    void writeGuarded(const QString& path, const std::vector<std::filesystem::path>& images,
                      const std::function<std::string()>& write);
    QString suggestedFile(const QString& suffix) const;

    void tellEnd(int number);
    std::string noteOf(const Scene& scene, std::size_t isosurface) const;

    Parts parts_;
    PictureQueue* queue_;
    QPointer<PictureQueueWindow> queueWindow_;
    QList<int> told_;  ///< pictures of the queue whose end is told in the status line
    std::shared_ptr<GradientProofs> proofs_;
    bool noted_ = false;
    bool viewWaits_ = false;  ///< writeView() waits for the places of the present text
};

}  // namespace isoscope
