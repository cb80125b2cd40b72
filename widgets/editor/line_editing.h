// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

class QsciScintilla;

namespace isoscope {

// What an editor of the scene language does with whole lines. Braces count where the language sees them: not
// in comments and strings. All of it works on text that has not been coloured yet.

/// Indents the caret's line, which was just begun: as the one before, deeper when that leaves a brace open.
void indentNewLine(QsciScintilla* editor);

/// A closing brace was just typed: where it begins its line, the line moves below the one that opened it.
void alignClosingBrace(QsciScintilla* editor);

/// Puts `//` before the selected lines, or takes it away when all of them have it. One undo step; the
/// selection stays.
void toggleComment(QsciScintilla* editor);

}  // namespace isoscope
