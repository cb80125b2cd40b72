// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/contour/cell_samples.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>

#include "core/render/progressive/worker_pool.h"

namespace isoscope {

namespace {

constexpr std::size_t cornersOfBatch = 1024, edgesOfBatch = 256;

std::size_t batches(std::size_t count, std::size_t most) { return (count + most - 1) / most; }

}  // namespace

void CellSamples::needCorners(std::span<const std::uint32_t> cells, SamplerPool& samplers,
                              WorkerPool& workers, const std::stop_token& stop) {
    struct Wanted {
        LatticePoint point;
        const SimplifiedTape* tape;
    };
    const std::size_t known = corners_.size();
    std::vector<Wanted> wanted;
    std::vector<std::array<std::uint32_t, 8>> cornersOf(cells.size());
    for (std::size_t i = 0; i < cells.size(); ++i)
        for (unsigned number = 0; number < 8; ++number) {
            const LatticePoint point = CellOctree::corner(tree_[cells[i]], number);
            const std::size_t before = corners_.size();
            cornersOf[i][number] = corners_.add(CellOctree::key(point));
            if (corners_.size() > before) wanted.push_back({point, tree_.tape(tree_[cells[i]])});
        }
    workers.run(batches(wanted.size(), cornersOfBatch), [&](std::size_t batch) {
        if (stop.stop_requested()) return;
        const SamplerPool::Loan sampler(samplers);
        std::vector<glm::dvec3> points;
        std::vector<double> values;
        const std::size_t end = std::min(wanted.size(), (batch + 1) * cornersOfBatch);
        for (std::size_t first = batch * cornersOfBatch; first < end;) {
            points.clear();
            std::size_t behind = first;
            for (; behind < end && wanted[behind].tape == wanted[first].tape; ++behind)
                points.push_back(tree_.place(wanted[behind].point));
            values.resize(points.size());
            sampler->values(points, values, wanted[first].tape);
            for (std::size_t i = 0; i < points.size(); ++i) {
                Corner& corner = corners_[known + first + i];
                corner.value = static_cast<float>(values[i]);
                corner.inside = countsInside(values[i]) && field_.depth(points[i]) >= 0;
            }
            first = behind;
        }
    });
    cornersInside_.resize(tree_.size(), 0);
    for (std::size_t i = 0; i < cells.size(); ++i)
        for (unsigned number = 0; number < 8; ++number)
            if (corners_[cornersOf[i][number]].inside)
                cornersInside_[cells[i]] |= static_cast<std::uint8_t>(1u << number);
}

bool CellSamples::endInside(const MinimalEdge& edge, bool high) const {
    for (const std::uint32_t cell : edge.cells) {
        const Cell& leaf = tree_[cell];
        if (leaf.level == edge.level && leaf.sign == 0)
            return (cornersInside(cell) >> edge.endIn(leaf, high) & 1) != 0;
    }
    const std::uint32_t number = corners_.find(CellOctree::key(high ? edge.high() : edge.low));
    if (number != KeyTable<Corner>::none) return corners_[number].inside;
    for (const std::uint32_t cell : edge.cells)
        if (tree_[cell].level == edge.level && tree_[cell].sign != 0) return tree_[cell].sign < 0;
    return false;
}

void CellSamples::needCrossings(std::span<const MinimalEdge> edges, SamplerPool& samplers,
                                WorkerPool& workers, const std::stop_token& stop) {
    const std::size_t known = crossings_.size();
    std::vector<MinimalEdge> wanted;
    for (const MinimalEdge& edge : edges) {
        const std::size_t before = crossings_.size();
        crossings_.add(edge.key());
        if (crossings_.size() > before) wanted.push_back(edge);
    }
    workers.run(batches(wanted.size(), edgesOfBatch), [&](std::size_t batch) {
        if (stop.stop_requested()) return;
        const std::size_t first = batch * edgesOfBatch, end = std::min(wanted.size(), first + edgesOfBatch);
        std::vector<SurfaceWay> ways;
        std::vector<SurfaceCrossing> found(end - first);
        double longest = 0;
        for (std::size_t i = first; i < end; ++i) {
            const glm::dvec3 low = tree_.place(wanted[i].low), high = tree_.place(wanted[i].high());
            const bool outwards = endInside(wanted[i], false);
            ways.push_back(outwards ? SurfaceWay{low, high} : SurfaceWay{high, low});
            longest = std::max(longest, high[wanted[i].axis] - low[wanted[i].axis]);
        }
        const SamplerPool::Loan sampler(samplers);
        findCrossings(*sampler, ways, std::clamp(closeness_ / longest, 1e-9, 1e-3), found);
        for (std::size_t i = first; i < end; ++i) {
            const SurfaceCrossing& crossing = found[i - first];
            const bool outwards = endInside(wanted[i], false);
            crossings_[known + i] = {outwards ? crossing.share : 1 - crossing.share, crossing.normal,
                                     crossing.kind};
        }
    });
}

glm::dvec3 CellSamples::placeOf(const MinimalEdge& edge, const EdgeCrossing& crossing) const {
    return glm::mix(tree_.place(edge.low), tree_.place(edge.high()), crossing.share);
}

}  // namespace isoscope
