// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/editor/editor_keys.h"

#include <Qsci/qsciscintilla.h>

#include <QCoreApplication>
#include <QKeyEvent>

namespace isoscope {
namespace {

using Sci = QsciScintillaBase;

QList<EditorKey> makeKeys() {
    const auto tr = [](const char* text) { return QCoreApplication::translate("EditorKeys", text); };
    const auto move = [&](const char* name, QKeyCombination key, int message, int selecting) {
        return EditorKey{tr(name), {key}, message, selecting};
    };
    const auto edit = [&](const char* name, const QList<QKeyCombination>& keys, int message) {
        return EditorKey{tr(name), keys, message, 0, true};
    };
    const auto step = [&](const char* name, QKeyCombination key, double steps) {
        return EditorKey{tr(name), {key}, 0, 0, true, steps};
    };
    return {
        move(QT_TRANSLATE_NOOP("EditorKeys", "To the character before"), Qt::Key_Left, Sci::SCI_CHARLEFT,
             Sci::SCI_CHARLEFTEXTEND),
        move(QT_TRANSLATE_NOOP("EditorKeys", "To the next character"), Qt::Key_Right, Sci::SCI_CHARRIGHT,
             Sci::SCI_CHARRIGHTEXTEND),
        move(QT_TRANSLATE_NOOP("EditorKeys", "To the line above"), Qt::Key_Up, Sci::SCI_LINEUP,
             Sci::SCI_LINEUPEXTEND),
        move(QT_TRANSLATE_NOOP("EditorKeys", "To the line below"), Qt::Key_Down, Sci::SCI_LINEDOWN,
             Sci::SCI_LINEDOWNEXTEND),
        move(QT_TRANSLATE_NOOP("EditorKeys", "To the word before"), Qt::CTRL | Qt::Key_Left,
             Sci::SCI_WORDLEFT, Sci::SCI_WORDLEFTEXTEND),
        move(QT_TRANSLATE_NOOP("EditorKeys", "To the next word"), Qt::CTRL | Qt::Key_Right,
             Sci::SCI_WORDRIGHT, Sci::SCI_WORDRIGHTEXTEND),
        move(QT_TRANSLATE_NOOP("EditorKeys", "To the beginning of the line"), Qt::Key_Home, Sci::SCI_VCHOME,
             Sci::SCI_VCHOMEEXTEND),
        move(QT_TRANSLATE_NOOP("EditorKeys", "To the end of the line"), Qt::Key_End, Sci::SCI_LINEEND,
             Sci::SCI_LINEENDEXTEND),
        move(QT_TRANSLATE_NOOP("EditorKeys", "A page up"), Qt::Key_PageUp, Sci::SCI_PAGEUP,
             Sci::SCI_PAGEUPEXTEND),
        move(QT_TRANSLATE_NOOP("EditorKeys", "A page down"), Qt::Key_PageDown, Sci::SCI_PAGEDOWN,
             Sci::SCI_PAGEDOWNEXTEND),
        move(QT_TRANSLATE_NOOP("EditorKeys", "To the beginning of the text"), Qt::CTRL | Qt::Key_Home,
             Sci::SCI_DOCUMENTSTART, Sci::SCI_DOCUMENTSTARTEXTEND),
        move(QT_TRANSLATE_NOOP("EditorKeys", "To the end of the text"), Qt::CTRL | Qt::Key_End,
             Sci::SCI_DOCUMENTEND, Sci::SCI_DOCUMENTENDEXTEND),
        move(QT_TRANSLATE_NOOP("EditorKeys", "Close the list of words or the help on a function"),
             Qt::Key_Escape, Sci::SCI_CANCEL, 0),
        edit(QT_TRANSLATE_NOOP("EditorKeys", "New line"),
             {Qt::Key_Return, Qt::Key_Enter, Qt::SHIFT | Qt::Key_Return, Qt::SHIFT | Qt::Key_Enter},
             Sci::SCI_NEWLINE),
        edit(QT_TRANSLATE_NOOP("EditorKeys", "Indent, or take a word from the list"), {Qt::Key_Tab},
             Sci::SCI_TAB),
        edit(QT_TRANSLATE_NOOP("EditorKeys", "Take indentation away"), {Qt::SHIFT | Qt::Key_Backtab},
             Sci::SCI_BACKTAB),
        edit(QT_TRANSLATE_NOOP("EditorKeys", "Delete the character before"),
             {Qt::Key_Backspace, Qt::SHIFT | Qt::Key_Backspace}, Sci::SCI_DELETEBACK),
        edit(QT_TRANSLATE_NOOP("EditorKeys", "Delete the next character"), {Qt::Key_Delete}, Sci::SCI_CLEAR),
        edit(QT_TRANSLATE_NOOP("EditorKeys", "Delete to the beginning of the word"),
             {Qt::CTRL | Qt::Key_Backspace}, Sci::SCI_DELWORDLEFT),
        edit(QT_TRANSLATE_NOOP("EditorKeys", "Delete to the end of the word"), {Qt::CTRL | Qt::Key_Delete},
             Sci::SCI_DELWORDRIGHT),
        step(QT_TRANSLATE_NOOP("EditorKeys", "Number at the caret: one step up"), Qt::CTRL | Qt::Key_Up, 1),
        step(QT_TRANSLATE_NOOP("EditorKeys", "Number at the caret: one step down"), Qt::CTRL | Qt::Key_Down,
             -1),
        step(QT_TRANSLATE_NOOP("EditorKeys", "Number at the caret: a tenth of a step up"),
             Qt::CTRL | Qt::SHIFT | Qt::Key_Up, 0.1),
        step(QT_TRANSLATE_NOOP("EditorKeys", "Number at the caret: a tenth of a step down"),
             Qt::CTRL | Qt::SHIFT | Qt::Key_Down, -0.1),
        step(QT_TRANSLATE_NOOP("EditorKeys", "Number at the caret: ten steps up"), Qt::CTRL | Qt::Key_PageUp,
             10),
        step(QT_TRANSLATE_NOOP("EditorKeys", "Number at the caret: ten steps down"),
             Qt::CTRL | Qt::Key_PageDown, -10),
    };
}

}  // namespace

const QList<EditorKey>& editorKeys() {
    static const QList<EditorKey> keys = makeKeys();
    return keys;
}

EditorCommand editorCommand(const QKeyEvent& event) {
    const Qt::KeyboardModifiers modifiers = event.modifiers() & ~Qt::KeypadModifier;
    const auto key = static_cast<Qt::Key>(event.key());
    const QKeyCombination pressed(modifiers, key), unshifted(modifiers & ~Qt::ShiftModifier, key);
    for (const EditorKey& entry : editorKeys())
        if (entry.keys.contains(pressed)) return {&entry, entry.message};
    if (modifiers.testFlag(Qt::ShiftModifier))
        for (const EditorKey& entry : editorKeys())
            if (entry.selecting != 0 && entry.keys.contains(unshifted)) return {&entry, entry.selecting};
    return {};
}

bool typesText(const QKeyEvent& event) {
    Qt::KeyboardModifiers commanding = Qt::ControlModifier | Qt::AltModifier | Qt::MetaModifier;
#if defined(Q_OS_WIN)
    // AltGr arrives as both.
    constexpr Qt::KeyboardModifiers altGr = Qt::ControlModifier | Qt::AltModifier;
    if ((event.modifiers() & altGr) == altGr) commanding &= ~altGr;
#elif defined(Q_OS_MACOS)
    commanding &= ~Qt::KeyboardModifiers(Qt::AltModifier);
#endif
    return !(event.modifiers() & commanding);
}

}  // namespace isoscope
