// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/scene/material.h"

#include <algorithm>

namespace isoscope {

std::size_t sizeOf(const Material& material) {
    std::size_t size = material.map ? material.map->size : 1;
    for (const Material& layer : material.below) size += sizeOf(layer);
    return size;
}

int depthOf(const Material& material) {
    int depth = material.map ? material.map->depth : 1;
    for (const Material& layer : material.below) depth = std::max(depth, depthOf(layer));
    return depth;
}

std::size_t shownAtOnce(const Material& material) {
    std::size_t shown = material.map ? 0 : 1;
    if (material.map) {
        const bool all = material.map->kind == MapKind::average;
        std::size_t most = 0;
        for (const MappedTexture::Entry& entry : material.map->entries) {
            const std::size_t own = shownAtOnce(entry.material);
            shown = all ? shown + own : std::max(shown, most + own);
            most = std::max(most, own);
        }
        if (material.map->kind == MapKind::list) shown = most;
    }
    for (const Material& layer : material.below) shown += shownAtOnce(layer);
    return shown;
}

Material laidOver(Material top, Material under) {
    std::vector<Material> below = std::move(under.below);
    under.below.clear();
    top.below.push_back(std::move(under));
    for (Material& layer : below) top.below.push_back(std::move(layer));
    return top;
}

Material moved(Material material, const Transform& transform) {
    if (transform.identity()) return material;
    material.pigmentTransform = material.pigmentTransform.then(transform);
    material.normalTransform = material.normalTransform.then(transform);
    material.mapTransform = material.mapTransform.then(transform);
    for (Material& layer : material.below) layer = moved(std::move(layer), transform);
    return material;
}

}  // namespace isoscope
