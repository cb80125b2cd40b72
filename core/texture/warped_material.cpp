// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/texture/warped_material.h"

#include "core/scene/surface_normal.h"
#include "core/texture/transform_warp.h"

namespace isoscope {

namespace {

using Warps = std::span<const PatternWarp>;

/// Places on the surface go with the object, however it has been moved.
void append(Pattern& pattern, bool onSurface, Transform& moved, Warps warps) {
    if (!onSurface && !moved.identity()) pattern.warps.emplace_back(transformWarp(moved));
    pattern.warps.insert(pattern.warps.end(), warps.begin(), warps.end());
    moved = Transform();
}

}  // namespace

std::vector<PatternWarp> allWarps(const Pattern& pattern) {
    std::vector<PatternWarp> warps;
    const bool isOwn = pattern.kind == PatternKind::marble || pattern.kind == PatternKind::wood;
    if (pattern.turbulence && !isOwn)
        warps.emplace_back(
            TurbulenceWarp{*pattern.turbulence, pattern.octaves, pattern.lambda, pattern.omega});
    warps.insert(warps.end(), pattern.warps.begin(), pattern.warps.end());
    return warps;
}

Material warped(const Material& material, Warps warps) {
    Material result = material;
    if (const auto* mapped = std::get_if<std::shared_ptr<const MappedPigment>>(&material.pigment)) {
        auto pigment = std::make_shared<MappedPigment>(**mapped);
        append(pigment->pattern, pigment->onSurface, result.pigmentTransform, warps);
        result.pigment = std::move(pigment);
    }
    if (material.normal) {
        auto normal = std::make_shared<SurfaceNormal>(*material.normal);
        append(normal->pattern, normal->onSurface, result.normalTransform, warps);
        result.normal = std::move(normal);
    }
    if (material.map) {
        auto map = std::make_shared<MappedTexture>(*material.map);
        append(map->pattern, map->onSurface, result.mapTransform, warps);
        result.map = std::move(map);
    }
    for (Material& layer : result.below) layer = warped(layer, warps);
    return result;
}

}  // namespace isoscope
