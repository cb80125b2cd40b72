// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/desktop/editing/insertion_controller.h"

#include <utility>

#include "app/desktop/window/view_controller.h"
#include "widgets/document/scene_session.h"
#include "widgets/editor/scene_editor.h"

namespace isoscope {

InsertionController::InsertionController(SceneEditor* editor, SceneSession* session, ViewController* views,
                                         QObject* parent)
    : QObject(parent), editor_(editor), session_(session), views_(views) {
    // Behind the scene of the same result, which is announced first.
    connect(
        session, &SceneSession::parsed, this,
        [this](const auto&, quint64 revision) {
            if (revision != editor_->revision()) return;
            if (waiting_) plan();
            if (std::exchange(fits_, false)) views_->followText();
        },
        Qt::QueuedConnection);
}

InsertionController::~InsertionController() = default;

bool InsertionController::understood() {
    if (editor_->notation() == Notation::povray) return true;
    emit said(tr("VirtuaLight's notation does not know POV-Ray's functions."));
    return false;
}

void InsertionController::insertStatement(const Builtin* builtin) {
    if (!understood()) return;
    waiting_ = builtin;
    if (session_->resultRevision() == editor_->revision() && session_->result()) return plan();
    session_->setText(editor_->utf8(), editor_->revision(), SceneSession::When::now);
}

void InsertionController::plan() {
    const auto parsed = session_->result();
    const quint64 revision = editor_->revision();
    const auto caret = static_cast<std::size_t>(editor_->SendScintilla(QsciScintilla::SCI_GETCURRENTPOS));
    worker_.submit([this, parsed, revision, caret, builtin = waiting_,
                    text = editor_->utf8()](const std::stop_token& stop) {
        const FunctionInsertion insertion = isoscope::insertStatement(*builtin, *parsed, text, caret, stop);
        QMetaObject::invokeMethod(this, [this, insertion, revision, builtin] {
            // A text that has changed is planned again when it is read.
            if (waiting_ != builtin || revision != editor_->revision()) return;
            waiting_ = nullptr;
            apply(insertion);
            if (!insertion.cameraWritten) fits_ = true;
        });
    });
}

void InsertionController::insertCall(const Builtin* builtin) {
    if (!understood()) return;
    const auto at = [this](unsigned message) {
        return static_cast<std::size_t>(editor_->SendScintilla(message));
    };
    apply(isoscope::insertCall(*builtin, editor_->utf8(), at(QsciScintilla::SCI_GETSELECTIONSTART),
                               at(QsciScintilla::SCI_GETSELECTIONEND)));
}

void InsertionController::apply(const FunctionInsertion& insertion) {
    editor_->replaceText(insertion.changes);
    editor_->SendScintilla(QsciScintilla::SCI_GOTOPOS, static_cast<unsigned long>(insertion.caret));
    editor_->setFocus();
}

}  // namespace isoscope
