// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "core/numeric/fill_numbers.h"
#include "core/roots/first_roots.h"
#include "core/shapes/hit.h"

namespace isoscope {

/// What the rays of a RayBatch meet first, column by column. The place of a hit is where its ray is at t.
/// Keeps its memory.
class HitBatch {
  public:
    /// The columns of FirstRoots, whose tables become those of hits (takeWhole).
    using Column = FirstRoots::Column;
    static constexpr Column t = FirstRoots::t, normalX = FirstRoots::normalX, normalY = FirstRoots::normalY,
                            normalZ = FirstRoots::normalZ;
    static constexpr double never = std::numeric_limits<double>::infinity();

    /// Memory for so many rays, once and for all: to grow step by step takes twice as much.
    void reserve(std::size_t rays) {
        columns_.reserve(rays);
        if (kinds_.size() < rays) kinds_.resize(rays), materials_.resize(rays);
    }
    /// So many rays that have met nothing yet.
    void reset(std::size_t rays) {
        reserve(rays);
        columns_.setSize(rays);
        fillNumbers(columns_[t], rays, never);
        untouched_ = true;
    }
    /// Rays since reset(), met or not.
    std::size_t size() const { return columns_.size(); }

    /// Whether anything counts as met, a limit() included: t is finite.
    bool found(std::size_t i) const { return columns_[t][i] < never; }
    /// Nothing beyond counts; what comes before replaces it.
    void limit(std::size_t i, double farthest) {
        columns_[t][i] = farthest;
        untouched_ = false;
    }

    const double* operator[](Column column) const { return columns_[column]; }
    /// What ray i has met: without a meaning where there is no hit before its limit(). Shapes may leave out
    /// the normals of shadow rays.
    HitKind kind(std::size_t i) const { return kinds_[i]; }
    MaterialId material(std::size_t i) const { return materials_[i]; }
    const MaterialId* materials() const { return materials_.data(); }
    glm::dvec3 normal(std::size_t i) const {
        return {columns_[normalX][i], columns_[normalY][i], columns_[normalZ][i]};
    }

    /// Takes a hit, which must come before what is known of the ray.
    void set(std::size_t i, double place, const glm::dvec3& normal, HitKind kind, MaterialId material) {
        columns_[t][i] = place;
        untouched_ = false;
        setNormal(i, normal);
        kinds_[i] = kind;
        materials_[i] = material;
    }
    /// Changes what a ray has met and leaves its t alone.
    void setNormal(std::size_t i, const glm::dvec3& normal) {
        columns_[normalX][i] = normal.x;
        columns_[normalY][i] = normal.y;
        columns_[normalZ][i] = normal.z;
    }
    void setMaterial(std::size_t i, MaterialId material) { materials_[i] = material; }
    /// Hits without a material get this one.
    void setMaterial(MaterialId material);

    /// Takes the first of the hits, which are in order of t, where it comes before what is known.
    void offer(std::size_t i, const HitList& list) {
        if (!list.empty() && list.front().t < columns_[t][i])
            set(i, list.front().t, list.front().normal, list.front().kind, list.front().material);
    }

    /// Becomes as many rays as numbers, about which only is known how far they go: no farther than those of
    /// `all` with these numbers are known to go.
    void gatherLimits(const HitBatch& all, std::span<const std::uint32_t> numbers) {
        reset(numbers.size());
        for (std::size_t k = 0; k < numbers.size(); ++k) limit(k, all.columns_[t][numbers[k]]);
    }
    /// The way back: takes what comes before the known hits of the rays with these numbers.
    void takeNearer(const HitBatch& some, std::span<const std::uint32_t> numbers) {
        for (std::size_t k = 0; k < numbers.size(); ++k)
            if (some.columns_[t][k] < columns_[t][numbers[k]])
                set(numbers[k], some.columns_[t][k], some.normal(k), some.kind(k), some.material(k));
    }

    /// For those who write many hits at a time. The columns of numbers go on for LineColumns::padding entries
    /// behind the last ray's.
    struct Columns {
        double* t;
        std::array<double*, 3> normal;
        HitKind* kinds;
        MaterialId* materials;
    };
    /// Where to write them: valid until the next reserve(), reset() or takeWhole().
    Columns columns() {
        untouched_ = false;
        return {columns_[t],
                {columns_[normalX], columns_[normalY], columns_[normalZ]},
                kinds_.data(),
                materials_.data()};
    }

    /// Hits of one kind without a material, column by column: of the first `count` rays, infinite t where
    /// there is none. The columns go on for LineColumns::padding.
    struct Found {
        std::size_t count;
        const double* t;
        std::array<const double*, 3> normal;
    };
    /// Takes those that come before what is known of their rays.
    void take(const Found& found, HitKind kind);

    using Table = decltype(FirstRoots::crossings);
    /// The same for a table with as many rows as there are rays, all of which count, if nothing is known of
    /// any ray: the table goes where it is needed as it is, and what comes back has no meaning. Else false,
    /// and nothing is done.
    bool takeWhole(Table& found, HitKind kind);

  private:
    Table columns_;
    bool untouched_ = false;  ///< since reset()
    std::vector<HitKind> kinds_;
    std::vector<MaterialId> materials_;
};

}  // namespace isoscope
