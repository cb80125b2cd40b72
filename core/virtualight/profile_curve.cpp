// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/virtualight/profile_curve.h"

namespace isoscope::virtualight {

std::vector<ProfileArc> arcsOf(const Profile& profile) {
    const std::vector<ProfilePoint>& points = profile.points;
    std::vector<ProfileArc> arcs;
    const auto on = [&](std::size_t i) {
        if (i == 0 || i + 1 == points.size() || profile.method == ProfileMethod::straight) return true;
        return profile.method == ProfileMethod::conditional && points[i].on;
    };
    glm::dvec2 from = points.front().place;
    for (std::size_t i = 1; i < points.size(); ++i) {
        const glm::dvec2 place = points[i].place;
        if (on(i)) {
            if (place != from) arcs.push_back({{from, (from + place) * 0.5, place}, true});
            from = place;
            continue;
        }
        // A point beside the curve is never the last one.
        const glm::dvec2 next = points[i + 1].place;
        const glm::dvec2 to = on(i + 1) ? next : (place + next) * 0.5;
        arcs.push_back({{from, place, to}, false});
        from = to;
        if (on(i + 1)) ++i;
    }
    return arcs;
}

CurvePiece pieceOf(const ProfileArc& arc) {
    const auto& [a, b, c] = arc.points;
    CurvePiece piece;
    piece.c[0] = a;
    if (arc.straight) {
        piece.c[1] = c - a;
    } else {
        piece.c[1] = 2.0 * (b - a);
        piece.c[2] = a - 2.0 * b + c;
        piece.degree = 2;
    }
    return piece;
}

std::vector<CurvePiece> piecesOf(const Profile& profile) {
    std::vector<CurvePiece> pieces;
    for (const ProfileArc& arc : arcsOf(profile)) pieces.push_back(pieceOf(arc));
    return pieces;
}

}  // namespace isoscope::virtualight
