// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/scene/material.h"

#include <algorithm>
#include <cmath>

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
        const MapKind kind = material.map->kind;
        const bool all = kind == MapKind::average || kind == MapKind::surface;
        std::size_t most = 0;
        for (const MappedTexture::Entry& entry : material.map->entries) {
            const std::size_t own = shownAtOnce(entry.material);
            shown = all ? shown + own : std::max(shown, most + own);
            most = std::max(most, own);
        }
        const bool single = kind == MapKind::list && keepsWholeNumbers(material.map->pattern);
        if (single || kind == MapKind::sides) shown = most;
    }
    for (const Material& layer : material.below) shown += shownAtOnce(layer);
    return shown;
}

Finish plainFinish(Finish finish) {
    finish.diffuse = std::max(0.0, finish.diffuse);
    if (finish.diffuseAlbedo) {
        finish.diffuse *= (finish.brilliance + 1) / 2;
        finish.diffuseBack *= (finish.brilliance + 1) / 2;
    }
    if (finish.phongAlbedo) finish.phong *= (finish.phongSize + 1) / 2;
    if (finish.specularAlbedo) {
        const double exponent = finish.specularExponent();
        finish.specular *= (exponent + 2) / (4 * (2 - std::exp2(-exponent / 2)));
    }
    finish.diffuseAlbedo = finish.phongAlbedo = finish.specularAlbedo = false;
    return finish;
}

Material laidOver(Material top, Material under) {
    std::vector<Material> below = std::move(under.below);
    under.below.clear();
    top.below.push_back(std::move(under));
    for (Material& layer : below) top.below.push_back(std::move(layer));
    return top;
}

Material twoSided(Material outside, Material inside) {
    auto sides = std::make_shared<MappedTexture>();
    sides->kind = MapKind::sides;
    sides->size = 1 + sizeOf(outside) + sizeOf(inside);
    sides->depth = 1 + std::max(depthOf(outside), depthOf(inside));
    Material both = outside;
    both.below.clear();
    both.mapTransform = Transform();
    sides->entries.push_back({0, std::move(outside)});
    sides->entries.push_back({1, std::move(inside)});
    both.map = std::move(sides);
    return both;
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
