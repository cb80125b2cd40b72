// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/document/text_feed.h"

#include <QTimer>
#include <utility>

#include "widgets/editor/scene_editor.h"

namespace isoscope {

TextFeed::TextFeed(SceneEditor* editor, SceneSession* session, QObject* parent)
    : QObject(parent), editor_(editor), session_(session) {
    connect(editor, &SceneEditor::textEdited, this,
            [this] { live_ ? follow(SceneSession::When::afterPause) : setBehind(!paused_ || behind_); });
    connect(editor, &SceneEditor::textLoaded, this, [this] { follow(SceneSession::When::now); });
    // A slider that moves has the whole text read.
    connect(session, &SceneSession::parsed, this, [this](const auto&, quint64 revision) {
        if (revision == editor_->revision()) setBehind(false);
    });
    // A scrub says right after this signal which number it was; other rewrites (a camera block) say nothing
    // more.
    connect(editor, &SceneEditor::numberReplaced, this, [this] {
        if (paused_) return;
        rewritten_ = true;
        QTimer::singleShot(0, this, [this] {
            if (std::exchange(rewritten_, false)) follow(SceneSession::When::now);
        });
    });
}

void TextFeed::follow(SceneSession::When when) {
    if (!paused_) submit(when);
}

void TextFeed::setLive(bool live) {
    live_ = live;
    if (live && behind_) submit(SceneSession::When::now);
}

void TextFeed::setBehind(bool behind) {
    if (std::exchange(behind_, behind) != behind) emit behindChanged(behind);
}

void TextFeed::submit(SceneSession::When when) {
    setBehind(false);
    session_->setText(editor_->utf8(), editor_->revision(), when);
}

}  // namespace isoscope
