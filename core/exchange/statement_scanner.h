// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace isoscope {

/// A piece of scene text that stands on its own at the outermost level: a directive, a whole `#macro ...
/// #end`, `#if ... #end` or loop, or a statement with its block.
struct ScenePiece {
    std::size_t begin = 0, end = 0;  ///< bytes of the text
    std::string directive;           ///< "declare", "include", "macro", ...; empty for statements
    std::set<std::string> declared;  ///< names that it declares, at any depth
    std::set<std::string> used;      ///< all identifiers in it
};

/// Cuts a scene text into its outermost pieces, by words, braces, strings and comments alone; nothing is
/// evaluated, so that it works on any text. Text that no piece covers is white space, comments and stray
/// signs.
std::vector<ScenePiece> scanPieces(std::string_view text);

/// The identifiers of a text, keywords included; comments and strings left out.
std::set<std::string> identifiersIn(std::string_view text);

}  // namespace isoscope
