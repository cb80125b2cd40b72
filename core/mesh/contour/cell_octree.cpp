// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/contour/cell_octree.h"

#include <algorithm>
#include <cmath>

#include "core/evaluate/prepared_function.h"
#include "core/roots/cells/short_tapes.h"
#include "core/render/progressive/worker_pool.h"

namespace isoscope {

namespace {

constexpr std::size_t childrenOfCell = 8;
/// Leaves that one thread splits at a time: some full runs of the evaluator.
constexpr std::size_t leavesOfBatch = 64;
/// Tapes are shortened to no more than this part of their length, or not at all.
constexpr double worthwhile = 0.8;
/// Of all tapes together, about 50 bytes each.
constexpr std::size_t mostInstructions = 1 << 21;
/// The part of the first cell that a box takes along each axis, and a ball.
constexpr double boxShare = 0.75, ballShare = 0.9;
/// The middle of a ball lies in no plane of the lattice, where symmetric functions are often 0.
const glm::dvec3 ballShift{0.0131, 0.0173, 0.0217};

}  // namespace

/// Leaves that are split together, and what is found out of their children.
struct CellOctree::Batch {
    std::span<const std::uint32_t> leaves;
    std::vector<std::int8_t> signs;                      ///< of the children
    std::vector<std::unique_ptr<SimplifiedTape>> tapes;  ///< of the children that have their own
};

CellOctree::CellOctree(const SolidField& field, double inset) : field_(field) {
    glm::dvec3 size;
    if (const auto* sphere = std::get_if<ContainerSphere>(&field.container())) {
        size = glm::dvec3(2 * sphere->radius / ballShare);
        origin_ = sphere->center - size * (0.5 + ballShift);
    } else {
        const auto& box = std::get<ContainerBox>(field.container());
        size = (box.high - box.low - 2 * inset) / boxShare;
        origin_ = box.low + inset - 0.5 * (1 - boxShare) * size;
    }
    step_ = size / static_cast<double>(1u << deepest);
    cells_.emplace_back();
    tapes_.emplace_back();
}

glm::dvec3 CellOctree::place(const LatticePoint& point) const {
    return origin_ + step_ * glm::dvec3(point.x, point.y, point.z);
}

glm::dvec3 CellOctree::high(const Cell& cell) const { return place(corner(cell, 7)); }

LatticePoint CellOctree::corner(const Cell& cell, unsigned number) {
    LatticePoint point = cell.low;
    for (unsigned axis = 0; axis < 3; ++axis)
        if ((number >> axis & 1) != 0) point[axis] += width(cell);
    return point;
}

Cell CellOctree::child(const Cell& parent, unsigned number) const {
    Cell cell;
    cell.level = static_cast<std::int8_t>(parent.level + 1);
    cell.tape = parent.tape;
    cell.low = parent.low;
    for (unsigned axis = 0; axis < 3; ++axis)
        if ((number >> axis & 1) != 0) cell.low[axis] += width(cell);
    return cell;
}

void CellOctree::split(std::span<const std::uint32_t> leaves, SamplerPool& samplers, WorkerPool& workers,
                       const std::stop_token& stop) {
    // So many at a time that what they leave to be taken is little.
    constexpr std::size_t batchesOfRun = 256;
    std::vector<Batch> batches;
    for (std::size_t first = 0; first < leaves.size();) {
        batches.clear();
        for (; first < leaves.size() && batches.size() < batchesOfRun; first += leavesOfBatch)
            batches.push_back(
                {leaves.subspan(first, std::min(leavesOfBatch, leaves.size() - first)), {}, {}});
        workers.run(batches.size(), [&](std::size_t i) { classify(batches[i], samplers, stop); });
        for (Batch& batch : batches) take(batch);
    }
}

void CellOctree::classify(Batch& batch, SamplerPool& samplers, const std::stop_token& stop) const {
    batch.signs.assign(childrenOfCell * batch.leaves.size(), 0);
    batch.tapes.resize(batch.signs.size());
    const SamplerPool::Loan sampler(samplers);
    constexpr std::size_t most = batchLanes / childrenOfCell;
    for (std::size_t first = 0; first < batch.leaves.size() && !stop.stop_requested();) {
        std::size_t end = first + 1;
        const std::uint32_t tape = cells_[batch.leaves[first]].tape;
        while (end < batch.leaves.size() && end - first < most && cells_[batch.leaves[end]].tape == tape)
            ++end;
        classifyAlike(batch, first, end, *sampler);
        first = end;
    }
}

void CellOctree::classifyAlike(Batch& batch, std::size_t first, std::size_t end,
                               SolidSampler& sampler) const {
    BoxPieces& boxes = sampler.boxes();
    const SimplifiedTape* const shorter = tape(cells_[batch.leaves[first]]);
    const SimplifiedTape& base = shorter != nullptr ? *shorter : field_.function().links().whole();
    boxes.setBase(base);
    std::array<Cell, batchLanes> children;
    const std::size_t count = childrenOfCell * (end - first);
    for (std::size_t lane = 0; lane < count; ++lane) {
        const Cell& parent = cells_[batch.leaves[first + lane / childrenOfCell]];
        children[lane] = child(parent, static_cast<unsigned>(lane % childrenOfCell));
        const glm::dvec3 half = 0.5 * sizeAt(children[lane].level);
        boxes.place(low(children[lane]) + half, half, lane);
    }
    boxes.enclose(count);
    for (std::size_t lane = 0; lane < count; ++lane) {
        const glm::dvec3 from = low(children[lane]), to = high(children[lane]);
        std::int8_t& sign = batch.signs[childrenOfCell * first + lane];
        if (boxes.isOutside(lane) || field_.misses(from, to))
            sign = 1;
        else if (boxes.sign(lane) < 0 && field_.encloses(from, to))
            sign = -1;
        if (sign != 0 || base.instructions.size() <= ShortTapes::shortLength) continue;
        auto own = std::make_unique<SimplifiedTape>();
        boxes.simplify(std::uint64_t(1) << lane, *own);
        if (static_cast<double>(own->instructions.size()) <
            worthwhile * static_cast<double>(base.instructions.size()))
            batch.tapes[childrenOfCell * first + lane] = std::move(own);
    }
}

void CellOctree::take(Batch& batch) {
    for (std::size_t i = 0; i < batch.leaves.size(); ++i) {
        const auto firstChild = static_cast<std::uint32_t>(cells_.size());
        for (std::size_t number = 0; number < childrenOfCell; ++number) {
            Cell made = child(cells_[batch.leaves[i]], static_cast<unsigned>(number));
            made.sign = batch.signs[childrenOfCell * i + number];
            std::unique_ptr<SimplifiedTape>& own = batch.tapes[childrenOfCell * i + number];
            if (own && instructions_ + own->instructions.size() <= mostInstructions) {
                instructions_ += own->instructions.size();
                made.tape = static_cast<std::uint32_t>(tapes_.size());
                tapes_.push_back(std::move(own));
            }
            cells_.push_back(made);
        }
        cells_[batch.leaves[i]].firstChild = firstChild;
    }
}

}  // namespace isoscope
