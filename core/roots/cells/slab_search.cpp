// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/roots/cells/slab_search.h"

#include <algorithm>

#include "core/roots/certified/line_bundle.h"

namespace isoscope {

SlabSearch::SlabSearch(const PreparedFunction& function, const SearchTools& tools, PartTapes& parts)
    : shortTapes_(function), pieces_(function, tools.settings, tools.forms), parts_(parts), lanes_(tools) {}

bool SlabSearch::pays(std::span<const LineQuery> queries, std::span<const std::uint8_t> wanted) {
    common_ = nullptr;
    pieces_.setBase(nullptr);
    if (enclose(queries, wanted, 0, queries.size(), 0)) {
        pieces_.enclose(slabs);
        takeCommon();
        // Depth ranges leave out still more.
        if (shortTapes_.areShort(commonTape_.instructions.size(), 1)) return true;
        if (becomesShort()) return true;
    }
    std::size_t first = 0;
    while (first < queries.size() && !enclose(queries, wanted, first, tileLines, 0)) first += tileLines;
    return first < queries.size() && becomesShort();
}

/// Whether the tape becomes short in the depth ranges of tile 0.
bool SlabSearch::becomesShort() {
    pieces_.enclose(slabs);
    std::size_t left = 0;
    for (std::size_t slab = 0; slab < slabs; ++slab) {
        simplify(0, slab);
        left += simplifiedTape_.instructions.size();
    }
    return shortTapes_.areShort(left, slabs);
}

/// Leaves out what is decided alike in all depth ranges of tile 0.
void SlabSearch::takeCommon() {
    pieces_.simplify((std::uint64_t(1) << slabs) - 1, commonTape_);
    common_ = &commonTape_;
    pieces_.setBase(common_);
}

/// Places the depth ranges of tile number `tile` of a batch, which has up to `count` lines from `first` on.
/// False where they are no bundle.
bool SlabSearch::enclose(std::span<const LineQuery> queries, std::span<const std::uint8_t> wanted,
                         std::size_t first, std::size_t count, std::size_t tile) {
    const std::size_t begin = std::min(first, queries.size());
    const std::size_t end = std::min(begin + count, queries.size());
    const auto asked = wanted.subspan(begin, end - begin);
    const auto bundle = LineBundle::around(queries.subspan(begin, end - begin), asked);
    const bool anyWanted = std::ranges::any_of(asked, [](std::uint8_t line) { return line != 0; });
    tiles_[tile] = {begin, end, anyWanted, false, {}, {}};
    if (!bundle) return false;
    tiles_[tile] = {begin, end, true, true, {bundle->near, bundle->far}, *bundle};
    for (std::size_t slab = 0; slab < slabs; ++slab)
        pieces_.place(*bundle, tiles_[tile].depth.part(slab, slabs), tile * slabs + slab);
    return true;
}

bool SlabSearch::begin(std::span<const LineQuery> queries, std::span<const std::uint8_t> wanted,
                       std::size_t first) {
    std::size_t used = 0;
    for (std::size_t tile = 0; tile < tilesAtOnce; ++tile)
        if (enclose(queries, wanted, first + tile * tileLines, tileLines, tile)) used = (tile + 1) * slabs;
    if (used == 0) return false;
    const bool byParts = addMetParts();
    holds_ = false;
    if (byParts && !parts_.meets()) {
        pieces_.setOutside(used);
        return true;
    }
    pieces_.setBase(byParts ? &parts_.make() : common_);
    pieces_.enclose(used);
    if (!byParts && !pieces_.mostDecided(used)) return false;
    holds_ = std::ranges::all_of(tiles_, [](const Tile& tile) { return tile.enclosed || !tile.wanted; });
    if (holds_) pieces_.simplify(enclosedLanes(), batchTape_);
    return true;
}

/// Looks for the parts of a union that the lines of the tiles meet. False where that is not known.
bool SlabSearch::addMetParts() {
    return parts_.begin() && std::ranges::all_of(tiles_, [&](const Tile& tile) {
               return !tile.enclosed || parts_.add(tile.bundle);
           });
}

/// A bit for each lane that has a piece of an enclosed tile.
std::uint64_t SlabSearch::enclosedLanes() const {
    std::uint64_t lanes = 0;
    for (std::size_t tile = 0; tile < tilesAtOnce; ++tile)
        if (tiles_[tile].enclosed) lanes |= ((std::uint64_t(1) << slabs) - 1) << (tile * slabs);
    return lanes;
}

CertainStart SlabSearch::certainStart(std::size_t tile) const {
    if (!tiles_[tile].enclosed) return {};
    const DepthRange& depth = tiles_[tile].depth;
    const double sign = pieces_.sign(tile * slabs);
    if (sign == 0) return {depth.near, 0, 0};
    std::size_t clear = 1;
    while (clear < slabs && pieces_.sign(tile * slabs + clear) == sign) ++clear;
    return {end(tile, clear - 1), sign, (depth.far - depth.near) / slabs};
}

void SlabSearch::noteStarts(CertainStarts& starts) const {
    for (std::size_t tile = 0; tile < tilesAtOnce; ++tile) {
        if (!tiles_[tile].enclosed) continue;
        starts.set(tiles_[tile].first, tiles_[tile].end - tiles_[tile].first, certainStart(tile));
    }
}

void SlabSearch::simplify(std::size_t tile, std::size_t slab) {
    pieces_.simplify(std::uint64_t(1) << (tile * slabs + slab), simplifiedTape_);
}

}  // namespace isoscope
