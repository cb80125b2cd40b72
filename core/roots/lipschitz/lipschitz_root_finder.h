// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <memory>
#include <vector>

#include "core/roots/line_root_finder.h"
#include "core/roots/lipschitz/field_function.h"
#include "core/roots/lipschitz/lipschitz_lanes.h"
#include "core/roots/lipschitz/lipschitz_search.h"
#include "core/roots/lipschitz/miss_memory.h"

namespace isoscope {

/// POV-Ray's root finder, holes included (docs/povray/solver.md), for many lines at once: up to 64 searches
/// are under way together and each step evaluates the function once for all of them. The roots are those of
/// LipschitzSearch run for each line alone.
///
/// Two things are remembered from line to line, as POV-Ray's threads do, for the life of the finder; a
/// picture that must not depend on threads is made with a new finder, or a restarted one, for each of its
/// blocks.
///
/// With `evaluate`, the bound on the gradient. The lines are then searched one after the other.
///
/// With RootRequest::missMemory, the last interval without a root: a new one whose ends lie within e of the
/// old ones is dismissed when the smallest value seen there is above M e. With a bound M that is too small
/// most holes come from this (the unit sphere with max_gradient 0.7, 160x120: all 647). With blocks of 32x32
/// pixels, row by row, which is POV-Ray's order, 95 to 100 % of the holes agree
/// (tests/roots/miss_memory_test.cpp). POV-Ray's shadow rays clear the memory; here they leave it alone.
class LipschitzRootFinder : public LineRootFinder {
  public:
    /// `settings` are made usable() first.
    LipschitzRootFinder(std::unique_ptr<FieldFunction> field, const RootSettings& settings);

    void find(std::span<const LineQuery> queries, const RootRequest& request,
              std::span<RootList> roots) override;
    /// Forward differences with the step `accuracy`, as POV-Ray shades.
    void normals(std::span<const glm::dvec3> points, std::span<glm::dvec3> out) override;
    double value(const glm::dvec3& point) override;
    RootFinderReport report() const override;
    void restart() override;

    /// What is searched: owned by the finder and, like it, not for several threads at once.
    FieldFunction& field() { return *field_; }
    /// The settings in force, which are those given, made usable().
    const RootSettings& settings() const { return settings_; }

  private:
    bool admit(std::size_t lane);
    void evaluateLanes();
    void advance();
    std::uint64_t overdueLanes();
    void follow(std::size_t lane);
    void retire(std::size_t lane);
    void remove(std::size_t lane);
    void evaluate(std::size_t count);

    std::unique_ptr<FieldFunction> field_;
    RootSettings settings_;
    LipschitzLanes lanes_;
    MissMemory missMemory_;
    RootFinderReport report_;

    // What find() works on. Lane k works on query lineOf_[k]; lanes [0, active_) are in use.
    std::span<const LineQuery> queries_;
    std::span<RootList> roots_;
    std::vector<SearchTrail> trails_;  ///< of all lines
    bool remembers_ = false;           ///< misses are remembered
    double sufficient_ = 0;
    std::array<LipschitzSearch, LipschitzLanes::limit> searches_;
    std::array<std::size_t, LipschitzLanes::limit> lineOf_{};
    std::array<std::uint64_t, LipschitzLanes::limit> begunAt_{};  ///< number of the step
    std::size_t active_ = 0;
    std::size_t nextLine_ = 0;
    std::uint64_t step_ = 0;
    std::uint64_t nextBudgetCheck_ = 0;
    double boundBefore_ = 0;  ///< the bound when the line in work began (with `evaluate`)
    std::array<double, LipschitzLanes::limit> values_{};
};

}  // namespace isoscope
