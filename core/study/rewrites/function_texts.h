// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/language/parse.h"
#include "core/study/rewrites/formula_tree.h"

namespace isoscope {

/// A formula of the user's own text that decides where an isosurface is.
struct FunctionText {
    FormulaPointer formula;
    std::vector<std::string> arguments;
    std::uint32_t statement = 0;  ///< the byte where a declaration can be put in front of it
    std::string name;             ///< of a declared function; empty for the isosurface's own
    /// The isosurface is where this formula has its threshold: its own formula, or one that its own is a call
    /// of with the same arguments.
    bool whole = false;
};

/// The isosurface's own formula and those of the functions that it calls, however deep, each once. Empty
/// where the isosurface stands in another text. What readFormula() does not understand is left out.
std::vector<FunctionText> functionTexts(const ParseResult& parsed, std::size_t isosurface);

/// How often a word stands in the text, comments and strings not counted.
std::size_t countWord(std::string_view text, std::string_view word);

}  // namespace isoscope
