// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/texture/surface_needs.h"

#include <algorithm>

namespace isoscope {

namespace {

const MappedPigment* mappedOf(const Pigment& pigment) {
    const auto* mapped = std::get_if<std::shared_ptr<const MappedPigment>>(&pigment);
    return mapped ? mapped->get() : nullptr;
}

}  // namespace

bool needsSurface(const Pattern& pattern) {
    return pattern.kind == PatternKind::slope || pattern.kind == PatternKind::aoi;
}

bool needsSurface(const Pigment& pigment) {
    const MappedPigment* mapped = mappedOf(pigment);
    return mapped &&
           (mapped->onSurface || needsSurface(mapped->pattern) ||
            std::any_of(mapped->entries.begin(), mapped->entries.end(),
                        [](const MappedPigment::Entry& entry) { return needsSurface(entry.pigment); }));
}

bool needsSurface(const SurfaceNormal& normal) {
    return normal.onSurface || needsSurface(normal.pattern) ||
           std::any_of(normal.entries.begin(), normal.entries.end(), [](const SurfaceNormal::Entry& entry) {
               return entry.normal && needsSurface(*entry.normal);
           });
}

Pigment withoutSlopes(Pigment pigment) {
    const MappedPigment* mapped = mappedOf(pigment);
    if (!mapped || !needsSurface(pigment)) return pigment;
    auto copy = std::make_shared<MappedPigment>(*mapped);
    if (needsSurface(copy->pattern)) {
        // Of a function that is none, which is 0.
        copy->pattern.kind = PatternKind::function;
        copy->pattern.function = {};
    }
    for (MappedPigment::Entry& entry : copy->entries) entry.pigment = withoutSlopes(std::move(entry.pigment));
    return copy;
}

bool onSurface(const Pigment& pigment) {
    const MappedPigment* mapped = mappedOf(pigment);
    return mapped && (mapped->onSurface || std::any_of(mapped->entries.begin(), mapped->entries.end(),
                                                       [](const MappedPigment::Entry& entry) {
                                                           return onSurface(entry.pigment);
                                                       }));
}

bool onSurface(const SurfaceNormal& normal) {
    return normal.onSurface ||
           std::any_of(normal.entries.begin(), normal.entries.end(), [](const SurfaceNormal::Entry& entry) {
               return entry.normal && onSurface(*entry.normal);
           });
}

bool onSurface(const Material& material) {
    if (std::any_of(material.below.begin(), material.below.end(),
                    [](const Material& layer) { return onSurface(layer); }))
        return true;
    if (!material.map) return onSurface(material.pigment) || (material.normal && onSurface(*material.normal));
    return material.map->onSurface ||
           std::any_of(material.map->entries.begin(), material.map->entries.end(),
                       [](const MappedTexture::Entry& entry) { return onSurface(entry.material); });
}

Material laidOnSurface(Material material) {
    if (const MappedPigment* mapped = mappedOf(material.pigment); mapped && !mapped->onSurface) {
        auto copy = std::make_shared<MappedPigment>(*mapped);
        copy->onSurface = true;
        material.pigment = std::move(copy);
    }
    if (material.normal && !material.normal->onSurface) {
        auto copy = std::make_shared<SurfaceNormal>(*material.normal);
        copy->onSurface = true;
        material.normal = std::move(copy);
    }
    if (material.map) {
        auto copy = std::make_shared<MappedTexture>(*material.map);
        copy->onSurface = true;
        for (MappedTexture::Entry& entry : copy->entries)
            entry.material = laidOnSurface(std::move(entry.material));
        material.map = std::move(copy);
    }
    for (Material& layer : material.below) layer = laidOnSurface(std::move(layer));
    return material;
}

}  // namespace isoscope
