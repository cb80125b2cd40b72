// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QPointer>
#include <QString>

#include "widgets/document/document.h"
#include "widgets/document/file_watch.h"

class QWidget;

namespace isoscope {

class DifferenceWindow;
class NoticeBar;
class SceneEditor;

/// What other programs, or another window, do to the file of the document: a file that changed or vanished is
/// noticed at once, when the window comes to the front, and before saving. Nothing is taken over or written
/// over before the user has said so, once or, by setFollowing(), for good.
class ExternalChanges : public QObject {
    Q_OBJECT
  public:
    /// What is compared with the disk, and where questions are asked; this owns none of them and is a child
    /// of `window`.
    struct Parts {
        QWidget* window;
        SceneEditor* editor;
        Document* document;
        NoticeBar* notices;
    };
    explicit ExternalChanges(const Parts& parts);

    /// Whether the text of the disk is taken over unasked as long as the editor has no changes of its own:
    /// the scene is written in another editor.
    void setFollowing(bool following);
    /// Looks whether the disk still has what was read or written; tells when it has not.
    void look(bool thorough = false);
    /// Whether saving to the document's own file writes over nothing unknown; else the notice asks.
    bool maySave();

  signals:
    /// The text of the disk is to be shown.
    void reloadRequested();
    /// The text is to be saved, whatever stands on the disk.
    void saveRequested();
    void saveAsRequested();

  protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

  private:
    void follow();
    void tellChanged(bool saving);
    void tellMissing(bool saving);
    void keepMine(bool saving);
    void ignore();
    void showDifference(bool saving);

    Parts parts_;
    FileWatch watch_;
    QString path_;
    bool following_ = false;
    QByteArray ignored_;  ///< the state of the disk that the user has seen and left alone
    QPointer<DifferenceWindow> difference_;
};

}  // namespace isoscope
