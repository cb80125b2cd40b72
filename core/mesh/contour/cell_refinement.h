// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <stop_token>
#include <vector>

#include "core/mesh/contour/cell_octree.h"
#include "core/mesh/contour/cell_samples.h"

namespace isoscope {

/// How finely a surface is looked at.
struct RefinementLimits {
    double tolerance = 0.01;  ///< cells are split until one plane, edge or corner in each fits as well
    int coarsest = 5;         ///< leaves with some of the surface have at least this level
    int proven = 6;   ///< up to this level only proofs keep cells without a change of sign from being split
    int finest = 19;  ///< no cell is split beyond
    std::size_t cellLimit = 3'000'000;
    std::size_t memory = 800'000'000;  ///< bytes, as CellRefinement::memory() counts them
    std::size_t bytesOfTriangle = 0;   ///< of what is made of the mesh
};

/// Splits the cells of an octree until each leaf has at most one simple piece of the surface in it that its
/// tangent planes describe, or is as small as is allowed.
class CellRefinement {
  public:
    /// Of a limit.
    enum class Shortage { none, cells, memory };

    /// The references must outlive it.
    CellRefinement(const SolidField& field, CellOctree& tree, CellSamples& samples,
                   const RefinementLimits& limits, SamplerPool& samplers, WorkerPool& workers)
        : field_(field),
          tree_(tree),
          samples_(samples),
          limits_(limits),
          samplers_(samplers),
          workers_(workers) {}

    /// Splits these leaves, and those of their parts that need it. `progress` (which may be empty) is told
    /// the level that is reached. A stop ends it soon, with a tree that is whole, but coarse.
    void split(std::vector<std::uint32_t> leaves, const std::function<void(int)>& progress,
               const std::stop_token& stop);

    /// Whether cells were left as they were for the sake of a limit.
    bool limited() const { return limited_; }
    /// What did not suffice for even the coarsest leaves that may hold some of the surface: a mesh of what
    /// there is would say nothing.
    Shortage shortage() const { return shortage_; }
    /// The bytes that the tree takes, with its samples and with the mesh that is made of it, about. It seldom
    /// exceeds the limit: what is to be split is taken to get as much more surface as what was split before.
    std::size_t memory() const { return memoryWith(0, 0); }

  private:
    struct Check;
    std::vector<std::uint8_t> judge(std::span<const std::uint32_t> cells, const std::stop_token& stop);
    void judgeSome(std::span<const std::uint32_t> cells, std::span<std::uint8_t> split,
                   SolidSampler& sampler) const;
    bool fitsCrossings(const Cell& cell, unsigned inside, std::size_t number,
                       std::vector<Check>& checks) const;
    void keepLimit(std::vector<std::uint32_t>& leaves);
    Shortage shortageFor(std::span<const std::uint32_t> leaves) const;
    std::size_t memoryWith(std::size_t cells, std::size_t quarters) const;
    std::size_t quartersOf(std::span<const std::uint32_t> cells) const;

    const SolidField& field_;
    CellOctree& tree_;
    CellSamples& samples_;
    RefinementLimits limits_;
    SamplerPool& samplers_;
    WorkerPool& workers_;
    /// Pairs of a leaf and an edge of it with one end inside: about four for each polygon of the surface.
    std::size_t quarters_ = 0;
    double growth_ = 8;  ///< of their number in what was split last
    bool limited_ = false;
    Shortage shortage_ = Shortage::none;
};

}  // namespace isoscope
