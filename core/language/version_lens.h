// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/language/parse.h"

namespace isoscope {

/// Says in notes what the `#version` of the user's own text changes: at the directive what is read by other
/// rules than those of 3.7 (measured on POV-Ray 3.7's pictures), and at the first use of each word that it is
/// newer than the version asked for. Nothing for 3.7, and for texts without the directive.
void addVersionNotes(ParseResult& result);

/// Whether the generator of noise of a text is that of POV-Ray 3.1: before version 3.5, unless it says
/// otherwise.
bool hasOldNoise(const ParseResult& result);

}  // namespace isoscope
