// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <complex>
#include <glm/vec4.hpp>
#include <optional>

#include "core/shapes/shape.h"

namespace isoscope {

/// How four components are multiplied: quaternionProduct(), or as two complex numbers (ComplexPair).
enum class JuliaAlgebra { quaternion, hypercomplex };

/// What is iterated; the quaternions know the first two only.
enum class JuliaFunction {
    sqr,
    cube,
    exp,
    reciprocal,
    sin,
    asin,
    sinh,
    asinh,
    cos,
    acos,
    cosh,
    acosh,
    tan,
    atan,
    tanh,
    atanh,
    ln,
    pwr
};

/// The settings of a julia_fractal statement, with POV-Ray's defaults.
struct JuliaSettings {
    glm::dvec4 parameter{1, 0, 0, 0};
    JuliaAlgebra algebra = JuliaAlgebra::quaternion;
    JuliaFunction function = JuliaFunction::sqr;
    std::complex<double> exponent;  ///< of pwr
    int maxIteration = 20;
    double precision = 20;
    glm::dvec4 slice{0, 0, 0, 1};  ///< the last component is not 0
    double sliceDistance = 0;
};

/// A three-dimensional slice of a four-dimensional Julia set (docs/povray/primitives.md, section 5): the
/// points whose first maxIteration iterates stay within a sphere.
///
/// Rays are followed in steps that cannot pass the surface: a ball of the step's radius is carried through
/// the iteration, and the step is halved until all of the ball stays or all of it leaves. The balls are
/// bounds for `sqr` and `cube`; for the other functions they are estimates. Of the hypercomplex sets of
/// those, POV-Ray meets other points and calls other vectors their normals: where its rule is known
/// (PovrayJulia) RootFinder::lipschitz answers as it does, RootFinder::certified with the surface.
class JuliaFractal : public Shape {
  public:
    explicit JuliaFractal(const JuliaSettings& settings);

    /// As given, but the slice has unit length and the precision is 1 at least.
    const JuliaSettings& settings() const { return settings_; }

    void intersect(const Ray& ray, RayInterval interval, TraceContext& context, HitList& hits) const override;
    void nearest(std::span<const Ray> rays, TraceContext& context,
                 std::span<NearestHit> nearest) const override;
    bool contains(const glm::dvec3& point, TraceContext& context) const override;
    Bounds bounds() const override { return {glm::dvec3(-reach_), glm::dvec3(reach_)}; }

  private:
    glm::dvec4 start(const glm::dvec3& point) const;
    /// How far a point may be moved without crossing the surface, at most `most`.
    double safeStep(const glm::dvec3& point, bool inside, double most) const;
    /// Whether no point of the ball crosses the surface.
    bool ballKeeps(const glm::dvec3& point, double radius, bool inside) const;
    /// The number of the first iterate that leaves the sphere; maxIteration when none does.
    int escape(const glm::dvec3& point) const;
    glm::dvec3 normalAt(const glm::dvec3& point, int iterate) const;
    /// The normal where the surface is a cut of the function: the two points, close together, lie on both
    /// sides of it. Nothing where the function is continuous.
    std::optional<glm::dvec3> cutNormal(const glm::dvec3& inner, const glm::dvec3& outer) const;
    /// Hits in order; no more after the first when `first` is set.
    void trace(const Ray& ray, RayInterval interval, bool first, TraceContext& context, HitList& hits) const;
    void traceAsPovray(const Ray& ray, RayInterval interval, bool first, TraceContext& context,
                       HitList& hits) const;

    JuliaSettings settings_;
    double reach_;
    double stretch_;  ///< how much longer a move in four dimensions is than in three
    bool exact_;      ///< whether the balls are bounds
};

}  // namespace isoscope
