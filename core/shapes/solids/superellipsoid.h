// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>

#include "core/shapes/shape.h"

namespace isoscope {

/// (|x|^(2/e) + |y|^(2/e))^(e/n) + |z|^(2/n) < 1 (docs/povray/primitives.md, section 10).
///
/// Along a ray, within one octant, everything in the formula grows with |x|, |y| and |z|: two values bound
/// it, and two products each partial derivative. Halving goes on until these bounds show a single crossing or
/// none, so that no edge is too sharp; after ten thousand halvings of a ray by the signs at the ends alone.
class Superellipsoid : public Shape {
  public:
    /// Both greater than 0; those below 1e-6 stand for the square shape that they come to.
    Superellipsoid(double e, double n) : e_(std::max(e, leastExponent)), n_(std::max(n, leastExponent)) {}

    /// The exponents of the formula: e shapes sections across z, n those along it; 1 is round, towards 0
    /// square.
    double e() const { return e_; }
    double n() const { return n_; }

    void intersect(const Ray& ray, RayInterval interval, TraceContext& context, HitList& hits) const override;
    bool contains(const glm::dvec3& point, TraceContext& context) const override;
    /// As large as POV-Ray's min_extent and max_extent say.
    Bounds bounds() const override { return {glm::dvec3(-1.0001), glm::dvec3(1.0001)}; }
    PrimitivePointer primitive() const override { return this; }

  private:
    struct Search;
    static constexpr double leastExponent = 1e-6;

    /// Of absolute coordinates: (x^(2/e) + y^(2/e))^(e/n).
    double section(double x, double y) const;
    /// What sizes across are measured in where their powers would be too small for doubles, else 1.
    double unitOf(const glm::dvec3& p) const;
    /// Of absolute coordinates: the formula less 1.
    double value(const glm::dvec3& p) const;
    glm::dvec3 normalAt(const glm::dvec3& point) const;
    void search(Search& search, double from, double to, double valueFrom, double valueTo, int depth) const;
    /// Whether the formula only rises or only falls between two corners of absolute coordinates.
    bool monotone(const glm::dvec3& low, const glm::dvec3& high, const glm::dvec3& speed) const;

    double e_;
    double n_;
};

}  // namespace isoscope
