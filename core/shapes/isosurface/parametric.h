// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <memory>

#include "core/evaluate/tape/tape.h"
#include "core/shapes/isosurface/isosurface.h"
#include "core/shapes/shape.h"

namespace isoscope {

/// What a `parametric` statement says.
struct ParametricSettings {
    std::array<Function, 3> functions;  ///< x, y and z; their first two arguments are u and v
    glm::dvec2 low{0};                  ///< of u and v
    glm::dvec2 high{1};
    Container container = ContainerBox{};  ///< nothing is seen outside of it, walls included
    double accuracy = 0.001;               ///< POV-Ray's; the surface itself needs neither
    double maxGradient = 1;
};

/// The surface (x(u, v), y(u, v), z(u, v)) over a rectangle: a patch without an inside.
///
/// Certified subdivision: two planes through the ray make two equations for u and v. A rectangle is given up
/// where enclosures of the functions and of their derivatives prove that one of them, or both together, have
/// no solution; where the derivatives prove that there is one at most, Newton's method finds it; all others
/// are halved. POV-Ray's `accuracy`, `max_gradient` and `precompute` are not needed, but for its own answers
/// (PovrayParametric): nearest() gives those to RootFinder::lipschitz. Where no bounds exist
/// (jumps, poles) the surface is left out closer than `narrowest` of the rectangle.
class Parametric : public Shape {
  public:
    /// All functions are valid and have one result.
    explicit Parametric(ParametricSettings settings);

    /// As given, but with low <= high for u and for v.
    const ParametricSettings& settings() const { return settings_; }

    void intersect(const Ray& ray, RayInterval interval, TraceContext& context, HitList& hits) const override;
    void nearest(std::span<const Ray> rays, TraceContext& context,
                 std::span<NearestHit> nearest) const override;
    bool contains(const glm::dvec3&, TraceContext&) const override { return false; }
    bool isPatch() const override { return true; }
    /// The box around the container.
    Bounds bounds() const override { return bounds_; }

    /// Rectangles looked at for one ray before the search ends with what it has found.
    static constexpr int cellLimit = 50'000;
    static constexpr double narrowest = 1e-9;

  private:
    class Search;
    class State;

    State& stateOf(TraceContext& context) const;
    RayInterval containerPart(const Ray& ray) const;
    bool containerHolds(const glm::dvec3& point) const;
    void trace(const Ray& ray, RayInterval interval, bool first, TraceContext& context, HitList& hits) const;
    /// False when POV-Ray's way finds nothing, as it does where max_gradient is too small, or is too long.
    bool traceAsPovray(const Ray& ray, RayInterval interval, TraceContext& context, HitList& hits) const;

    ParametricSettings settings_;
    Bounds bounds_;
    std::array<std::shared_ptr<const Tape>, 3> tapes_;
};

}  // namespace isoscope
