// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QKeyCombination>
#include <QList>
#include <QString>

class QKeyEvent;

namespace isoscope {

/// A key that the editor understands by itself. All of them stand in editorKeys(); any other key with Ctrl,
/// Alt or Meta means nothing in the text, whatever Scintilla knows, and is left to the window's commands.
struct EditorKey {
    QString name;
    QList<QKeyCombination> keys;
    /// Scintilla's message; 0 for keys that step the number at the caret.
    int message = 0;
    /// Scintilla's message for the same keys with Shift, which select; 0 when they mean nothing.
    int selecting = 0;
    /// Whether the text changes.
    bool edits = false;
    /// Steps of the number's last digit.
    double numberStep = 0;
};

/// In the order of the shortcut window.
const QList<EditorKey>& editorKeys();

/// What a key press asks for: the entry of editorKeys() and Scintilla's message; null for none.
struct EditorCommand {
    const EditorKey* key = nullptr;
    int message = 0;
};
/// The command of a key press: with Shift the one that selects, where there is one. Keys of the keypad count
/// as the others.
EditorCommand editorCommand(const QKeyEvent& event);

/// Whether a key press that is none of editorKeys() is text.
bool typesText(const QKeyEvent& event);

}  // namespace isoscope
