// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <memory>
#include <vector>

#include "core/roots/field_function.h"
#include "core/roots/line_root_finder.h"
#include "core/roots/lipschitz_search.h"
#include "core/roots/miss_memory.h"

namespace isoscope {

/// POV-Ray's root finder, holes included (spec/povray-solver.md), for many lines at once: up to 64 searches
/// are under way together and each step evaluates the function once for all of them. The roots are those of
/// LipschitzSearch run for each line alone.
///
/// Two things are remembered from line to line, as POV-Ray's threads do, for the life of the finder; a
/// picture that must not depend on threads is made with a new finder (a new TraceContext) for each of its
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

    FieldFunction& field() { return *field_; }
    const RootSettings& settings() const { return settings_; }

  private:
    static constexpr std::size_t laneLimit = 64;

    bool admit(std::size_t lane, std::span<const LineQuery> queries);
    void evaluate(std::size_t count);
    void evaluateLanes(std::span<const LineQuery> queries);
    void advance(std::span<const LineQuery> queries, std::span<RootList> roots);
    void retire(std::size_t lane, std::span<const LineQuery> queries, std::span<RootList> roots);

    std::unique_ptr<FieldFunction> field_;
    RootSettings settings_;
    GradientMemory memory_;
    MissMemory missMemory_;
    std::vector<SearchTrail> trails_;  ///< of all lines, when misses are remembered
    RootFinderReport report_;

    // Lane k works on query lineOf_[k]; lanes [0, active_) are in use.
    std::array<LipschitzSearch, laneLimit> searches_;
    std::array<std::size_t, laneLimit> lineOf_{};
    std::size_t active_ = 0;
    std::size_t nextLine_ = 0;
    double sufficient_ = 0;
    double boundBefore_ = 0;  ///< the bound when the line in work began (with `evaluate`)
    std::array<double, laneLimit> x_{}, y_{}, z_{}, values_{};
};

}  // namespace isoscope
