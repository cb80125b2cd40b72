// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <QObject>
#include <QTimer>

class QMainWindow;

namespace isoscope {

class Document;
class SceneEditor;
class SceneSession;
class Viewport;

/// What the next start brings back: the last file with caret, scroll and view, and the window as it was. It
/// is written while the program runs, a moment after each change, so that a kill loses nothing of it.
class SessionMemory : public QObject {
    Q_OBJECT
  public:
    /// What is remembered; the memory owns none of them.
    struct Parts {
        QMainWindow* window;
        SceneEditor* editor;
        SceneSession* session;
        Document* document;
        Viewport* viewport;
    };
    /// `writeWindow` stores geometry and layout. Nothing is written before begin().
    SessionMemory(const Parts& parts, std::function<void()> writeWindow);

    /// From now on changes are written.
    void begin();
    /// The file of the last run; empty when there was none, or its text had no file.
    static QString lastFile();
    /// The document was opened with lastFile(): puts caret and scroll back and, as soon as the scene is
    /// there, the view.
    void restore();
    /// Writes now what waits.
    void write();

    /// From a change to its writing, in milliseconds.
    static constexpr int pause = 1000;

  protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

  private:
    void changed();
    void restoreView();

    Parts parts_;
    std::function<void()> writeWindow_;
    QTimer timer_;
    QList<double> view_;  ///< to be shown with the scene
    bool begun_ = false;
};

}  // namespace isoscope
