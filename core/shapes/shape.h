// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "core/shapes/bounds.h"
#include "core/shapes/hit.h"
#include "core/shapes/primitive_pointer.h"
#include "core/shapes/rays/ray.h"
#include "core/shapes/trace_context.h"

namespace isoscope {

class ConvexSolid;
class HitBatch;
class RayBatch;
class RayBundle;
class Shape;
class Transform;
struct Composition;

using ShapePointer = std::shared_ptr<const Shape>;

/// The answer to "what does this ray meet first": `hit` is meaningful where `found`.
struct NearestHit {
    bool found = false;
    Hit hit;
};

/// One of the textures of a shape, and how much of it shows.
struct TextureShare {
    std::size_t texture = 0;
    double share = 1;
};

/// A geometric object: an immutable description, shared between threads. Everything a query changes lives in
/// the caller's TraceContext.
class Shape {
  public:
    virtual ~Shape() = default;

    /// Appends every place where the ray meets the shape with t in [interval.near, interval.far], in order of
    /// t. CSG is built on these lists.
    virtual void intersect(const Ray& ray, RayInterval interval, TraceContext& context,
                           HitList& hits) const = 0;

    /// The first hit from context.nearLimit on, for each of many rays. `nearest` has one entry a ray; an
    /// entry that is already found is replaced only by a smaller t (so objects can be asked in turn). The
    /// default asks ray by ray.
    virtual void nearest(std::span<const Ray> rays, TraceContext& context,
                         std::span<NearestHit> nearest) const;

    /// The first hit of every ray of a batch: `hits`, one for each ray, are replaced by smaller t. The
    /// default asks nearest(), for shapes that do not work on columns.
    virtual void nearestInBatch(const RayBatch& rays, TraceContext& context, HitBatch& hits) const;

    /// hits[i] becomes what intersect() appends for rays[i] and t >= 0. The default asks ray by ray; shapes
    /// that search many rays together do better.
    virtual void allHits(std::span<const Ray> rays, TraceContext& context, std::span<HitList> hits) const;

    /// Whether the point lies in the solid; patches contain nothing.
    virtual bool contains(const glm::dvec3& point, TraceContext& context) const = 0;

    /// Whether the shape has neither inside nor outside: contains() is false everywhere, of its inverse, too.
    virtual bool isPatch() const { return false; }

    /// A box that holds the whole shape; infinite where the shape is.
    virtual Bounds bounds() const = 0;

    /// A box that holds what lies in `room` of the shape, of its surface and of what contains() says is
    /// inside. Smaller than bounds() where that has to be as POV-Ray's: to find out quickly that a ray
    /// misses.
    virtual Bounds boundsWithin(const Bounds& room) const { return isoscope::intersect(bounds(), room); }

    /// A box that holds what lies in `room` of the surface and of what contains() says is not inside.
    virtual Bounds complementWithin(const Bounds& room) const {
        return isPatch() ? boundsWithin(room) : room;
    }

    /// Whether bounds() cut off intersections with other shapes, whatever is inside beyond them. As measured
    /// on POV-Ray 3.7.
    virtual bool boundsCutIntersections() const { return true; }

    /// Whether the shape gains from being asked about many rays at once, by nearest() and allHits().
    virtual bool searchesBundles() const { return false; }

    /// False only when none of the rays meets the shape, although they may meet bounds(). For shapes that
    /// fill their box badly.
    virtual bool mayBeMet(const RayBundle&) const { return true; }

    /// The place on the surface, u and v of `uv_mapping`, of a point of it; nothing for shapes that POV-Ray
    /// gives no such coordinates, which take x and y of the world in their place.
    virtual std::optional<glm::dvec2> surfacePlace(const glm::dvec3&) const { return std::nullopt; }

    /// How much of each of the shape's own textures shows at a point of its surface; number 0 is that of the
    /// whole object. Shares add up to 1.
    virtual std::vector<TextureShare> textureShares(const glm::dvec3&) const { return {{0, 1}}; }

    /// The same shape for use inside of a PlacedShape with this transform, for shapes whose normals depend on
    /// it; null for all others.
    virtual ShapePointer awareOf(const Transform&) const { return nullptr; }

    /// What the shape is made of. The default is a primitive; shapes around shapes override this and
    /// withParts().
    virtual Composition composition() const;

    /// The same shape made of others, as many as composition() has; null for primitives.
    virtual ShapePointer withParts(std::vector<ShapePointer> parts, std::vector<ShapePointer> limits) const;

    /// Which primitive it is, where that matters to others.
    virtual PrimitivePointer primitive() const { return {}; }

    /// The shape for CSG by spans; null unless every line meets it in one piece.
    virtual const ConvexSolid* convexSolid() const { return nullptr; }
};

}  // namespace isoscope
