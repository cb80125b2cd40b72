// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <stop_token>
#include <vector>

#include "core/shapes/isosurface/julia_algebra.h"
#include "core/shapes/rays/centered_ray.h"

namespace isoscope {

/// POV-Ray's answers for the hypercomplex Julia sets of functions other than sqr and cube, mistakes included:
/// worked out from what trace() of POV-Ray 3.7.0.10 answers, and equal to it within 1e-9 in all rows of
/// golden/rays.csv but one of 2230.
///
/// It walks along the ray from where that enters the sphere of radius 4 in steps of 1/precision and passes
/// what lies between two of them. The step that crosses the surface is halved until it is shorter than 1e-7;
/// but there, and for the normal, the iteration begins at <x, y, y, w> instead of <x, y, z, w>, w too with y
/// in place of z (not that of `reciprocal`), so that hits are often off by a whole step. The normal is the
/// part <x, y, z> of
///
///     conj(h[0] f(h[1]) f(h[2]) ... f(h[m - 1])) h[m],   m = max_iteration
///
/// which is no gradient of anything: the functions' values stand in for their slopes (`reciprocal` has f',
/// but in place of the first one h[0] too). Where the iteration escapes, earlier points' iterates remain.
class PovrayJulia {
  public:
    /// Settings with appliesTo(); the slice has unit length.
    explicit PovrayJulia(const JuliaSettings& settings);

    /// Precisions from 5000 to 20 000: with coarser ones POV-Ray's steps vary by a rule that is not known,
    /// and finer ones would take seconds for a ray.
    static bool appliesTo(const JuliaSettings& settings);

    /// Whether all points this near to a point are on the side that `inside` says: steps within such balls
    /// are not looked at. May be an estimate.
    using Keeps = std::function<bool(const glm::dvec3& point, double radius, bool inside)>;

    /// A place on the line, and what POV-Ray calls the normal there.
    struct Place {
        double s = 0;
        glm::dvec3 normal{0};
    };

    /// Begins at distance s, which lies within the sphere of radius 4; `end` is where the line leaves it.
    /// `atOrigin`: the ray itself begins there.
    void begin(const CenteredRay& line, double s, double end, bool atOrigin);
    /// The next place where the line enters or leaves the set; false when there is none before the end.
    bool next(const CenteredRay& line, const Keeps& keeps, std::stop_token stop, Place& place);

  private:
    /// Iterates the point and tells whether none of the iterates tested escapes; leaves the later ones alone.
    bool iterate(const glm::dvec3& point, bool mistaken);
    glm::dvec3 normal() const;

    const JuliaSettings& settings_;
    ComplexPair parameter_;
    bool mistaken_;                      ///< whether y stands in for z
    double longestStride_;               ///< how long steps taken at once may be together
    std::vector<ComplexPair> iterates_;  ///< of the points so far
    double s_ = 0, end_ = 0;
    double stride_ = 1;  ///< steps that may be taken at once
    bool inside_ = false;
};

}  // namespace isoscope
