// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/render/stages/direct_light.h"

#include <algorithm>

#include "core/render/light_arrival.h"
#include "core/render/surface_light.h"

namespace isoscope {

namespace {

/// Where textures are made of parts, several points belong to one sample.
void paintParts(SampleBatch& batch) {
    for (const std::uint32_t sample : batch.points.samples) batch.colors[sample] = glm::dvec3(0);
    for (std::size_t k = 0; k < batch.points.size(); ++k)
        batch.colors[batch.points.samples[k]] += at(batch.points.weight, k) * at(batch.points.shine, k);
}

void paint(SampleBatch& batch) {
    if (batch.points.weighted) return paintParts(batch);
    glm::dvec3* const colors = batch.colors.data();
    const std::uint32_t* const samples = batch.points.samples.data();
    const SurfacePoints::Vectors& shine = batch.points.shine;
    const double *const red = shine[0].data(), *const green = shine[1].data(), *const blue = shine[2].data();
    for (std::size_t k = 0; k < batch.points.size(); ++k) colors[samples[k]] = {red[k], green[k], blue[k]};
}

/// `material` without its patterns.
Material evened(const Material& material) {
    if (!material.patterned()) return material;
    Material even;
    even.transparent = material.transparent && !material.pigmentTape && material.parts.empty();
    even.finish = material.finish;
    even.pigment = material.pigmentTape || !material.parts.empty() ? SolidPigment{{0.7, 0.7, 0.7}, {}}
                                                                   : std::get<SolidPigment>(material.pigment);
    return even;
}

}  // namespace

DirectLight::DirectLight(const Scene& scene, std::vector<const LightFilter*> filters, const Shown& shown)
    : scene_(scene), filters_(std::move(filters)) {
    const bool asTheyAre =
        std::none_of(scene.materials.begin(), scene.materials.end(), [&](const Material& material) {
            return (material.patterned() && !shown.textures) || (material.transparent && !shown.transparency);
        });
    if (asTheyAre) return;
    for (const Material& material : scene.materials) {
        materials_.push_back(shown.textures ? material : evened(material));
        materials_.back().transparent &= shown.transparency;
    }
}

void DirectLight::run(TileWork& work, SampleBatch& batch) const {
    SurfacePoints& points = batch.points;
    work.lit = &batch;
    ownLight(points);
    for (std::size_t light = 0; light < scene_.lights.size(); ++light) {
        gather(points, scene_.lights[light]);
        if (!filters_.empty()) work.charge(StageKind::directLight);
        for (const LightFilter* filter : filters_) filter->filter(work, points, light);
        addReturned(points);
    }
    paint(batch);
    work.charge(StageKind::directLight);
}

const Material& DirectLight::material(MaterialId id) const {
    const std::vector<Material>& materials = materials_.empty() ? scene_.materials : materials_;
    const auto index = static_cast<std::size_t>(id);
    return id >= 0 && index < materials.size() ? materials[index] : plain_;
}

template <class Visit>
void DirectLight::visitMaterials(const SurfacePoints& points, Visit visit) const {
    for (PointRange range; range.first < points.size(); range.first = range.end) {
        const MaterialId id = points.materials[range.first];
        while (range.end < points.size() && points.materials[range.end] == id) ++range.end;
        visit(material(id), range);
    }
}

void DirectLight::ownLight(SurfacePoints& points) const {
    const glm::dvec3 ambientLight = rgb(scene_.settings.ambientLight);
    visitMaterials(points, [&](const Material& material, const PointRange& range) {
        findSelfLight(material, ambientLight, range, points);
    });
}

void DirectLight::gather(SurfacePoints& points, const LightSource& light) const {
    findArrival(light, points);
    visitMaterials(points, [&](const Material& material, const PointRange& range) {
        findReturned(light, material, range, points);
    });
}

}  // namespace isoscope
