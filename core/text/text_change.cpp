// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/text/text_change.h"

#include <algorithm>

namespace isoscope {

std::string changedText(std::string text, std::vector<TextChange> changes) {
    // From the last to the first, so that each leaves the places of the others alone.
    std::sort(changes.begin(), changes.end(),
              [](const TextChange& a, const TextChange& b) { return a.range.begin > b.range.begin; });
    for (const TextChange& change : changes)
        text.replace(change.range.begin, change.range.end - change.range.begin, change.text);
    return text;
}

}  // namespace isoscope
