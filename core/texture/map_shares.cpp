// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/texture/map_shares.h"

#include <algorithm>
#include <cmath>

namespace isoscope {

namespace {

void findAverage(const MappedTexture& map, std::vector<MapShare>& shares) {
    double total = 0;
    for (const MappedTexture::Entry& entry : map.entries) total += entry.position;
    for (std::size_t k = 0; k < map.entries.size(); ++k)
        if (const double weight = map.entries[k].position; weight != 0)
            shares.push_back({k, total != 0 ? weight / total : weight});
}

}  // namespace

void findMapShares(const MappedTexture& map, double value, std::vector<MapShare>& shares) {
    shares.clear();
    const auto& entries = map.entries;
    const std::size_t last = entries.size() - 1;
    if (std::isnan(value)) value = 0;
    if (map.kind == MapKind::average) return findAverage(map, shares);
    if (value >= entries[last].position) return shares.push_back({last, 1});
    std::size_t k = 0;
    while (k < last && value > entries[k].position) ++k;
    if (k == 0) return shares.push_back({0, 1});
    const double from = entries[k - 1].position, to = entries[k].position;
    const double share = to > from ? (value - from) / (to - from) : 1;
    if (share < 1) shares.push_back({k - 1, 1 - share});
    if (share > 0) shares.push_back({k, share});
}

}  // namespace isoscope
