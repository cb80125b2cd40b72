// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <span>
#include <vector>

#include "core/evaluate/point_evaluator.h"
#include "core/roots/line_query.h"
#include "core/roots/root_settings.h"

namespace isoscope {

/// A crossing between low and high, where the function has certain, opposite signs.
struct RoughRoot {
    std::size_t line;  ///< of the queries
    std::size_t root;  ///< of the line's list: what is to be moved
    double low, high;
    double steepness, leftover;  ///< as in BracketedRoot

    /// Whether t lies in the interval; false for NaN.
    bool holds(double t) const { return low <= t && t <= high; }
};

/// Moves roots from somewhere in their interval to where the function is 0, by point values: for smooth
/// functions a step of Newton's with the slope of the enclosure, and secants where they are bent, which
/// leaves about a ten-thousandth of the interval; a kink may leave more, but roots never leave their
/// interval. What does not settle by that is narrowed by false position. Roots at which the function jumps
/// become jumps.
class RootPolish {
  public:
    /// The references must outlive the polish.
    RootPolish(PointEvaluator& points, const RootSettings& settings) : points_(points), settings_(settings) {}

    /// Changes t and kind of roots[r.line][r.root] for each entry r of `rough`, and of no other root; r.line
    /// counts `queries`. By `simplifiedTape`, if there is one, which has to hold in the intervals.
    void run(std::span<const RoughRoot> rough, std::span<const LineQuery> queries, std::span<RootList> roots,
             const SimplifiedTape* simplifiedTape = nullptr);

  private:
    using Lanes = std::array<double, batchLanes>;
    struct Bracket;

    /// A root that is being approached: two places and the value at the first of them.
    struct Approach {
        RoughRoot rough;
        double before, valueBefore;
        double t;
    };

    void evaluate(std::size_t count, const Lanes& t, Lanes& values);
    void load(std::size_t lane, const RoughRoot& rough, std::span<const LineQuery> queries);
    void polishSmooth(std::span<const RoughRoot> group, std::span<const LineQuery> queries,
                      std::span<RootList> roots);
    void secant(std::span<const LineQuery> queries, std::span<RootList> roots);
    void narrow(std::span<const RoughRoot> group, std::span<const LineQuery> queries,
                std::span<RootList> roots);
    void settle(Bracket& bracket, const RoughRoot& rough, std::span<const LineQuery> queries,
                std::span<RootList> roots);

    PointEvaluator& points_;
    const RootSettings& settings_;
    const SimplifiedTape* simplifiedTape_ = nullptr;
    std::array<Lanes, 3> origin_{}, direction_{}, place_{};  ///< of the group at hand
    std::vector<Approach> bent_;
    std::vector<RoughRoot> unsettled_;
};

}  // namespace isoscope
