// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/render/effect_reasons.h"
#include "core/render/light/object_tracer.h"
#include "core/render/picture_parts.h"

namespace isoscope {

namespace {

/// What lies nearer than this to the surface, or to the light, casts no shadow in POV-Ray.
constexpr double shadowTolerance = 1e-3;

void gather(const SurfacePoints& points, ShadowRays& shadow) {
    shadow.clear();
    for (std::size_t k = 0; k < points.size(); ++k) {
        if (at(points.returned, k) == glm::dvec3(0)) continue;
        shadow.points.push_back(static_cast<std::uint32_t>(k));
        shadow.rays.push_back({at(points.point, k), at(points.toLight, k)});
        shadow.limits.push_back(points.distance[k] - shadowTolerance);
    }
    shadow.blocked.resize(shadow.points.size());
}

bool occludes(const SceneObject& object) { return object.castsShadow && !object.transparent; }

/// Takes away the light that another object, or the same one, keeps from a surface. Transparent objects
/// are left to ClearShadows. One ray for each sample that the light would brighten.
class Shadows : public LightFilter {
  public:
    /// The scene must outlive the stage.
    explicit Shadows(const Scene& scene);

    void filter(TileScratch& work, SurfacePoints& points, std::size_t light) const override;

  private:
    const Scene& scene_;
    ObjectTracer occluders_;
};

Shadows::Shadows(const Scene& scene) : scene_(scene), occluders_(scene, occludes) {}

void Shadows::filter(TileScratch& work, SurfacePoints& points, std::size_t light) const {
    if (scene_.lights[light].shadowless) return;
    ShadowRays& shadow = work.shadow;
    gather(points, shadow);
    if (shadow.rays.empty()) return work.charge(StageKind::shadows);
    work.meter(StageKind::shadows).rays += shadow.rays.size();
    work.context.shadowRay = true;
    work.context.nearLimit = shadowTolerance;
    occluders_.blocked(shadow.rays, shadow.limits, work.context, work.gathered, shadow.blocked);
    work.context.shadowRay = false;
    work.context.nearLimit = 0;
    for (std::size_t k = 0; k < shadow.points.size(); ++k) {
        if (!shadow.blocked[k]) continue;
        ++work.meter(StageKind::shadows).blocked;
        for (SurfacePoints::Column& column : points.returned) column[shadow.points[k]] = 0;
    }
    work.charge(StageKind::shadows);
}

EffectReason reasonFor(const Scene& scene) {
    if (countObjects(scene, &SceneObject::visible) == 0) return {false, "there is nothing to fall on"};
    if (scene.lights.empty()) return {false, "there is no light"};
    const LightSource* light = firstCastingLight(scene);
    if (!light) return {false, "every light is shadowless"};
    if (countObjects(scene, &SceneObject::castsShadow) == 0) return {false, "every object is no_shadow"};
    const std::size_t occluders = countObjects(scene, occludes);
    if (occluders == 0) return {false, "every object that casts is transparent"};
    return {true, placeOf(*light) + " casts; " + counted(occluders, "object") + " can occlude"};
}

void build(PictureParts& parts) { parts.lightFilters->shadows.add(std::make_unique<Shadows>(parts.scene())); }

}  // namespace

const EffectDescription effects::shadows{.name = "shadows", .reasonFor = reasonFor, .build = build};

}  // namespace isoscope
