// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/render/stages/shadows.h"

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

}  // namespace

Shadows::Shadows(const Scene& scene)
    : scene_(scene),
      occluders_(scene, [](const SceneObject& object) { return object.castsShadow && !object.transparent; }) {
}

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
    for (std::size_t k = 0; k < shadow.points.size(); ++k)
        if (shadow.blocked[k])
            for (SurfacePoints::Column& column : points.returned) column[shadow.points[k]] = 0;
    work.charge(StageKind::shadows);
}

}  // namespace isoscope
