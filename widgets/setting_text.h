// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <QString>

#include "core/language/parse.h"

namespace isoscope {

/// One change of the user's text.
struct TextChange {
    SourceRange range;  ///< of file 0; empty to insert
    QString text;
};

/// How to give an isosurface of the parsed text another max_gradient: its number, or expression, is replaced;
/// where the statement has none, one is inserted behind the function. Nothing when the statement does not
/// stand in the user's own text.
std::optional<TextChange> maxGradientChange(const ParseResult& parsed, std::size_t isosurface, double value);

}  // namespace isoscope
