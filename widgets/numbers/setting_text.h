// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <QString>
#include <vector>

#include "core/language/parse.h"

namespace isoscope {

/// One change of the user's text.
struct TextChange {
    SourceRange range;  ///< of file 0; empty to insert
    QString text;
};

/// How to give an isosurface of the parsed text another accuracy or max_gradient (`role`): its number, or
/// expression, is replaced; where the statement has none, one is inserted behind the function. Nothing for
/// other roles, and when the statement does not stand in the user's own text.
std::optional<TextChange> settingChange(const ParseResult& parsed, std::size_t isosurface, ParameterRole role,
                                        double value);

/// The changes for all isosurfaces whose statements stand in the user's own text, from the last to the first,
/// so that each leaves the places of the others alone.
std::vector<TextChange> settingChanges(const ParseResult& parsed, ParameterRole role, double value);

}  // namespace isoscope
