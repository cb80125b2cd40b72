// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "core/text/source_text.h"
#include "widgets/editor/tracked_ranges.h"
#include "widgets/look.h"

class QsciScintilla;

namespace isoscope {

/// The numbers of the text that sliders are bound to: a soft box under each, which follows every edit.
class NumberMarks {
  public:
    explicit NumberMarks(QsciScintilla* editor);

    static constexpr int indicator = 16;

    /// Replaces all marks. Ranges of other files, or outside of the text, keep their index and get no box.
    void set(const std::vector<SourceRange>& ranges);
    /// Sets the colours of the boxes.
    void applyTheme(Look look);
    /// Where marked number `index` is now; empty once an edit has touched it, or for a bad index.
    std::optional<SourceRange> range(int index) const;
    /// The marked number with exactly these ends; -1 for none.
    int indexOf(int begin, int end) const { return ranges_.indexOf({begin, end}); }

    /// The editor reports each change of its text here; bytes. See TrackedRanges.
    void inserted(int position, int length) { ranges_.inserted(position, length); }
    void removed(int position, int length) { ranges_.removed(position, length); }
    /// Scintilla takes the box away with the old digits; this draws it anew.
    void rewritten(int begin, int oldEnd, int newEnd);
    /// Number `index` has been put at [begin, end).
    void place(int index, int begin, int end);

  private:
    void fill(const TrackedRanges::Range& range);
    /// The boxes that the text has, in its order; those of neighbours are one.
    std::vector<TrackedRanges::Range> boxes() const;

    QsciScintilla* editor_;
    TrackedRanges ranges_;
};

}  // namespace isoscope
