// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/roots/certified/cell_march.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace isoscope {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

std::uint64_t lanesBelow(std::size_t end) {
    return end < batchLanes ? (std::uint64_t(1) << end) - 1 : ~std::uint64_t(0);
}

}  // namespace

CellMarch::CellMarch(const PreparedFunction& function, const Tools& tools)
    : tools_(tools), pieces_(function, tools.settings, tools.forms) {}

CellMarch::Outcome CellMarch::run(const LineColumns& lines, double sufficient, const std::stop_token& stop,
                                  FirstRoots& roots) {
    rest_.clear();
    unsettled_.clear();
    const auto bundle = LineBundle::around(lines, 0, lines.count);
    if (!bundle) return Outcome::nothingAsked;
    cutSlabs(*bundle);
    cutTiles(lines);
    if (!pays()) return Outcome::vain;
    for (const Slab& slab : slabs_) {
        if (stop.stop_requested()) break;
        if (slab.clear)
            for (Tile& tile : tiles_) skip(tile, slab.range);
        else
            searchSlab(lines, slab, sufficient, roots);
    }
    return Outcome::done;
}

/// Cuts the lines all together.
void CellMarch::cutSlabs(const LineBundle& bundle) {
    pieces_.setBase(nullptr);
    const DepthRange whole{bundle.near, bundle.far};
    for (std::size_t k = 0; k < slabs; ++k) {
        slabs_[k].range = whole.part(k, slabs);
        pieces_.place(bundle, slabs_[k].range, k);
    }
    pieces_.enclose(slabs);
    for (std::size_t k = 0; k < slabs; ++k) {
        slabs_[k].clear = isClear(k);
        if (!slabs_[k].clear) pieces_.simplify(std::uint64_t(1) << k, slabs_[k].tape);
    }
}

void CellMarch::cutTiles(const LineColumns& lines) {
    tiles_.clear();
    starts_.reset(lines.count);
    fars_.resize(lines.count + LineColumns::padding);
    ends_.resize(lines.count + LineColumns::padding);
    searched_ = 0;
    for (std::size_t first = 0; first < lines.count; first += tileLines) {
        Tile& tile = tiles_.emplace_back();
        tile.first = first;
        tile.count = std::min(tileLines, lines.count - first);
        for (std::size_t i = first; i < first + tile.count; ++i) {
            const bool searchable = lines.near[i] < lines.far[i] && lines.far[i] < infinity;
            fars_[i] = searchable ? lines.far[i] : -infinity;
            tile.open += searchable;
        }
        searched_ += tile.open;
        if (const auto bundle = LineBundle::around(lines, first, tile.count))
            tile.bundle = *bundle;
        else
            tile.open = 0;
    }
}

/// Whether tapes become short, going by the depth ranges or else by the cells of one of them.
bool CellMarch::pays() {
    std::size_t tapes = 0, left = 0;
    const Slab* first = nullptr;
    for (const Slab& slab : slabs_) {
        if (slab.clear) continue;
        if (first == nullptr) first = &slab;
        ++tapes, left += slab.tape.instructions.size();
    }
    if (first == nullptr || pieces_.areShort(left, tapes)) return true;
    pieces_.setBase(&first->tape);
    const std::size_t count = std::min(placeCells(tiles_, first->range), slabs);
    pieces_.enclose(count);
    left = 0;
    for (std::size_t lane = 0; lane < count; ++lane) {
        pieces_.simplify(std::uint64_t(1) << lane, cellTape_);
        left += cellTape_.instructions.size();
    }
    return pieces_.areShort(left, count);
}

/// The cells of these tiles, at most tilesAtOnce. Returns how many.
std::size_t CellMarch::placeCells(std::span<Tile> tiles, const DepthRange& range) {
    std::size_t count = 0;
    for (Tile& tile : tiles.first(std::min(tilesAtOnce, tiles.size()))) {
        if (tile.open == 0) continue;
        for (std::size_t k = 0; k < depth; ++k) {
            DepthRange part = range.part(k, depth);
            part.near = std::max(part.near, tile.bundle.near);
            part.far = std::min(part.far, tile.bundle.far);
            if (!(part.near < part.far)) continue;
            pieces_.place(tile.bundle, part, count);
            cells_[count++] = {&tile, part};
        }
    }
    return count;
}

void CellMarch::searchSlab(const LineColumns& lines, const Slab& slab, double sufficient, FirstRoots& roots) {
    pieces_.setBase(&slab.tape);
    for (std::size_t first = 0; first < tiles_.size(); first += tilesAtOnce) {
        const std::size_t count = placeCells(std::span(tiles_).subspan(first), slab.range);
        if (count == 0) continue;
        pieces_.enclose(count);
        for (std::size_t lane = 0, end = 0; lane < count; lane = end) {
            Tile& tile = *cells_[lane].tile;
            end = joinCells(lane, count);
            if (tile.open == 0) continue;
            const DepthRange range{cells_[lane].range.near, cells_[end - 1].range.far};
            if (isClear(lane)) {
                skip(tile, range);
                continue;
            }
            pieces_.simplify(lanesBelow(end) & ~lanesBelow(lane), cellTape_);
            march(lines, tile, range, sufficient, roots);
        }
    }
}

/// The end of the row of cells of a tile that begins with `first`, all of them clear or none.
std::size_t CellMarch::joinCells(std::size_t first, std::size_t count) const {
    std::size_t end = first + 1;
    while (end < count && cells_[end].tile == cells_[first].tile && isClear(end) == isClear(first)) ++end;
    return end;
}

/// The function is positive all along the range.
void CellMarch::skip(Tile& tile, const DepthRange& range) {
    tile.clearTo = range.far;
    if (!tile.hasInside) return;
    // They leave the solid where two ranges meet.
    for (std::size_t i = tile.first; i < tile.first + tile.count; ++i)
        if (fars_[i] > range.near && starts_[i].sign < 0) {
            rest_.push_back({i, starts_[i]});
            close(i, tile);
        }
    tile.hasInside = false;
}

void CellMarch::march(const LineColumns& lines, Tile& tile, const DepthRange& range, double sufficient,
                      FirstRoots& roots) {
    const double length = range.far - range.near;
    if (tile.clearTo > -infinity && !tile.hasInside) {
        starts_.set(tile.first, tile.count, {tile.clearTo, 1, length});
    } else if (tile.hasInside) {
        for (std::size_t i = tile.first; i < tile.first + tile.count; ++i)
            starts_.set(i, 1, {tile.clearTo, starts_[i].sign < 0 ? -1.0 : 1.0, length});
    }
    for (std::size_t i = tile.first; i < tile.first + tile.count; ++i)
        ends_[i] = std::min(fars_[i], range.far);
    LineColumns cut = lines;
    cut.far = ends_.data();
    MarchKernel::Results& found =
        tools_.march.run(cut, tile.first, tile.count, starts_, sufficient, cellTape_);
    tile.clearTo = range.far;
    tile.hasInside = false;
    takeResults(found, lines, tile, roots);
}

void CellMarch::takeResults(MarchKernel::Results& found, const LineColumns& lines, Tile& tile,
                            FirstRoots& roots) {
    for (std::size_t k = 0; k < found.crossings.size(); ++k)
        close(static_cast<std::size_t>(found.crossings[MarchKernel::foundLine][k]), tile);
    for (const std::size_t line : found.entryWalls) {
        roots.entryWalls.push_back(line);
        close(line, tile);
    }
    for (const std::size_t line : found.insideEnds) {
        if (ends_[line] < lines.far[line]) {
            starts_.set(line, 1, {ends_[line], -1, 1});
            tile.hasInside = true;
            continue;
        }
        if (!tools_.settings.open) roots.exitWalls.push_back(line);
        close(line, tile);
    }
    for (const MarchKernel::Line& line : found.rest) {
        rest_.push_back(line);
        close(line.line, tile);
    }
    tools_.polish.run(found.crossings, roots, &cellTape_);
    unsettled_.insert(unsettled_.end(), tools_.polish.unsettled().begin(), tools_.polish.unsettled().end());
}

/// Nothing more is to be found out about the line.
void CellMarch::close(std::size_t line, Tile& tile) {
    fars_[line] = -infinity;
    --tile.open;
}

}  // namespace isoscope
