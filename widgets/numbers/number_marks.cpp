// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/numbers/number_marks.h"

#include <Qsci/qsciscintilla.h>

#include <algorithm>

namespace isoscope {

using Sci = QsciScintillaBase;

NumberMarks::NumberMarks(QsciScintilla* editor) : editor_(editor) {
    editor->indicatorDefine(QsciScintilla::StraightBoxIndicator, indicator);
    editor->setIndicatorDrawUnder(true, indicator);
    applyTheme(Look::light);
}

void NumberMarks::set(const std::vector<SourceRange>& ranges) {
    const long length = editor_->SendScintilla(Sci::SCI_GETLENGTH);
    std::vector<TrackedRanges::Range> tracked, inText;
    for (const SourceRange& range : ranges) {
        tracked.push_back({static_cast<int>(range.begin), static_cast<int>(range.end)});
        if (range.file == 0 && range.begin < range.end && range.end <= length)
            inText.push_back(tracked.back());
    }
    ranges_.set(tracked);
    // For boxes that are drawn anew the editor would paint all of its text.
    std::ranges::sort(inText, {}, &TrackedRanges::Range::begin);
    if (boxes() == inText) return;
    editor_->SendScintilla(Sci::SCI_SETINDICATORCURRENT, indicator);
    editor_->SendScintilla(Sci::SCI_INDICATORCLEARRANGE, static_cast<unsigned long>(0), length);
    for (const TrackedRanges::Range& range : inText) fill(range);
}

std::vector<TrackedRanges::Range> NumberMarks::boxes() const {
    std::vector<TrackedRanges::Range> found;
    const int length = static_cast<int>(editor_->SendScintilla(Sci::SCI_GETLENGTH));
    for (int at = 0; at < length;) {
        const auto end = static_cast<int>(editor_->SendScintilla(Sci::SCI_INDICATOREND, indicator, at));
        if (end <= at) break;  // there has never been a box
        if (editor_->SendScintilla(Sci::SCI_INDICATORVALUEAT, indicator, at) != 0) found.push_back({at, end});
        at = end;
    }
    return found;
}

void NumberMarks::applyTheme(Look look) {
    // In high contrast the number keeps the ground of its line, and the box is a line.
    const bool line = look == Look::highContrast;
    const int groundAlpha = line ? 0 : look == Look::dark ? 56 : 30;
    const int outlineAlpha = line ? 255 : look == Look::dark ? 110 : 80;
    editor_->setIndicatorForegroundColor(lookColor(look, 0x2f6fd0, 0x3d7edb), indicator);
    editor_->SendScintilla(Sci::SCI_INDICSETALPHA, indicator, groundAlpha);
    editor_->SendScintilla(Sci::SCI_INDICSETOUTLINEALPHA, indicator, outlineAlpha);
}

std::optional<SourceRange> NumberMarks::range(int index) const {
    const auto range = ranges_.range(index);
    if (!range) return std::nullopt;
    return SourceRange{0, static_cast<std::uint32_t>(range->begin), static_cast<std::uint32_t>(range->end)};
}

void NumberMarks::rewritten(int begin, int oldEnd, int newEnd) {
    ranges_.rewritten(begin, oldEnd, newEnd);
    for (int i = 0; i < ranges_.count(); ++i) {
        const auto range = ranges_.range(i);
        if (range && range->begin <= begin && range->end >= newEnd) fill(*range);
    }
}

void NumberMarks::place(int index, int begin, int end) {
    ranges_.place(index, {begin, end});
    fill({begin, end});
}

void NumberMarks::fill(const TrackedRanges::Range& range) {
    editor_->SendScintilla(Sci::SCI_SETINDICATORCURRENT, indicator);
    editor_->SendScintilla(Sci::SCI_SETINDICATORVALUE, 1);
    editor_->SendScintilla(Sci::SCI_INDICATORFILLRANGE, static_cast<unsigned long>(range.begin),
                           range.end - range.begin);
}

}  // namespace isoscope
