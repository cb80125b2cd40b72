// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "core/text/source_text.h"

namespace isoscope {

/// One change of the user's own text (file 0).
struct TextChange {
    SourceRange range;  ///< what goes; empty to insert
    std::string text;   ///< what stands there then
};

/// The text with all changes made; every other byte is kept. They are in any order, and do not overlap.
std::string changedText(std::string text, std::vector<TextChange> changes);

}  // namespace isoscope
