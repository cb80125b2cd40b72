// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string_view>
#include <vector>

namespace isoscope {

/// Whether POV-Ray 3.7 reserves the word: it cannot be declared or name a parameter.
bool isKeyword(std::string_view word);

/// Every reserved word, sorted: for completion and "did you mean".
const std::vector<std::string_view>& keywords();

/// Objects of the language that this program does not draw (`lemon`, `ovus`).
bool isObjectNotDrawn(std::string_view word);

/// Statements with a block that have no effect here (`radiosity`, `photons`, ...).
bool isStatementNotSimulated(std::string_view word);

}  // namespace isoscope
