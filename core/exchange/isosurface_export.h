// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <string>

#include "core/language/parse.h"

namespace isoscope {

/// An isosurface on its own, or the reason why it cannot be written.
struct IsosurfaceExport {
    std::string text;     ///< empty when it cannot be written
    std::string problem;  ///< then why: a sentence
};

/// The isosurface number `index` of `parsed` with the declarations it needs, as an include file that stands
/// on its own: the user's text of the declarations that it uses, directly or through each other, from the
/// scene and the include files beside it; `#include` of the standard files and those in the library paths;
/// and values instead of text for numbers that the text changes (variables of loops, parameters of macros).
///
/// The result was read again, and its function and settings are those of the isosurface; where that fails,
/// `problem` says so instead. Materials are not compared.
IsosurfaceExport exportIsosurface(const ParseResult& parsed, std::size_t index);

/// The text of an export of `parsed` with a comment (proofNote()) in front of its isosurface; as it is when
/// the comment is empty.
std::string withNote(const std::string& text, const std::string& note, const ParseResult& parsed);

}  // namespace isoscope
