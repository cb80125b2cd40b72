// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <limits>
#include <span>
#include <stop_token>

#include "core/roots/line_query.h"

namespace isoscope {

/// What is asked of a root finder besides the lines.
struct RootRequest {
    /// Once a root at this t or beyond is known, no further ones are looked for. 0 asks for the first root
    /// alone, infinity for as many as max_trace allows.
    double sufficient = std::numeric_limits<double>::infinity();
    /// The lines are rays of neighbouring pixels, row by row: POV-Ray's memory of the last miss applies.
    bool missMemory = false;
    /// When requested, find() returns early and the lists of unfinished lines are empty.
    std::stop_token stop;
};

/// What a root finder has seen and spent since it was made.
struct RootFinderReport {
    double maxGradient = 0;         ///< in force now (it moves with `evaluate`)
    double steepest = 0;            ///< largest finite slope met between two evaluated points
    std::uint64_t searches = 0;     ///< lines searched
    std::uint64_t evaluations = 0;  ///< point evaluations
    std::uint64_t exhausted = 0;    ///< lines given up because their budget of evaluations was spent
};

/// Looks for the places where lines meet one isosurface. The answer for a line does not depend on the other
/// lines beyond what each finder says. Not for several threads at once.
class LineRootFinder {
  public:
    virtual ~LineRootFinder() = default;

    /// Replaces roots[i] by the roots of queries[i], walls of the container included.
    virtual void find(std::span<const LineQuery> queries, const RootRequest& request,
                      std::span<RootList> roots) = 0;

    /// out[i] = a vector along the outward normal at points[i]; any length, possibly zero or not finite.
    virtual void normals(std::span<const glm::dvec3> points, std::span<glm::dvec3> out) = 0;

    /// f at one point.
    virtual double value(const glm::dvec3& point) = 0;

    virtual RootFinderReport report() const = 0;

    /// Forgets what is remembered from line to line, in finders that do so; report() goes on.
    virtual void restart() {}
};

}  // namespace isoscope
