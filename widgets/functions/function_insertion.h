// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <stop_token>
#include <string>
#include <vector>

#include "core/function/builtins/builtin.h"
#include "core/language/parse.h"
#include "widgets/editor/text_search.h"

namespace isoscope {

/// The changes of a text that bring in a function.
struct FunctionInsertion {
    std::vector<SearchMatch> changes;  ///< in order, for SceneEditor::replaceText()
    int caret = 0;                     ///< byte behind what was asked for, in the text that results
    /// The text's camera shows all of it: it is new, or was moved because nothing was to be seen before.
    bool cameraWritten = false;
};

/// A whole isosurface of the function, as its Showing says: behind the statement that the caret is in, to the
/// right of what `parsed`, the same text as read, shows, and scaled where the sizes are too unlike. What a
/// text lacks that POV-Ray needs to show it comes along: `#include "functions.inc"`, a camera, light. Takes
/// some milliseconds; never throws; a stop leaves the place to chance.
FunctionInsertion insertStatement(const Builtin& builtin, const ParseResult& parsed, const std::string& text,
                                  std::size_t caret, std::stop_token stop = {});

/// The call of the function in the place of the selection from `begin` to `end`, with the include it needs.
FunctionInsertion insertCall(const Builtin& builtin, const std::string& text, std::size_t begin,
                             std::size_t end);

}  // namespace isoscope
