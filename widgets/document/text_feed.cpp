// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/document/text_feed.h"

#include <QTimer>
#include <utility>

#include "widgets/editor/scene_editor.h"

namespace isoscope {

TextFeed::TextFeed(SceneEditor* editor, SceneSession* session, QObject* parent)
    : QObject(parent), editor_(editor), session_(session) {
    const auto follow = [this](SceneSession::When when) {
        if (!paused_) submit(when);
    };
    connect(editor, &SceneEditor::textEdited, this, [=] { follow(SceneSession::When::afterPause); });
    connect(editor, &SceneEditor::textLoaded, this, [=] { follow(SceneSession::When::now); });
    // A scrub says right after this signal which number it was; other rewrites (a camera block) say nothing
    // more.
    connect(editor, &SceneEditor::numberReplaced, this, [=, this] {
        if (paused_) return;
        rewritten_ = true;
        QTimer::singleShot(0, this, [=, this] {
            if (std::exchange(rewritten_, false)) follow(SceneSession::When::now);
        });
    });
}

void TextFeed::submit(SceneSession::When when) {
    session_->setText(editor_->utf8(), editor_->revision(), when);
}

}  // namespace isoscope
