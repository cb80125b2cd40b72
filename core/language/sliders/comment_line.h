// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/language/sliders/text_edit.h"

namespace isoscope {

/// A line of a text, by byte offsets.
struct TextLine {
    std::size_t begin = 0;
    std::size_t end = 0;   ///< before the line break
    std::size_t next = 0;  ///< behind the line break
};

/// All lines of the text, in order; an empty last one is none.
std::vector<TextLine> linesOf(std::string_view text);

/// The text without blanks and tabulators at its ends.
std::string_view trimmed(std::string_view text);

/// Takes `head` from the front of the text, and the blanks before it; false, and nothing taken, where the
/// text begins otherwise.
bool take(std::string_view& text, std::string_view head);

/// Takes a number from the front of the text, and the blanks before it.
std::optional<double> takeNumber(std::string_view& text);

/// Reads `word = 0.5`, the word without `=`; nothing for any other text.
std::optional<std::pair<std::string, double>> readNamedNumber(std::string_view text);

/// The edit that puts `text` in the place of the bytes from `begin` to before `end`.
TextEdit editOf(std::size_t begin, std::size_t end, std::string text);

/// The edit that puts a line in behind the one that ends at `at`, or at the end of the text, with the breaks
/// that the text has.
TextEdit lineInserted(std::string_view text, std::size_t at, const std::string& line);

}  // namespace isoscope
