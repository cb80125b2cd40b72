// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include "core/render/light/gathered_rays.h"
#include "core/scene/scene.h"
#include "core/shapes/rays/hit_batch.h"
#include "core/shapes/rays/ray_batch.h"
#include "core/shapes/rays/ray_bundle.h"

namespace isoscope {

/// Objects of a scene with their bounds: sends many rays through them, to each object only those that can
/// meet it. From `treeLimit` objects on a tree finds them; they are asked in the order of the scene all the
/// same, so that the tree changes no picture.
class ObjectTracer {
  public:
    static constexpr std::size_t treeLimit = 16;

    /// Keeps those of the scene's objects that `wanted` accepts. The scene must outlive the tracer.
    template <class Wanted>
    ObjectTracer(const Scene& scene, Wanted wanted) {
        for (const SceneObject& object : scene.objects)
            if (object.shape && wanted(object)) add(object);
        if (objects_.size() >= treeLimit) buildBvh();
    }

    /// Objects kept: those with a shape that were wanted.
    std::size_t size() const { return objects_.size(); }

    /// False only when none of the rays meets any object.
    bool mayMeet(const RayBundle& rays) const;

    /// nearest[i] becomes what ray i meets first; a hit without a material gets its object's.
    void nearest(std::span<const Ray> rays, TraceContext& context, GatheredRays& gathered,
                 std::span<NearestHit> nearest) const;

    /// The same for rays and hits in columns.
    void nearest(const RayBatch& rays, TraceContext& context, GatheredRays& gathered, HitBatch& hits) const;

    /// blocked[i] becomes 1 where anything lies strictly between `context.nearLimit` and limits[i] on ray i,
    /// else 0.
    void blocked(std::span<const Ray> rays, std::span<const double> limits, TraceContext& context,
                 GatheredRays& gathered, std::span<std::uint8_t> blocked) const;

  private:
    struct Entry {
        const SceneObject* object;
        Bounds bounds;

        bool mayMeet(const RayBundle& rays) const {
            return rays.mayMeet(bounds) && object->shape->mayBeMet(rays);
        }
    };
    void add(const SceneObject& object) {
        objects_.push_back({&object, object.shape->boundsWithin(object.shape->bounds())});
        // But for rounding: both go through the shape's transforms.
        const Bounds box = grown(grown(objects_.back().bounds)), whole = object.shape->boundsWithin({});
        boundsCut_ |= !box.contains(whole.low) || !box.contains(whole.high);
        allHaveMaterials_ &= object.material != noMaterial;
    }
    void buildBvh();
    /// Calls `ask(entry)` for every object that some of the rays may meet before what is known of them, in
    /// the order of the scene; these rays are GatheredRays::meeting.
    template <class Ask>
    void forEachMet(const RayBatch& rays, const HitBatch& known, GatheredRays& asked, Ask ask) const;

    std::vector<Entry> objects_;
    bool allHaveMaterials_ = true;
    bool boundsCut_ = false;  ///< whether a shape may be met outside of its bounds
    Bvh tree_;
};

}  // namespace isoscope
