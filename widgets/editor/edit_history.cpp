// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/editor/edit_history.h"

#include <Qsci/qsciscintilla.h>

#include <utility>

namespace isoscope {

using Sci = QsciScintillaBase;

namespace {

/// Kind of a step that no reviver knows.
const QString unstored = QStringLiteral("-");

}  // namespace

EditHistory::EditHistory(QsciScintilla* editor) : editor_(editor) {
    connect(editor, &QsciScintillaBase::SCN_MODIFIED, this,
            [this](int position, int type, const char* text, int length, int, int, int, int, int token) {
                onModified(position, type, text ? QByteArray(text, length) : QByteArray(), token);
            });
}

EditHistory::~EditHistory() = default;

void EditHistory::add(Step step) {
    emit adding();
    ++serial_;
    steps_.resize(done_);
    const int token = static_cast<int>(steps_.size());
    journal_.add({{}, step.kind.isEmpty() ? unstored : step.kind, {}, step.joined});
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
    journal_.clear();
    tellLoaded();
}

void EditHistory::tellLoaded() {
    emit modifiedChanged(isModified());
    emit changed();
}

void EditHistory::setModified(bool modified) {
    const bool before = isModified();
    saved_ = modified ? -1 : textState_;
    journal_.setSaved(!modified);
    tellModified(before);
}

EditJournal EditHistory::journal() const {
    EditJournal full = journal_;
    std::size_t beside = 0;
    for (std::size_t i = 0; i < full.steps().size(); ++i) {
        if (full.steps()[i].kind.isEmpty() || beside >= steps_.size()) continue;
        const Step& step = steps_[beside++].step;
        if (step.record) full.setRecord(i, step.record());
    }
    return full;
}

void EditHistory::replay(const EditJournal& journal) {
    replaying_ = true;
    int done = 0;
    saved_ = journal.saved() == 0 ? 0 : -1;
    journal_.setSaved(saved_ == 0);
    for (int i = 0; i < static_cast<int>(journal.steps().size()); ++i) {
        replayStep(journal.steps()[static_cast<std::size_t>(i)]);
        if (i + 1 == journal.saved()) setModified(false);
        if (i + 1 == journal.done()) done = journal_.done();
    }
    // Not by the steps' number: what changed nothing is none.
    while (journal_.done() > done && editor_->isUndoAvailable()) editor_->SendScintilla(Sci::SCI_UNDO);
    cameBack_ = false;
    replaying_ = false;
}

void EditHistory::replayStep(const EditJournal::Step& step) {
    if (!step.kind.isEmpty()) {
        const auto reviver = revivers_.find(step.kind);
        if (reviver == revivers_.end() || step.record.isEmpty()) return;
        Step revived = reviver->second(step.record);
        revived.joined = step.joined;
        return add(std::move(revived));
    }
    editor_->SendScintilla(Sci::SCI_BEGINUNDOACTION);
    for (const EditJournal::Replacement& part : step.text) {
        if (part.begin < 0 || part.begin + part.removed.size() > editor_->length()) break;  // a damaged one
        editor_->SendScintilla(Sci::SCI_SETTARGETRANGE, static_cast<unsigned long>(part.begin),
                               static_cast<long>(part.begin + part.removed.size()));
        editor_->SendScintilla(Sci::SCI_REPLACETARGET, static_cast<unsigned long>(part.inserted.size()),
                               part.inserted.constData());
    }
    editor_->SendScintilla(Sci::SCI_ENDUNDOACTION);
}

void EditHistory::record(int position, int type, const QByteArray& text) {
    const bool undone = type & Sci::SC_PERFORMED_UNDO, redone = type & Sci::SC_PERFORMED_REDO;
    if ((undone || redone) && (type & Sci::SC_LASTSTEPINUNDOREDO))
        undone ? journal_.undone() : journal_.redone();
    if (undone || redone || !(type & (Sci::SC_MOD_INSERTTEXT | Sci::SC_MOD_DELETETEXT))) return;
    journal_.change(position, text, type & Sci::SC_MOD_INSERTTEXT, type & Sci::SC_STARTACTION);
}

void EditHistory::onModified(int position, int type, const QByteArray& text, int token) {
    record(position, type, text);
    const bool undone = type & Sci::SC_PERFORMED_UNDO, redone = type & Sci::SC_PERFORMED_REDO;
    if (type & Sci::SC_MOD_CONTAINER) {
        ++serial_;
        if (token < 0 || token >= static_cast<int>(steps_.size())) return;
        // A copy: what it does may lead to another step.
        const Step step = steps_[static_cast<std::size_t>(token)].step;
        done_ = static_cast<std::size_t>(token) + (redone ? 1 : 0);
        if (replaying_) return;
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
