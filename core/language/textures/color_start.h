// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace isoscope {

class TokenStream;

/// Whether a colour comes next, or a vector, which may be meant as one.
bool atColor(TokenStream& tokens);
/// Whether no value comes next that could be a colour, and no unknown name that could be meant as one.
bool isWithoutColor(TokenStream& tokens);
/// Warns of the vector that comes next where a colour is wanted; a declared colour is one.
void warnOfBareVector(TokenStream& tokens);

}  // namespace isoscope
