// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/shapes/shape.h"

namespace isoscope {

/// A x^2 + B y^2 + C z^2 + D xy + E xz + F yz + G x + H y + I z + J < 0 (docs/povray/primitives.md, section
/// 16).
class Quadric : public Shape {
  public:
    /// <A, B, C>, <D, E, F>, <G, H, I>, J
    Quadric(const glm::dvec3& squares, const glm::dvec3& products, const glm::dvec3& linear, double constant);

    /// The factors as given, in the constructor's groups.
    const glm::dvec3& squares() const { return squares_; }
    const glm::dvec3& products() const { return products_; }
    const glm::dvec3& linear() const { return linear_; }
    double constant() const { return constant_; }

    void intersect(const Ray& ray, RayInterval interval, TraceContext& context, HitList& hits) const override;
    bool contains(const glm::dvec3& point, TraceContext& context) const override;
    Bounds bounds() const override { return {}; }
    Bounds boundsWithin(const Bounds& room) const override;
    PrimitivePointer primitive() const override { return this; }

  private:
    double valueAt(const glm::dvec3& p) const;
    glm::dvec3 gradientAt(const glm::dvec3& p) const;

    glm::dvec3 squares_;
    glm::dvec3 products_;
    glm::dvec3 linear_;
    double constant_;
};

}  // namespace isoscope
