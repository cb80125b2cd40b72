// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/roots/cells/cell_march.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <limits>

#include "core/evaluate/jumps/affine_cases.h"

namespace isoscope {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
/// Of tapes that are shorter than this, those of pieces alone are not worth their making.
constexpr std::size_t longTape = 128;
/// Cells that cost more than so many enclosures of each line by the whole tape do not pay.
constexpr std::size_t dearestLine = 48;

/// The instructions of a tape, which count more where it holds steps: lines that march by it end at the
/// first.
std::size_t burdenOf(const SimplifiedTape& tape) {
    constexpr std::size_t costOfSteps = 4;
    const bool hasSteps = std::ranges::any_of(tape.instructions, [](const Instruction& instruction) {
        return hasSides(instruction.operation) && !isChoice(instruction.operation);
    });
    return tape.instructions.size() * (hasSteps ? costOfSteps : 1);
}

std::uint64_t lanesFrom(std::size_t first, std::size_t end) {
    const std::uint64_t below = end < batchLanes ? (std::uint64_t(1) << end) - 1 : ~std::uint64_t(0);
    return below & (~std::uint64_t(0) << first);
}

}  // namespace

CellMarch::CellMarch(const PreparedFunction& function, const Tools& tools)
    : tools_(tools),
      shortTapes_(function),
      tree_(function, tools.settings),
      pieces_(function, tools.settings),
      settler_(tools.settings, tools.fallback, tools.gradients) {}

CellMarch::Outcome CellMarch::run(const LineColumns& lines, double sufficient, const std::stop_token& stop,
                                  FirstRoots& roots) {
    rest_.clear();
    const auto bundle = LineBundle::around(lines, 0, lines.count);
    if (!bundle) return Outcome::nothingAsked;
    tree_.begin(*bundle);
    cutTiles(lines);
    if (!parts_) parts_.emplace(tools_.parts.get(), tools_.march, tools_.polish, settler_);
    if (!parts_->possible() && !pays()) return Outcome::vain;
    std::size_t begun = 0;
    const std::uint64_t before = work();
    for (Tile& tile : tiles_) {
        if (stop.stop_requested()) break;
        begun += tile.open;
        if (parts_->possible()) searchParts(lines, tile, sufficient, roots);
        search(lines, tile, sufficient, roots);
        const std::uint64_t most = (begun + tileLines) * dearestLine * tree_.whole().instructions.size();
        if (work() - before > most) return Outcome::vain;
    }
    return Outcome::done;
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

/// Whether tapes become short, going by the first cells of some tiles, or else by pieces of one of them.
bool CellMarch::pays() {
    constexpr std::size_t samples = 4;
    std::size_t tapes = 0, left = 0;
    bool piecesAreShort = false;
    for (std::size_t k = 0; k < samples; ++k) {
        const Tile& tile = tiles_[(2 * k + 1) * tiles_.size() / (2 * samples)];
        if (tile.open == 0) continue;
        for (double t = tile.bundle.near; t < tile.bundle.far;) {
            const CellTree::Cell& cell = tree_.find(tile.bundle, t);
            const double end = cell.exit(tile.bundle);
            if (!(end > t)) return false;
            if (cell.sign <= 0) {
                if (tapes++ == 0 && tree_.whole().instructions.size() >= longTape)
                    piecesAreShort = makesShort(cell, tile.bundle, {t, end});
                left += burdenOf(*cell.tape);
                break;
            }
            t = end;
        }
    }
    return piecesAreShort || shortTapes_.areShort(left, tapes) || tapes == 0;
}

/// Whether tapes become short in the pieces of a bundle's way through a cell.
bool CellMarch::makesShort(const CellTree::Cell& cell, const LineBundle& bundle, const DepthRange& range) {
    enclosePieces(cell, bundle, range);
    std::size_t left = 0;
    for (std::size_t lane = 0; lane < depth; ++lane) {
        pieces_.simplify(lanesFrom(lane, lane + 1), pieceTape_);
        left += burdenOf(pieceTape_);
    }
    return shortTapes_.areShort(left, depth);
}

void CellMarch::enclosePieces(const CellTree::Cell& cell, const LineBundle& bundle, const DepthRange& range) {
    pieces_.setBase(*cell.tape);
    for (std::size_t k = 0; k < depth; ++k) {
        const DepthRange part = range.part(k, depth);
        const double middle = 0.5 * (part.near + part.far), half = 0.5 * (part.far - part.near);
        pieces_.place(
            bundle.origin + middle * bundle.direction,
            bundle.originSpread + part.far * bundle.directionSpread + half * glm::abs(bundle.direction), k);
    }
    pieces_.enclose(depth);
}

/// The lines of a tile by the parts of a union, as far as that settles them.
void CellMarch::searchParts(const LineColumns& lines, Tile& tile, double sufficient, FirstRoots& roots) {
    if (tile.open == 0) return;
    parts_->run(lines, tile.first, tile.count, tile.bundle, sufficient, &fars_[tile.first], roots);
    const auto isOpen = [](double far) { return far > -infinity; };
    const auto fars = std::span(fars_).subspan(tile.first, tile.count);
    tile.open = static_cast<std::size_t>(std::ranges::count_if(fars, isOpen));
}

/// The lines of a tile, from cell to cell.
void CellMarch::search(const LineColumns& lines, Tile& tile, double sufficient, FirstRoots& roots) {
    for (double t = tile.bundle.near; tile.open > 0 && t < tile.bundle.far;) {
        const CellTree::Cell& cell = tree_.find(tile.bundle, t);
        const double end = cell.exit(tile.bundle);
        if (!(end > t)) return march(lines, tile, {t, tile.bundle.far}, tree_.whole(), sufficient, roots);
        searchCell(lines, cell, tile, {t, end}, sufficient, roots);
        t = end;
    }
}

void CellMarch::searchCell(const LineColumns& lines, const CellTree::Cell& cell, Tile& tile,
                           const DepthRange& range, double sufficient, FirstRoots& roots) {
    if (cell.sign > 0) return skip(tile, range);
    if (cell.tape->instructions.size() <= ShortTapes::shortLength)
        return march(lines, tile, range, *cell.tape, sufficient, roots);
    enclosePieces(cell, tile.bundle, range);
    for (std::size_t piece = 0, end = 0; piece < depth && tile.open > 0; piece = end) {
        end = joinPieces(piece);
        const DepthRange joined{range.border(piece, depth), range.border(end, depth)};
        if (pieces_.sign(piece) > 0) {
            skip(tile, joined);
            continue;
        }
        pieces_.simplify(lanesFrom(piece, end), pieceTape_);
        march(lines, tile, joined, pieceTape_, sufficient, roots);
    }
}

/// The end of the row of pieces that begins with `first`, the function positive in all of them or in none.
std::size_t CellMarch::joinPieces(std::size_t first) const {
    std::size_t end = first + 1;
    while (end < depth && (pieces_.sign(end) > 0) == (pieces_.sign(first) > 0)) ++end;
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

void CellMarch::march(const LineColumns& lines, Tile& tile, const DepthRange& range,
                      const SimplifiedTape& tape, double sufficient, FirstRoots& roots) {
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
    const std::uint64_t enclosures = tools_.forms.evaluations();
    MarchKernel::Results& found = tools_.march.run(cut, tile.first, tile.count, starts_, sufficient, tape);
    work_ += (tools_.forms.evaluations() - enclosures) * tape.instructions.size();
    tile.clearTo = range.far;
    tile.hasInside = false;
    takeResults(found, lines, tile, tape, roots);
}

void CellMarch::takeResults(MarchKernel::Results& found, const LineColumns& lines, Tile& tile,
                            const SimplifiedTape& tape, FirstRoots& roots) {
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
    tools_.polish.run(found.crossings, roots, &tape);
    const auto settled = settler_.run(lines, tools_.polish.unsettled(), tape);
    roots.others.insert(roots.others.end(), settled.begin(), settled.end());
}

/// Nothing more is to be found out about the line.
void CellMarch::close(std::size_t line, Tile& tile) {
    fars_[line] = -infinity;
    --tile.open;
}

}  // namespace isoscope
