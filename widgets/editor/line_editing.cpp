// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/editor/line_editing.h"

#include <Qsci/qsciscintilla.h>

#include <algorithm>
#include <limits>
#include <vector>

#include "widgets/editor/scene_lexer.h"

namespace isoscope {

using Sci = QsciScintillaBase;

void indentNewLine(QsciScintilla* editor) {
    const long line =
        editor->SendScintilla(Sci::SCI_LINEFROMPOSITION, editor->SendScintilla(Sci::SCI_GETCURRENTPOS));
    if (line == 0) return;
    const long begin = editor->SendScintilla(Sci::SCI_POSITIONFROMLINE, line - 1),
               end = editor->SendScintilla(Sci::SCI_POSITIONFROMLINE, line);
    styleAt(editor, end - 1);
    int open = 0;
    for (long at = begin; at < end; ++at) {
        if (styleAt(editor, at) != SceneStyle::symbol) continue;
        const long c = editor->SendScintilla(Sci::SCI_GETCHARAT, at);
        if (c == '{') ++open;
        if (c == '}' && open > 0) --open;
    }
    const long columns = editor->SendScintilla(Sci::SCI_GETLINEINDENTATION, line - 1) +
                         (open > 0 ? editor->indentationWidth() : 0);
    editor->SendScintilla(Sci::SCI_SETLINEINDENTATION, static_cast<unsigned long>(line), columns);
    editor->SendScintilla(Sci::SCI_GOTOPOS, static_cast<unsigned long>(
                                                editor->SendScintilla(Sci::SCI_GETLINEINDENTPOSITION, line)));
}

void alignClosingBrace(QsciScintilla* editor) {
    const long brace = editor->SendScintilla(Sci::SCI_GETCURRENTPOS) - 1;
    const long line = editor->SendScintilla(Sci::SCI_LINEFROMPOSITION, brace);
    if (editor->SendScintilla(Sci::SCI_GETLINEINDENTPOSITION, line) != brace) return;
    if (styleAt(editor, brace) != SceneStyle::symbol) return;
    const long opening = editor->SendScintilla(Sci::SCI_BRACEMATCH, static_cast<unsigned long>(brace), 0L);
    if (opening < 0) return;
    const long openingLine = editor->SendScintilla(Sci::SCI_LINEFROMPOSITION, opening);
    editor->SendScintilla(Sci::SCI_SETLINEINDENTATION, static_cast<unsigned long>(line),
                          editor->SendScintilla(Sci::SCI_GETLINEINDENTATION, openingLine));
}

void toggleComment(QsciScintilla* editor) {
    const long anchor = editor->SendScintilla(Sci::SCI_GETANCHOR),
               caret = editor->SendScintilla(Sci::SCI_GETCURRENTPOS);
    const long first = editor->SendScintilla(Sci::SCI_LINEFROMPOSITION, std::min(anchor, caret));
    long last = editor->SendScintilla(Sci::SCI_LINEFROMPOSITION, std::max(anchor, caret));
    // A selection of whole lines ends at the start of the next one.
    if (last > first && editor->SendScintilla(Sci::SCI_POSITIONFROMLINE, last) == std::max(anchor, caret))
        --last;

    std::vector<long> textStarts;
    bool allCommented = true;
    long column = std::numeric_limits<long>::max();
    for (long line = first; line <= last; ++line) {
        const long start = editor->SendScintilla(Sci::SCI_GETLINEINDENTPOSITION, line);
        if (start == editor->SendScintilla(Sci::SCI_GETLINEENDPOSITION, line)) continue;
        textStarts.push_back(start);
        column = std::min(column, start - editor->SendScintilla(Sci::SCI_POSITIONFROMLINE, line));
        allCommented &= editor->SendScintilla(Sci::SCI_GETCHARAT, start) == '/' &&
                        editor->SendScintilla(Sci::SCI_GETCHARAT, start + 1) == '/';
    }
    editor->SendScintilla(Sci::SCI_BEGINUNDOACTION);
    // From the last line up, so that the positions above stay right.
    for (auto start = textStarts.rbegin(); start != textStarts.rend(); ++start) {
        const long line = editor->SendScintilla(Sci::SCI_LINEFROMPOSITION, *start);
        const long begin =
            allCommented ? *start : editor->SendScintilla(Sci::SCI_POSITIONFROMLINE, line) + column;
        const bool blank = editor->SendScintilla(Sci::SCI_GETCHARAT, *start + 2) == ' ';
        const long removed = !allCommented ? 0 : blank ? 3 : 2;
        // Replacing keeps the selection; inserting would drop it.
        editor->SendScintilla(Sci::SCI_SETTARGETRANGE, static_cast<unsigned long>(begin), begin + removed);
        editor->SendScintilla(Sci::SCI_REPLACETARGET, allCommented ? 0UL : 3UL, allCommented ? "" : "// ");
    }
    editor->SendScintilla(Sci::SCI_ENDUNDOACTION);
}

}  // namespace isoscope
