// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/render/stages/direct_light.h"

#include <algorithm>
#include <array>
#include <cstring>

#include "core/evaluate/point_evaluator.h"
#include "core/render/effect_reasons.h"
#include "core/render/light/illuminating_areas.h"
#include "core/render/light/light_arrival.h"
#include "core/render/light/surface_light.h"
#include "core/render/light/transmission.h"
#include "core/render/picture_parts.h"

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

void clear(const PointRange& range, SurfacePoints& points) {
    for (SurfacePoints::Column& column : points.returned)
        std::fill(column.begin() + static_cast<std::ptrdiff_t>(range.first),
                  column.begin() + static_cast<std::ptrdiff_t>(range.end), 0.0);
}

void findFilm(const std::shared_ptr<const Tape>& tape, const PointRange& range, SurfacePoints& points) {
    if (points.film.size() < points.point[0].size()) points.film.resize(points.point[0].size());
    const std::size_t count = range.end - range.first;
    const auto part = [&](const SurfacePoints::Column& column) {
        return std::span<const double>(column).subspan(range.first, count);
    };
    PointEvaluator(tape, {}).evaluate(part(points.point[0]), part(points.point[1]), part(points.point[2]),
                                      std::span(points.film).subspan(range.first, count));
}

/// `material` without its patterns.
Material evened(const Material& material) {
    if (!material.patterned()) return material;
    Material even;
    even.lightGroup = material.lightGroup;
    even.doubleIlluminate = material.doubleIlluminate;
    even.transparent = material.transparent && !material.pigmentTape && material.parts.empty();
    even.finish = material.finish;
    even.pigment = material.pigmentTape || !material.parts.empty() ? SolidPigment{{0.7, 0.7, 0.7}, {}}
                                                                   : std::get<SolidPigment>(material.pigment);
    return even;
}

}  // namespace

DirectLight::DirectLight(const Scene& scene, std::shared_ptr<const LightFilters> filters, const Shown& shown)
    : scene_(scene), filters_(std::move(filters)) {
    if (shown.areas)
        for (const LightSource& light : scene.lights) areas_.push_back(illuminatingLights(light));
    grouped_ = scene.lightGroups.size() > 1;
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

void DirectLight::run(TileScratch& work, SampleBatch& batch) const {
    SurfacePoints& points = batch.points;
    work.lit = &batch;
    ownLight(points);
    for (std::size_t light = 0; light < scene_.lights.size(); ++light) {
        if (light < areas_.size() && !areas_[light].empty())
            gatherArea(points, light);
        else
            gather(points, scene_.lights[light]);
        if (!filters_->empty()) work.charge(StageKind::directLight);
        filters_->filter(work, points, light);
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
        const MaterialId* const materials = points.materials.data();
        range.end = range.first + 1;
        // Eight at a time while nothing changes.
        while (range.end + 8 <= points.size() &&
               std::memcmp(materials + range.end - 1, materials + range.end, 8 * sizeof id) == 0)
            range.end += 8;
        while (range.end < points.size() && materials[range.end] == id) ++range.end;
        visit(material(id), range);
    }
}

void DirectLight::ownLight(SurfacePoints& points) const {
    const glm::dvec3 ambientLight = rgb(scene_.settings.ambientLight);
    visitMaterials(points, [&](const Material& material, const PointRange& range) {
        findSelfLight(material, opacityRule(scene_), ambientLight, range, points);
        if (material.filmTape) findFilm(material.filmTape, range, points);
    });
}

/// Shadows are those of the area as a whole, as in POV-Ray: they weaken the sum.
void DirectLight::gatherArea(SurfacePoints& points, std::size_t light) const {
    std::array<std::vector<double>, 3> sum;
    for (std::vector<double>& column : sum) column.assign(points.size(), 0);
    for (const LightSource& one : areas_[light]) {
        gather(points, one);
        for (std::size_t c = 0; c < 3; ++c)
            for (std::size_t k = 0; k < points.size(); ++k) sum[c][k] += points.returned[c][k];
    }
    findArrival(scene_.lights[light], points);
    for (std::size_t c = 0; c < 3; ++c) std::copy(sum[c].begin(), sum[c].end(), points.returned[c].begin());
}

void DirectLight::gather(SurfacePoints& points, const LightSource& light) const {
    findArrival(light, points);
    visitMaterials(points, [&](const Material& material, const PointRange& range) {
        if (grouped_ && !reaches(scene_, light, material.lightGroup)) return clear(range, points);
        findReturned(light, material, opacityRule(scene_), rgb(scene_.settings.iridWavelength), range,
                     points);
    });
}

namespace {

EffectReason reasonFor(const Scene& scene) {
    if (countObjects(scene, &SceneObject::visible) == 0) return {false, "there is nothing to light"};
    if (scene.lights.empty()) return {true, "objects shine by their ambient and emission; there is no light"};
    return {true, counted(scene.lights.size(), "light") + ", first " + placeOf(scene.lights.front())};
}

void build(PictureParts& parts) {
    const DirectLight::Shown shown{parts.textures != nullptr, parts.plan.has(StageKind::transparency),
                                   !parts.request.leftOut.has(StageKind::areaLights)};
    parts.addSurfaceStage(std::make_unique<DirectLight>(parts.scene(), parts.lightFilters, shown));
}

}  // namespace

const EffectDescription effects::directLight{
    .name = "direct light", .reasonFor = reasonFor, .build = build, .canBeLeftOut = false};

}  // namespace isoscope
