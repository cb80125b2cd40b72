// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <vector>

namespace isoscope {

/// What to look for in a text.
struct SearchRequest {
    QString pattern;
    QString replacement;
    bool caseSensitive = false;
    bool wholeWord = false;
    bool regular = false;
};

/// One match, and what replaces it.
struct SearchMatch {
    int begin = 0;  ///< bytes of the UTF-8 text
    int end = 0;
    QString replacement;  ///< with \1 to \9 and \0 filled in for regular expressions
};

/// The matches of one search, or why it could not be made.
struct SearchResult {
    std::vector<SearchMatch> matches;  ///< in order, not overlapping, none of them empty
    bool cutOff = false;               ///< there are more than searchLimit
    QString error;                     ///< why the regular expression is none
};

constexpr std::size_t searchLimit = 100'000;

/// All matches. `text` is UTF-8; an empty pattern finds nothing. Expressions that run away are stopped by the
/// library and reported as an error.
SearchResult searchText(const std::string& text, const SearchRequest& request);

}  // namespace isoscope
