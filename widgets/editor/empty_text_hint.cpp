// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/editor/empty_text_hint.h"

#include <QEvent>

#include "widgets/editor/scene_editor.h"

namespace isoscope {

EmptyTextHint::EmptyTextHint(SceneEditor* editor) : QLabel(editor->viewport()), editor_(editor) {
    setText(tr("Type a formula, such as x*x + y*y + z*z - 1, or a scene"));
    setWordWrap(true);
    setAlignment(Qt::AlignTop | Qt::AlignLeft);
    setForegroundRole(QPalette::PlaceholderText);
    setAttribute(Qt::WA_TransparentForMouseEvents);
    connect(editor, &QsciScintilla::textChanged, this, &EmptyTextHint::follow);
    connect(editor, &SceneEditor::textLoaded, this, &EmptyTextHint::follow);
    connect(editor, &QsciScintillaBase::SCN_ZOOM, this, &EmptyTextHint::follow);
    editor->viewport()->installEventFilter(this);
    follow();
}

bool EmptyTextHint::eventFilter(QObject* watched, QEvent* event) {
    if (event->type() == QEvent::Resize || event->type() == QEvent::Show) follow();
    return QLabel::eventFilter(watched, event);
}

void EmptyTextHint::follow() {
    const bool empty = editor_->length() == 0;
    setVisible(empty);
    if (!empty) return;
    const int left =
        static_cast<int>(editor_->SendScintilla(QsciScintillaBase::SCI_POINTXFROMPOSITION, 0UL, 0L));
    const int top =
        static_cast<int>(editor_->SendScintilla(QsciScintillaBase::SCI_POINTYFROMPOSITION, 0UL, 0L));
    constexpr int caret = 4;
    const int width = std::max(1, editor_->viewport()->width() - left - 2 * caret);
    setGeometry(left + caret, top, width, heightForWidth(width));
}

}  // namespace isoscope
