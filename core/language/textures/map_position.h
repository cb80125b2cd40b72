// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace isoscope {

class TokenStream;

/// The number, with a comma behind it, in front of an entry of a map of pigments, normals or textures: 1
/// where there is none, which POV-Ray takes in `average` alone. Elsewhere that is warned of.
double parseMapPosition(TokenStream& tokens, bool isAverage);

}  // namespace isoscope
