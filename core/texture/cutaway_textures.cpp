// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/texture/cutaway_textures.h"

namespace isoscope {

namespace {

void collect(const CutawayTextures::Part& whole, const std::array<double, 3>& point,
             std::vector<TextureShare>& shares) {
    for (const CutawayTextures::Part& part : whole.parts) {
        if (!part.solid || part.solid->value(point) == 0) continue;
        if (part.texture > 0)
            shares.push_back({part.texture, 1});
        else if (!part.parts.empty())
            collect(part, point, shares);
        else if (whole.joins)
            shares.push_back({0, 1});
    }
}

}  // namespace

std::vector<TextureShare> CutawayTextures::textureShares(const glm::dvec3& point) const {
    std::vector<TextureShare> shares;
    collect(whole_, {point.x, point.y, point.z}, shares);
    if (shares.empty()) return {{0, 1}};
    for (TextureShare& one : shares) one.share = 1 / static_cast<double>(shares.size());
    return shares;
}

}  // namespace isoscope
