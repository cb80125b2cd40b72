// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>

#include "widgets/document/scene_session.h"

namespace isoscope {

class SceneEditor;

/// Hands the text to the session whenever it has changed: what is typed after a pause, or only when it is
/// asked to, everything else at once.
class TextFeed : public QObject {
    Q_OBJECT
  public:
    /// Both must outlive the feed.
    TextFeed(SceneEditor* editor, SceneSession* session, QObject* parent = nullptr);

    /// The text as it stands.
    void submit(SceneSession::When when);
    /// While on, changes of the text are those of somebody who tells the session of them.
    void setPaused(bool on) { paused_ = on; }
    /// Whether typing is followed; else submit() shows what was typed.
    void setLive(bool live);
    /// Something was typed that the session does not know.
    bool isBehind() const { return behind_; }
    /// The session knows the last number that was rewritten.
    void passRewriting() { rewritten_ = false; }

  signals:
    /// As isBehind() says now.
    void behindChanged(bool behind);

  private:
    void follow(SceneSession::When when);
    void setBehind(bool behind);

    SceneEditor* editor_;
    SceneSession* session_;
    bool paused_ = false;
    bool live_ = true;
    bool behind_ = false;
    bool rewritten_ = false;  ///< a number of the text was, and the session does not know yet
};

}  // namespace isoscope
