// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/scene/material.h"

namespace isoscope {

/// An entry of a map and how much of it shows.
struct MapShare {
    std::size_t entry = 0;
    double share = 1;
};

/// The entries of a map that show where its pattern has `value` (mapValue() for whole textures); their shares
/// add up to 1. Entries that do not show are left out. NaN counts as 0.
void findMapShares(const MappedTexture& map, double value, std::vector<MapShare>& shares);

}  // namespace isoscope
