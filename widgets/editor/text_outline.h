// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string_view>

namespace isoscope {

/// What of a scene text decides where another statement can stand, in POV-Ray's language; byte offsets.
struct TextOutline {
    /// Start of a line, or the end of the text: where a statement belongs that is asked for at the caret,
    /// outside of all braces, comments, conditions, loops and macros, behind the statement that the caret is
    /// in. A caret in the first line, or before the last #include, asks for nothing: the end.
    std::size_t place = 0;
    /// Start of a line, or the end: where an #include belongs, behind #version and first comments.
    std::size_t includePlace = 0;
    bool includesFunctions = false;  ///< functions.inc, before `place` whatever happens
    bool hasCamera = false;
    bool hasLight = false;
};

/// Scans the text once for a caret at this byte; accepts texts with errors.
TextOutline outlineOf(std::string_view text, std::size_t caret);

}  // namespace isoscope
