// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/editor/edit_history.h"

#include <Qsci/qsciscintilla.h>

#include <utility>

namespace isoscope {

using Sci = QsciScintillaBase;

EditHistory::EditHistory(QsciScintilla* editor) : editor_(editor) {
    connect(
        editor, &QsciScintillaBase::SCN_MODIFIED, this,
        [this](int, int type, const char*, int, int, int, int, int, int token) { onModified(type, token); });
}

EditHistory::~EditHistory() = default;

void EditHistory::add(Step step) {
    emit adding();
    ++serial_;
    steps_.resize(done_);
    const int token = static_cast<int>(steps_.size());
    steps_.push_back({std::move(step), textState_});
    done_ = steps_.size();
    editor_->SendScintilla(Sci::SCI_ADDUNDOACTION, static_cast<unsigned long>(token), 0L);
    emit changed();
}

void EditHistory::reset() {
    ++serial_;
    steps_.clear();
    done_ = 0;
    textState_ = saved_ = 0;
    cameBack_ = false;
    emit modifiedChanged(false);
    emit changed();
}

void EditHistory::setModified(bool modified) {
    const bool before = isModified();
    saved_ = modified ? -1 : textState_;
    tellModified(before);
}

void EditHistory::onModified(int type, int token) {
    const bool undone = type & Sci::SC_PERFORMED_UNDO, redone = type & Sci::SC_PERFORMED_REDO;
    if (type & Sci::SC_MOD_CONTAINER) {
        ++serial_;
        if (token < 0 || token >= static_cast<int>(steps_.size())) return;
        // A copy: what it does may lead to another step.
        const Step step = steps_[static_cast<std::size_t>(token)].step;
        done_ = static_cast<std::size_t>(token) + (redone ? 1 : 0);
        if (undone) step.undo();
        if (redone) step.redo();
        undoGoesOn_ = undone && step.joined;
        return;
    }
    if (!(type & (Sci::SC_MOD_INSERTTEXT | Sci::SC_MOD_DELETETEXT))) return;
    ++serial_;
    const bool before = isModified();
    cameBack_ = undone || redone;
    if (!cameBack_) {
        emit textEntered(textState_);
        steps_.resize(done_);
        if (saved_ > textState_) saved_ = -1;
    }
    textState_ += undone ? -1 : 1;
    tellModified(before);
    if (!cameBack_) emit changed();
}

bool EditHistory::redoGoesOn() const {
    return done_ < steps_.size() && steps_[done_].step.joined && steps_[done_].textState == textState_;
}

void EditHistory::tellModified(bool before) {
    if (isModified() != before) emit modifiedChanged(isModified());
}

}  // namespace isoscope
