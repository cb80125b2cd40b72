// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <vector>

#include "core/shapes/solids/plane_curve.h"
#include "core/virtualight/primitive.h"

namespace isoscope::virtualight {

/// A piece of a profile: a parabola from the first point to the last with the middle one as control point of
/// its Bezier form; a line where that is halfway.
struct ProfileArc {
    std::array<glm::dvec2, 3> points{};
    bool straight = false;
};

/// The curve of a profile (docs/povray/virtualight.md, section 5): lines through all points; or parabolas
/// whose control points are the points beside the curve, with a point of the curve halfway between two of
/// them. In a `polynomial` profile all but the ends lie beside it. The ends always lie on it.
std::vector<ProfileArc> arcsOf(const Profile& profile);

/// The same arc as a polynomial of degree 1 or 2 in u from 0 to 1; and all arcs of a profile, in order.
CurvePiece pieceOf(const ProfileArc& arc);
std::vector<CurvePiece> piecesOf(const Profile& profile);

}  // namespace isoscope::virtualight
