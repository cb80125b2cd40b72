// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/contour/cell_refinement.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>

#include "core/mesh/contour/quadric_fit.h"
#include "core/render/progressive/worker_pool.h"

namespace isoscope {

namespace {

constexpr std::size_t cellsOfBatch = 128;
/// Tangent planes may miss the point that they are fitted by so much of the tolerance. Triangles between such
/// points are off by about thrice as much.
constexpr double residualShare = 0.3;
/// Normals in a cell differ from their mean by less: 0.57 is a corner of a cube.
constexpr double leastCosine = 0.25;
/// Of a cell, beside its samples: the cell, marks of it, and a copy where the tree grows.
constexpr std::size_t bytesOfCell = 60;
/// Of the edge of a polygon, its passages, corners and places; and of a triangle, of which some polygons have
/// two and others four. Found by trial: noise, sines with hundreds of periods.
constexpr std::size_t bytesOfPolygon = 600, bytesOfTriangle = 60;
constexpr double trianglesOfPolygon = 3.5;
/// How many times the crossed edges of cells grow in number as these are split: where the surface is plane in
/// them, and where the signs of the function are random.
constexpr double growthOfPlane = 4, growthOfNoise = 8;
/// A value at all corners hides no dip below 0 if it is so many times what is left of it without the tangent.
constexpr double dipFactor = 1.5;

/// Whether the corners of one sign hang together by edges of the cell.
bool hangsTogether(unsigned corners) {
    if (corners == 0) return true;
    unsigned reached = corners & (~corners + 1);
    for (unsigned before = 0; before != reached;) {
        before = reached;
        const unsigned byX = (reached & 0x55) << 1 | (reached & 0xaa) >> 1;
        const unsigned byY = (reached & 0x33) << 2 | (reached & 0xcc) >> 2;
        const unsigned byZ = (reached & 0x0f) << 4 | (reached & 0xf0) >> 4;
        reached |= (byX | byY | byZ) & corners;
    }
    return reached == corners;
}

/// Whether opposite corners of a face alone are of one sign.
bool hasDoubtfulFace(unsigned inside) {
    for (unsigned axis = 0; axis < 3; ++axis) {
        const unsigned u = 1u << (axis + 1) % 3, v = 1u << (axis + 2) % 3;
        for (const unsigned base : {0u, 1u << axis}) {
            const auto is = [&](unsigned corner) { return (inside >> corner & 1) != 0; };
            const bool a = is(base), b = is(base + u), c = is(base + u + v), d = is(base + v);
            if (a == c && b == d && a != b) return true;
        }
    }
    return false;
}

/// The edge of a cell that begins at a corner.
MinimalEdge edgeOf(std::uint32_t number, const Cell& cell, unsigned corner, unsigned axis) {
    MinimalEdge edge;
    edge.low = CellOctree::corner(cell, corner);
    edge.axis = static_cast<std::uint8_t>(axis);
    edge.level = cell.level;
    edge.cells = {number, number, number, number};
    return edge;
}

/// Calls visit(corner, axis) for the edges that have one end inside.
template <class Visit>
void forEachCrossedEdge(unsigned inside, Visit visit) {
    for (unsigned axis = 0; axis < 3; ++axis)
        for (unsigned corner = 0; corner < 8; ++corner) {
            const unsigned other = corner | 1u << axis;
            if (other != corner && (inside >> corner & 1) != (inside >> other & 1)) visit(corner, axis);
        }
}

}  // namespace

/// What has to be asked of the function before a cell may stay whole.
struct CellRefinement::Check {
    std::size_t number;  ///< in the list of cells
    glm::dvec3 in, out;  ///< must lie inside and outside
};

void CellRefinement::split(std::vector<std::uint32_t> leaves, const std::function<void(int)>& progress,
                           const std::stop_token& stop) {
    while (!leaves.empty() && !stop.stop_requested()) {
        keepLimit(leaves);
        if (leaves.empty()) return;
        const std::size_t firstChild = tree_.size();
        const std::size_t before = quartersOf(leaves);
        quarters_ -= before;
        tree_.split(leaves, samplers_, workers_, stop);
        if (stop.stop_requested()) return;
        std::vector<std::uint32_t> unproven;
        int level = 0;
        for (std::size_t cell = firstChild; cell < tree_.size(); ++cell) {
            if (tree_[cell].sign == 0) unproven.push_back(static_cast<std::uint32_t>(cell));
            level = std::max(level, static_cast<int>(tree_[cell].level));
        }
        samples_.needCorners(unproven, samplers_, workers_, stop);
        const std::size_t after = quartersOf(unproven);
        quarters_ += after;
        growth_ = std::clamp(static_cast<double>(after) / static_cast<double>(before + 1), growthOfPlane,
                             growthOfNoise);
        const std::vector<std::uint8_t> judged = judge(unproven, stop);
        leaves.clear();
        for (std::size_t i = 0; i < unproven.size(); ++i)
            if (judged[i] != 0) leaves.push_back(unproven[i]);
        if (progress) progress(level);
    }
}

CellRefinement::Shortage CellRefinement::shortageFor(std::span<const std::uint32_t> leaves) const {
    constexpr std::size_t children = 8;
    const std::size_t cells = children * leaves.size();
    if (tree_.size() + cells > limits_.cellLimit) return Shortage::cells;
    const double quarters = growth_ * static_cast<double>(quartersOf(leaves) + leaves.size());
    const bool fits = memoryWith(cells, static_cast<std::size_t>(quarters)) <= limits_.memory;
    return fits ? Shortage::none : Shortage::memory;
}

void CellRefinement::keepLimit(std::vector<std::uint32_t>& leaves) {
    if (shortageFor(leaves) == Shortage::none) return;
    limited_ = true;
    const auto coarse = [&](std::uint32_t cell) { return tree_[cell].level < limits_.coarsest; };
    // Those with some of the surface first.
    std::erase_if(leaves, [&](std::uint32_t cell) {
        const unsigned inside = samples_.cornersInside(cell);
        return !coarse(cell) && (inside == 0 || inside == allCorners);
    });
    const Shortage shortage = shortageFor(leaves);
    if (shortage == Shortage::none) return;
    if (std::ranges::any_of(leaves, coarse)) shortage_ = shortage;
    leaves.clear();
}

std::size_t CellRefinement::memoryWith(std::size_t cells, std::size_t quarters) const {
    const std::size_t polygons = (quarters_ + quarters) / 4;
    // The file is made when the polygons are gone.
    const double triangles = trianglesOfPolygon * static_cast<double>(polygons);
    const double made = triangles * static_cast<double>(bytesOfTriangle + limits_.bytesOfTriangle);
    return bytesOfCell * (tree_.size() + cells) + samples_.memoryWith(cells, polygons) +
           std::max(bytesOfPolygon * polygons, static_cast<std::size_t>(made));
}

std::size_t CellRefinement::quartersOf(std::span<const std::uint32_t> cells) const {
    std::size_t count = 0;
    for (const std::uint32_t cell : cells)
        forEachCrossedEdge(samples_.cornersInside(cell), [&](unsigned, unsigned) { ++count; });
    return count;
}

std::vector<std::uint8_t> CellRefinement::judge(std::span<const std::uint32_t> cells,
                                                const std::stop_token& stop) {
    std::vector<MinimalEdge> edges;
    for (const std::uint32_t number : cells) {
        const Cell& cell = tree_[number];
        if (cell.level < limits_.coarsest || cell.level >= limits_.finest) continue;
        const unsigned inside = samples_.cornersInside(number);
        if (hasDoubtfulFace(inside)) continue;
        forEachCrossedEdge(inside, [&](unsigned corner, unsigned axis) {
            edges.push_back(edgeOf(number, cell, corner, axis));
        });
    }
    samples_.needCrossings(edges, samplers_, workers_, stop);
    std::vector<std::uint8_t> split(cells.size(), 0);
    workers_.run((cells.size() + cellsOfBatch - 1) / cellsOfBatch, [&](std::size_t batch) {
        if (stop.stop_requested()) return;
        const std::size_t first = batch * cellsOfBatch, count = std::min(cellsOfBatch, cells.size() - first);
        const SamplerPool::Loan sampler(samplers_);
        judgeSome(cells.subspan(first, count), std::span(split).subspan(first, count), *sampler);
    });
    return split;
}

bool CellRefinement::fitsCrossings(const Cell& cell, unsigned inside, std::size_t number,
                                   std::vector<Check>& checks) const {
    if (hasDoubtfulFace(inside) || !hangsTogether(inside) || !hangsTogether(~inside & allCorners))
        return false;
    QuadricFit fit;
    forEachCrossedEdge(inside, [&](unsigned corner, unsigned axis) {
        const MinimalEdge edge = edgeOf(0, cell, corner, axis);
        const CellSamples::EdgeCrossing& crossing = samples_.crossing(edge);
        fit.add(samples_.placeOf(edge, crossing), glm::dvec3(crossing.normal));
    });
    const glm::dvec3 point = fit.solve(tree_.low(cell), tree_.high(cell));
    if (!(fit.distance(point) <= residualShare * limits_.tolerance)) return false;
    if (!(fit.leastCosine() >= leastCosine)) return false;
    const glm::dvec3 step = limits_.tolerance * fit.meanNormal();
    checks.push_back({number, point - step, point + step});
    return true;
}

void CellRefinement::judgeSome(std::span<const std::uint32_t> cells, std::span<std::uint8_t> split,
                               SolidSampler& sampler) const {
    std::vector<Check> checks;
    std::vector<std::size_t> hidden;  // without a change of sign
    for (std::size_t i = 0; i < cells.size(); ++i) {
        const Cell& cell = tree_[cells[i]];
        if (cell.level >= limits_.finest) continue;
        split[i] = 1;
        if (cell.level < limits_.coarsest) continue;
        const unsigned inside = samples_.cornersInside(cells[i]);
        if (inside != 0 && inside != allCorners)
            split[i] = fitsCrossings(cell, inside, i, checks) ? 0 : 1;
        else if (cell.level >= limits_.proven)
            hidden.push_back(i);
    }
    std::vector<glm::dvec3> points;
    for (const Check& check : checks) {
        points.push_back(check.in);
        points.push_back(check.out);
    }
    std::vector<std::uint8_t> inside(points.size());
    sampler.inside(points, inside);
    for (std::size_t k = 0; k < checks.size(); ++k)
        if (inside[2 * k] == 0 || inside[2 * k + 1] != 0) split[checks[k].number] = 1;
    points.clear();
    for (const std::size_t i : hidden)
        points.push_back(0.5 * (tree_.low(tree_[cells[i]]) + tree_.high(tree_[cells[i]])));
    std::vector<ValueAndGradient> slopes(points.size());
    sampler.gradients(points, slopes);
    for (std::size_t k = 0; k < hidden.size(); ++k) {
        const Cell& cell = tree_[cells[hidden[k]]];
        const glm::dvec3 slope(slopes[k].gradient[0], slopes[k].gradient[1], slopes[k].gradient[2]);
        double least = HUGE_VAL, left = 0;
        bool sameSign = true;
        for (unsigned number = 0; number < 8; ++number) {
            const LatticePoint corner = CellOctree::corner(cell, number);
            const double value = samples_.corner(corner).value;
            const double tangent = slopes[k].value + glm::dot(slope, tree_.place(corner) - points[k]);
            least = std::min(least, std::abs(value));
            left = std::max(left, std::abs(value - tangent));
            sameSign = sameSign && countsInside(value) == countsInside(slopes[k].value);
        }
        // Where something is undefined nothing can be told; where the container's wall alone keeps corners
        // outside, the signs of the function may differ.
        const bool wall = field_.depth(points[k]) < glm::length(tree_.high(cell) - tree_.low(cell));
        if (wall && !sameSign) sameSign = field_.depth(points[k]) < 0;
        split[hidden[k]] = sameSign && !(least < dipFactor * left) ? 0 : 1;
    }
}

}  // namespace isoscope
