// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/editor/diagnostic_marks.h"

#include <Qsci/qsciscintilla.h>

#include <algorithm>

#include "widgets/editor/code_words.h"

namespace isoscope {
namespace {

using Sci = QsciScintillaBase;

QColor severityColor(Severity severity, Look look) {
    switch (severity) {
        case Severity::error: return lookColor(look, 0xc62828, 0xff6b6b);
        case Severity::warning: return lookColor(look, 0xb26a00, 0xf5b942);
        case Severity::leftOut: return lookColor(look, 0x4a6a91, 0x8fa8c8);
        case Severity::note: return lookColor(look, 0x1d6fd0, 0x6ab0ff);
    }
    return {};
}

bool isContinuation(long byte) { return (byte & 0xc0) == 0x80; }

/// A place that can be seen: whole characters, at least one of them, and not a line end alone where text
/// stands before it.
void makeVisible(QsciScintilla* editor, long& begin, long& end) {
    const long length = editor->SendScintilla(Sci::SCI_GETLENGTH);
    begin = std::clamp(begin, 0L, length);
    end = std::clamp(end, begin, length);
    const auto byteAt = [editor](long at) { return editor->SendScintilla(Sci::SCI_GETCHARAT, at); };
    const auto isBlank = [&](long at) {
        const long c = byteAt(at);
        return c == ' ' || c == '\t' || c == '\n' || c == '\r';
    };
    const bool empty = begin == end || (end == begin + 1 && byteAt(begin) == '\n');
    if (empty) {
        // Something is missing: the last character before the gap shows where.
        while (begin > 0 && (begin >= length || isBlank(begin))) --begin;
        end = std::min(begin + 1, length);
    }
    while (begin > 0 && isContinuation(byteAt(begin))) --begin;
    while (end < length && isContinuation(byteAt(end))) ++end;
}

}  // namespace

DiagnosticMarks::DiagnosticMarks(QsciScintilla* editor) : editor_(editor) {
    using Editor = QsciScintilla;
    constexpr Editor::MarkerSymbol symbols[severities] = {Editor::Circle, Editor::RightTriangle,
                                                          Editor::Minus, Editor::Invisible};
    for (int i = 0; i < severities; ++i) {
        const auto severity = static_cast<Severity>(i);
        editor->markerDefine(symbols[i], marker(severity));
        // What is left out or merely said is no mistake: dots instead of a squiggle.
        const bool mistake = severity == Severity::error || severity == Severity::warning;
        editor->indicatorDefine(mistake ? Editor::SquiggleIndicator : Editor::DotsIndicator,
                                indicator(severity));
    }
    applyTheme(Look::light);
}

void DiagnosticMarks::applyTheme(Look look) {
    for (int i = 0; i < severities; ++i) {
        const auto severity = static_cast<Severity>(i);
        const QColor color = severityColor(severity, look);
        editor_->setMarkerForegroundColor(color, marker(severity));
        editor_->setMarkerBackgroundColor(color, marker(severity));
        editor_->setIndicatorForegroundColor(color, indicator(severity));
    }
}

void DiagnosticMarks::set(const Diagnostics& diagnostics, const SourceLibrary&) {
    clear();
    for (const Diagnostic& diagnostic : diagnostics) {
        // A mistake inside an include is shown at the statement of the user's text that led there.
        SourceRange range = diagnostic.range;
        for (const SourceRange& from : diagnostic.reachedFrom)
            if (range.file != 0) range = from;
        if (range.file != 0) continue;
        long begin = range.begin, end = range.end;
        makeVisible(editor_, begin, end);
        Mark mark{toolTipText(diagnostic), -1};
        if (diagnostic.severity != Severity::note) {
            const int line = static_cast<int>(editor_->SendScintilla(Sci::SCI_LINEFROMPOSITION, begin));
            mark.markerHandle = editor_->markerAdd(line, marker(diagnostic.severity));
        }
        marks_.push_back(std::move(mark));
        underline(begin, end, diagnostic.severity, static_cast<int>(marks_.size()));
    }
    // Beside an empty text Scintilla paints no margin anew.
    editor_->viewport()->update();
}

void DiagnosticMarks::clear() {
    const long length = editor_->SendScintilla(Sci::SCI_GETLENGTH);
    for (int i = 0; i < severities; ++i) {
        const auto severity = static_cast<Severity>(i);
        editor_->markerDeleteAll(marker(severity));
        editor_->SendScintilla(Sci::SCI_SETINDICATORCURRENT, indicator(severity));
        editor_->SendScintilla(Sci::SCI_INDICATORCLEARRANGE, static_cast<unsigned long>(0), length);
    }
    marks_.clear();
}

void DiagnosticMarks::underline(long begin, long end, Severity severity, int number) {
    editor_->SendScintilla(Sci::SCI_SETINDICATORCURRENT, indicator(severity));
    // The value leads back to the mark, wherever the text has moved to.
    editor_->SendScintilla(Sci::SCI_SETINDICATORVALUE, number);
    editor_->SendScintilla(Sci::SCI_INDICATORFILLRANGE, static_cast<unsigned long>(begin), end - begin);
}

QString DiagnosticMarks::textAt(long position) const {
    QString text;
    for (int i = 0; i < severities; ++i) {
        const long number =
            editor_->SendScintilla(Sci::SCI_INDICATORVALUEAT,
                                   static_cast<unsigned long>(indicator(static_cast<Severity>(i))), position);
        if (number > 0 && number <= static_cast<long>(marks_.size()))
            text += marks_[static_cast<std::size_t>(number - 1)].text;
    }
    return text;
}

QString DiagnosticMarks::textOfLine(int line) const {
    QString text;
    for (const Mark& mark : marks_)
        if (mark.markerHandle >= 0 && editor_->markerLine(mark.markerHandle) == line) text += mark.text;
    return text;
}

QString toolTipText(const Diagnostic& diagnostic) {
    QString text = "<p>" + withCodeAsHtml(diagnostic.message) + "</p>";
    if (!diagnostic.hint.empty()) text += "<p><i>" + withCodeAsHtml(diagnostic.hint) + "</i></p>";
    return text;
}

}  // namespace isoscope
