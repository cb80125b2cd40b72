// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/roots/polynomial/root_choice.h"
#include "core/shapes/rays/bvh.h"
#include "core/shapes/rays/centered_ray.h"
#include "core/shapes/shape.h"
#include "core/shapes/transform.h"

namespace isoscope {

/// One source of a blob's field: strength (1 - d^2 / radius^2)^2 up to the distance `radius` from a point,
/// from the line between two points, or from a plane.
struct BlobComponent {
    glm::dvec3 from{0};
    glm::dvec3 to{0};  ///< equal to `from` for a sphere
    double radius = 1;
    double strength = 1;
    Transform transform{};    ///< from the component's coordinates to the blob's
    bool plane = false;       ///< the one at right angles to `from`, which has length 1,
    double distance = 0;      ///< where `from` . p is this
    std::size_t texture = 0;  ///< as Shape::textureShares
};

/// The region where the sum of the components' fields exceeds the threshold (docs/povray/primitives.md,
/// section 2). Along a ray the field is a polynomial of degree 4 between the places where components begin
/// and end.
class Blob : public Shape {
  public:
    Blob(std::vector<BlobComponent> components, double threshold, RootChoice choice = RootChoice::isolation);

    /// As given, but with radii that are not negative; at the surface the fields add up to threshold().
    const std::vector<BlobComponent>& components() const { return components_; }
    double threshold() const { return threshold_; }

    void intersect(const Ray& ray, RayInterval interval, TraceContext& context, HitList& hits) const override;
    bool contains(const glm::dvec3& point, TraceContext& context) const override;
    Bounds bounds() const override { return bounds_; }
    /// Shares in proportion to what each component adds to the field.
    std::vector<TextureShare> textureShares(const glm::dvec3& point) const override;
    PrimitivePointer primitive() const override { return this; }

  private:
    /// Where on a ray the field of a component is strength (1 - q)^2, q = a s^2 + b s + c.
    struct Stretch {
        double from, to;
        double a, b, c;
        double strength;
    };

    void addStretches(const BlobComponent& component, const CenteredRay& line,
                      std::vector<Stretch>& stretches) const;
    double fieldAt(const glm::dvec3& point) const;
    /// What one component adds to it.
    double fieldOf(std::size_t component, const glm::dvec3& point) const;
    glm::dvec3 normalAt(const glm::dvec3& point) const;

    std::vector<BlobComponent> components_;
    std::vector<Bounds> reaches_;
    std::vector<std::size_t> planes_;  ///< components that are not in the tree, for they have no end
    std::vector<std::size_t> inTree_;
    Bvh tree_;
    double threshold_;
    RootChoice choice_;
    glm::dvec3 center_{0};
    Bounds bounds_;
};

}  // namespace isoscope
