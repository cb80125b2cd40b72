// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/desktop/files/history_keeper.h"

#include <QUuid>
#include <utility>

#include "widgets/document/document.h"
#include "widgets/editor/edit_history.h"
#include "widgets/editor/scene_editor.h"

namespace isoscope {

HistoryKeeper::HistoryKeeper(SceneEditor* editor, const Document* document, QObject* parent)
    : QObject(parent), editor_(editor), document_(document) {
    timer_.setSingleShot(true);
    timer_.setInterval(pause);
    connect(&timer_, &QTimer::timeout, this, [this] {
        // A drag is no step yet.
        editor_->isDragging() ? timer_.start() : write();
    });
    // Not restarted: what changes without a pause is kept, too.
    const auto changed = [this] {
        waiting_ = true;
        if (!timer_.isActive()) timer_.start();
    };
    connect(editor->history(), &EditHistory::changed, this, changed);
    connect(editor->history(), &EditHistory::modifiedChanged, this, changed);
    connect(editor, &SceneEditor::textLoaded, this, [this] {
        untitled_ = QUuid::createUuid().toString(QUuid::WithoutBraces);
        timer_.stop();
        waiting_ = false;  // nothing has happened to it
    });
}

QString HistoryKeeper::name() const {
    return HistoryStore::nameOf(document_->filePath().isEmpty() ? untitled_ : document_->filePath());
}

std::optional<EditJournal> HistoryKeeper::past(const QString& text) const {
    const auto bytes = store_.find(name(), text);
    return bytes ? EditJournal::unpacked(*bytes) : std::nullopt;
}

void HistoryKeeper::write() {
    timer_.stop();
    if (!std::exchange(waiting_, false)) return;
    const EditJournal journal = editor_->history()->journal();
    if (!journal.steps().empty()) store_.write(name(), editor_->sceneText(), journal.packed());
}

}  // namespace isoscope
