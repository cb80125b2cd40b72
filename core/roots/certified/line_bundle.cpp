// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/roots/certified/line_bundle.h"

#include "core/roots/certified/bundle_lanes.h"

namespace isoscope {

namespace {

std::optional<LineBundle> firstOf(const BundleLanes& bundles) {
    if (!(bundles.near[0] < bundles.far[0])) return {};
    return bundles[0];
}

}  // namespace

std::optional<LineBundle> LineBundle::around(std::span<const LineQuery> queries,
                                             std::span<const std::uint8_t> wanted) {
    const LineRange all{0, queries.size()};
    BundleLanes bundles;
    bundles.enclose(queries, wanted, {&all, 1});
    return firstOf(bundles);
}

std::optional<LineBundle> LineBundle::around(const LineColumns& lines, std::size_t first, std::size_t count) {
    const LineRange range{first, count};
    BundleLanes bundles;
    bundles.enclose(lines, {&range, 1});
    return firstOf(bundles);
}

void LineBundle::place(std::size_t lane, RayPieces& pieces, RaySpread& spread) const {
    for (int k = 0; k < 3; ++k) {
        const auto axis = static_cast<std::size_t>(k);
        pieces.origin[axis][lane] = origin[k], spread.origin[axis][lane] = originSpread[k];
        pieces.direction[axis][lane] = direction[k], spread.direction[axis][lane] = directionSpread[k];
    }
}

}  // namespace isoscope
