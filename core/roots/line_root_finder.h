// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <limits>
#include <span>
#include <stop_token>

#include "core/roots/first_roots.h"
#include "core/roots/line_columns.h"
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

/// What a root finder has seen and spent since it was made, or restarted (LineRootFinder::restart).
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

    /// The first root with t >= request.sufficient of every line, with its normal. Nothing when a stop is
    /// requested. The default takes them from the lists of find().
    virtual void findFirst(const LineColumns& lines, const RootRequest& request, FirstRoots& roots);

    /// What is certain of the lines of the last find() or findFirst(), one by one; empty for finders that are
    /// certain of nothing.
    virtual std::span<const Verdict> verdicts() const { return {}; }

    /// out[i] = a vector along the outward normal at points[i]; any length, possibly zero or not finite.
    virtual void normals(std::span<const glm::dvec3> points, std::span<glm::dvec3> out) = 0;

    /// The same, a few points at a time, so that a stop request is seen soon: the rest of `out` stays as it
    /// is.
    void computeNormals(std::span<const glm::dvec3> points, const std::stop_token& stop,
                        std::span<glm::dvec3> out);

    /// f at one point.
    virtual double value(const glm::dvec3& point) = 0;

    /// Sums over all calls so far, findFirst() included; not while another call is under way.
    virtual RootFinderReport report() const = 0;

    /// Forgets what is remembered from line to line, if anything. What report() counts begins anew in
    /// LipschitzRootFinder and goes on in all others.
    virtual void restart() {}

  protected:
    /// Computes the normals of roots.others, but for walls, jumps and those that are known.
    void setNormals(const LineColumns& lines, const std::stop_token& stop, FirstRoots& roots);

  private:
    std::vector<LineQuery> queries_;
    std::vector<RootList> lists_;  ///< as many as were ever needed, for they keep what they have allocated
    std::vector<glm::dvec3> places_, normals_;
};

}  // namespace isoscope
