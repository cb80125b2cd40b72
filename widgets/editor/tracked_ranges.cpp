// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/editor/tracked_ranges.h"

#include <algorithm>

namespace isoscope {

void TrackedRanges::set(std::vector<Range> ranges) { ranges_.assign(ranges.begin(), ranges.end()); }

std::optional<TrackedRanges::Range> TrackedRanges::range(int index) const {
    if (index < 0 || index >= count()) return std::nullopt;
    return ranges_[static_cast<std::size_t>(index)];
}

int TrackedRanges::indexOf(const Range& range) const {
    const auto found = std::find(ranges_.begin(), ranges_.end(), std::optional(range));
    return found == ranges_.end() ? -1 : static_cast<int>(found - ranges_.begin());
}

void TrackedRanges::inserted(int position, int length) {
    for (auto& range : ranges_) {
        if (!range || position > range->end) continue;
        if (position >= range->begin) {
            range.reset();
        } else {
            range->begin += length;
            range->end += length;
        }
    }
}

void TrackedRanges::removed(int position, int length) {
    for (auto& range : ranges_) {
        if (!range || position > range->end) continue;
        if (position + length >= range->begin) {
            range.reset();
        } else {
            range->begin -= length;
            range->end -= length;
        }
    }
}

void TrackedRanges::rewritten(int begin, int oldEnd, int newEnd) {
    const int growth = newEnd - oldEnd;
    for (auto& range : ranges_) {
        if (!range || range->end <= begin) continue;
        if (range->begin >= oldEnd) {
            range->begin += growth;
            range->end += growth;
        } else if (range->begin <= begin && range->end >= oldEnd) {
            range->end += growth;
        } else {
            range.reset();
        }
    }
}

void TrackedRanges::place(int index, const Range& range) {
    if (index >= 0 && index < count()) ranges_[static_cast<std::size_t>(index)] = range;
}

}  // namespace isoscope
