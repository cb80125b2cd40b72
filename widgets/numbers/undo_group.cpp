// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/numbers/undo_group.h"

#include <Qsci/qsciscintilla.h>

namespace isoscope {

UndoGroup::UndoGroup(QsciScintilla* editor) : editor_(editor) {
    timer_.setSingleShot(true);
    timer_.setInterval(pause);
    connect(&timer_, &QTimer::timeout, this, &UndoGroup::settle);
}

UndoGroup::~UndoGroup() = default;

void UndoGroup::beginDrag() {
    if (drags_++ > 0) return;
    // What came before the drag is a step of its own.
    settle();
    open();
}

void UndoGroup::endDrag() {
    if (drags_ == 0 || --drags_ > 0) return;
    close();
}

void UndoGroup::change() {
    if (drags_ > 0) return;
    open();
    timer_.start();
}

void UndoGroup::settle() {
    timer_.stop();
    if (drags_ == 0) close();
}

void UndoGroup::open() {
    if (open_) return;
    open_ = true;
    editor_->SendScintilla(QsciScintillaBase::SCI_BEGINUNDOACTION);
}

void UndoGroup::close() {
    if (!open_) return;
    open_ = false;
    editor_->SendScintilla(QsciScintillaBase::SCI_ENDUNDOACTION);
}

}  // namespace isoscope
