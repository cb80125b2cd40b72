// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

namespace isoscope {

/// Byte ranges [begin, end) of a text that changes. They move with the text before them; a range that a
/// change touches, at its edges too (a digit typed behind "1" makes another number), is lost.
class TrackedRanges {
  public:
    /// Bytes [begin, end).
    struct Range {
        int begin = 0;
        int end = 0;

        friend bool operator==(const Range&, const Range&) = default;
    };

    /// Replaces all ranges. Their indexes stay the same until the next call; count() includes lost ones.
    void set(std::vector<Range> ranges);
    int count() const { return static_cast<int>(ranges_.size()); }
    /// Empty when lost or when there is no such range.
    std::optional<Range> range(int index) const;
    /// The range with exactly these ends; -1 for none.
    int indexOf(const Range& range) const;

    /// The text was changed: `length` bytes were put in at `position`, or taken out from there on.
    void inserted(int position, int length);
    void removed(int position, int length);
    /// Bytes [begin, oldEnd) were deliberately rewritten as [begin, newEnd): the ranges equal to it and those
    /// around it follow; those it cuts, or that lie inside it, are lost.
    void rewritten(int begin, int oldEnd, int newEnd);
    /// The number was put somewhere else.
    void place(int index, const Range& range);

  private:
    std::vector<std::optional<Range>> ranges_;
};

}  // namespace isoscope
