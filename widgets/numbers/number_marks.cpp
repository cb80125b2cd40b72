// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/numbers/number_marks.h"

#include <Qsci/qsciscintilla.h>

namespace isoscope {

using Sci = QsciScintillaBase;

NumberMarks::NumberMarks(QsciScintilla* editor) : editor_(editor) {
    editor->indicatorDefine(QsciScintilla::StraightBoxIndicator, indicator);
    editor->setIndicatorDrawUnder(true, indicator);
    applyTheme(false);
}

void NumberMarks::set(const std::vector<SourceRange>& ranges) {
    const long length = editor_->SendScintilla(Sci::SCI_GETLENGTH);
    editor_->SendScintilla(Sci::SCI_SETINDICATORCURRENT, indicator);
    editor_->SendScintilla(Sci::SCI_INDICATORCLEARRANGE, static_cast<unsigned long>(0), length);
    std::vector<TrackedRanges::Range> tracked;
    for (const SourceRange& range : ranges)
        tracked.push_back({static_cast<int>(range.begin), static_cast<int>(range.end)});
    ranges_.set(tracked);
    for (std::size_t i = 0; i < ranges.size(); ++i) {
        const bool inText = ranges[i].file == 0 && ranges[i].begin < ranges[i].end && ranges[i].end <= length;
        if (inText) fill(tracked[i]);
    }
}

void NumberMarks::applyTheme(bool dark) {
    editor_->setIndicatorForegroundColor(dark ? QColor(0x3d, 0x7e, 0xdb) : QColor(0x2f, 0x6f, 0xd0),
                                         indicator);
    editor_->SendScintilla(Sci::SCI_INDICSETALPHA, indicator, dark ? 56 : 30);
    editor_->SendScintilla(Sci::SCI_INDICSETOUTLINEALPHA, indicator, dark ? 110 : 80);
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
    editor_->SendScintilla(Sci::SCI_INDICATORFILLRANGE, range.begin, range.end - range.begin);
}

}  // namespace isoscope
