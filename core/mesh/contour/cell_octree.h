// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <glm/vec3.hpp>
#include <memory>
#include <span>
#include <stop_token>
#include <vector>

#include "core/evaluate/tape/simplified_tape.h"
#include "core/mesh/contour/solid_field.h"

namespace isoscope {

class WorkerPool;

/// A point of the finest lattice of a CellOctree.
struct LatticePoint {
    std::uint32_t x = 0, y = 0, z = 0;

    std::uint32_t& operator[](std::size_t axis) { return axis == 0 ? x : axis == 1 ? y : z; }
    std::uint32_t operator[](std::size_t axis) const { return axis == 0 ? x : axis == 1 ? y : z; }
};

/// A box of a CellOctree.
struct Cell {
    LatticePoint low;
    std::uint32_t firstChild = 0;  ///< of eight that follow each other, x counting fastest; 0 for a leaf
    std::uint32_t tape = 0;        ///< CellOctree::tape()
    std::int8_t level = 0;
    /// The proven sign of the solid all over the cell, negative inside; 0 where neither is proven.
    std::int8_t sign = 0;

    /// Whether it is not split.
    bool leaf() const { return firstChild == 0; }
};

/// The corners of a cell together, a bit each by their numbers.
constexpr unsigned allCorners = 255;

/// Cells around the container of a solid, the first holds all of it. Where the interval enclosure of the
/// function proves a cell to lie outside of the solid or inside it needs no children; the others are split
/// as is asked for. Long functions are shortened from cell to cell by the choices that are decided in them.
/// After Duff, "Interval arithmetic and recursive subdivision for implicit functions and constructive solid
/// geometry" (1992).
class CellOctree {
  public:
    /// A cell of this level is one unit of the lattice wide.
    static constexpr int deepest = 19;

    /// The first cell alone. Planes of the lattice lie `inset` inside of the walls of a box, so that its
    /// edges and corners are cut off by no more. The container must have a volume.
    CellOctree(const SolidField& field, double inset);

    /// All cells, split ones too, by their numbers.
    std::size_t size() const { return cells_.size(); }
    const Cell& operator[](std::size_t cell) const { return cells_[cell]; }
    /// In lattice units.
    static std::uint32_t width(const Cell& cell) { return std::uint32_t(1) << (deepest - cell.level); }
    /// In the coordinates of the function.
    glm::dvec3 place(const LatticePoint& point) const;
    glm::dvec3 low(const Cell& cell) const { return place(cell.low); }
    glm::dvec3 high(const Cell& cell) const;
    /// Of cells of a level, along each axis.
    glm::dvec3 sizeAt(int level) const { return step_ * static_cast<double>(1u << (deepest - level)); }
    static LatticePoint corner(const Cell& cell, unsigned number);
    /// Different for all points of the lattice; those in the middle of edges between have keys as well, as
    /// points of a lattice twice as fine.
    static std::uint64_t key(const LatticePoint& point) {
        return twiceKey(2 * std::uint64_t(point.x), 2 * std::uint64_t(point.y), 2 * std::uint64_t(point.z));
    }
    static std::uint64_t twiceKey(std::uint64_t x, std::uint64_t y, std::uint64_t z) {
        return x | y << 21 | z << 42;
    }

    /// Splits leaves, each named once, and proves what can be proven of the new cells. The same cells for any
    /// number of threads. After a stop some children are unproven.
    void split(std::span<const std::uint32_t> leaves, SamplerPool& samplers, WorkerPool& workers,
               const std::stop_token& stop);

    /// What the function comes to in a cell; null for all of it.
    const SimplifiedTape* tape(const Cell& cell) const { return tapes_[cell.tape].get(); }

  private:
    struct Batch;
    void classify(Batch& batch, SamplerPool& samplers, const std::stop_token& stop) const;
    void classifyAlike(Batch& batch, std::size_t first, std::size_t end, SolidSampler& sampler) const;
    void take(Batch& batch);
    Cell child(const Cell& parent, unsigned number) const;

    const SolidField& field_;
    glm::dvec3 origin_{0}, step_{1};
    std::vector<Cell> cells_;
    std::vector<std::unique_ptr<SimplifiedTape>> tapes_;  ///< the first is null
    std::size_t instructions_ = 0;                        ///< of all tapes
};

}  // namespace isoscope
