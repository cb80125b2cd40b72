// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/roots/polynomial/root_choice.h"
#include "core/shapes/shape.h"

namespace isoscope {

/// The algebraic surface of `poly`, `cubic` and `quartic`: inside where a polynomial of x, y and z is
/// below a small tolerance (docs/povray/primitives.md, section 15, has the order of its terms).
class Poly : public Shape {
  public:
    static constexpr int orderLimit = 35;
    /// (n + 1)(n + 2)(n + 3) / 6
    static std::size_t termCount(int order);

    /// `coefficients` has termCount(order) entries, 1 <= order <= orderLimit.
    Poly(int order, std::vector<double> coefficients, RootChoice choice = RootChoice::isolation);

    /// The degree and the terms' factors as given, those of 0 included.
    int order() const { return order_; }
    const std::vector<double>& coefficients() const { return coefficients_; }

    void intersect(const Ray& ray, RayInterval interval, TraceContext& context, HitList& hits) const override;
    /// Whether the polynomial is less than 1e-4, POV-Ray's margin.
    bool contains(const glm::dvec3& point, TraceContext& context) const override;
    Bounds bounds() const override { return {}; }
    PrimitivePointer primitive() const override { return this; }

  private:
    struct Term {
        double coefficient;
        int x, y, z;
    };

    double valueAt(const glm::dvec3& p) const;
    glm::dvec3 gradientAt(const glm::dvec3& p) const;

    int order_;
    RootChoice choice_;
    std::vector<double> coefficients_;
    std::vector<Term> terms_;  ///< those that are not 0
};

}  // namespace isoscope
