// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <glm/vec4.hpp>
#include <span>
#include <vector>

#include "core/roots/polynomial/real_roots.h"
#include "core/shapes/rays/centered_ray.h"
#include "core/shapes/shape.h"

namespace isoscope {

/// The spline that carries the spheres: linear and catmullRom go through them, bSpline goes near them. The
/// latter two run from the second sphere to the last but one.
enum class SweepKind { linear, bSpline, catmullRom };

/// All spheres on the way along a spline of centers and radii (docs/povray/primitives.md, section 9).
///
/// A sphere of the sweep covers the part m - sqrt(D) to m + sqrt(D) of a ray, m and D polynomials of the
/// spline's parameter u. Between two roots of D these parts join into one, whose ends are at the roots, at
/// the ends of the spline, or where 4 m'^2 D = D'^2. So no step width and no tolerance is needed.
class SphereSweep : public Shape {
  public:
    /// Spheres are (center, radius).
    SphereSweep(SweepKind kind, std::span<const glm::dvec4> spheres);

    /// Fewer spheres than these make an empty shape.
    static int leastSpheres(SweepKind kind) { return kind == SweepKind::linear ? 2 : 4; }

    void intersect(const Ray& ray, RayInterval interval, TraceContext& context, HitList& hits) const override;
    bool contains(const glm::dvec3& point, TraceContext& context) const override;
    Bounds bounds() const override { return bounds_; }

  private:
    /// c[0] + c[1] u + ...: center and radius.
    struct Piece {
        std::array<glm::dvec4, 4> c{};
        int degree = 3;
        glm::dvec3 middle{0};  ///< of a sphere around all
        double reach = 0;

        glm::dvec4 at(double u) const { return c[0] + u * (c[1] + u * (c[2] + u * c[3])); }
    };
    /// One end of a covered part of the ray, with the sphere that makes it.
    struct End {
        double s, u;
        std::size_t piece;
    };
    struct Part {
        End enter, leave;
    };

    void addPiece(const std::array<glm::dvec4, 4>& coefficients, int degree);
    void cover(std::size_t piece, const CenteredRay& line, std::vector<Part>& parts) const;
    glm::dvec3 normalAt(const End& end, const glm::dvec3& point) const;

    std::vector<Piece> pieces_;
    glm::dvec3 center_{0};
    Bounds bounds_;
};

}  // namespace isoscope
