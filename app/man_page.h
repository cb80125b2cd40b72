// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace isoscope {

/// One entry of a list in a manual page: what is typed, in bold, and what it does.
struct ManEntry {
    std::string term;  ///< "--size WxH"
    std::string text;
};

/// A section of a manual page.
struct ManSection {
    std::string title;  ///< "OPTIONS"; small letters make a heading below the section before
    std::string text;   ///< paragraphs, apart by empty lines; may be empty
    std::vector<ManEntry> entries;
};

/// A manual page of section 1, in man(7).
struct ManPage {
    std::string program;
    std::string version;
    std::string summary;   ///< half a sentence for NAME
    std::string synopsis;  ///< behind the program's name
    std::vector<ManSection> sections;
};

/// The page as roff. Texts are plain: whatever roff would take for its own is escaped.
std::string toRoff(const ManPage& page);

}  // namespace isoscope
