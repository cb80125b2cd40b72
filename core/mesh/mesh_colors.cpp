// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/mesh_colors.h"

#include <algorithm>
#include <memory>

#include "core/evaluate/tape/loop_stop.h"
#include "core/render/camera/pixel_colors.h"
#include "core/render/light/surface_points.h"
#include "core/render/progressive/tile_scratch.h"
#include "core/render/progressive/worker_pool.h"
#include "core/render/stages/textures.h"

namespace isoscope {

namespace {

constexpr std::size_t pointsOfBatch = 1024;

/// Points as rays would have met them that fall in straight.
SurfacePoints pointsOf(std::span<const glm::dvec3> points, std::span<const glm::dvec3> normals,
                       MaterialId material) {
    SurfacePoints places;
    places.samples.resize(points.size());
    places.materials.assign(points.size(), material);
    for (SurfacePoints::Vectors* vectors : {&places.point, &places.normal, &places.view})
        for (SurfacePoints::Column& column : *vectors) column.resize(points.size() + SurfacePoints::padding);
    for (std::size_t k = 0; k < points.size(); ++k) {
        places.samples[k] = static_cast<std::uint32_t>(k);
        for (std::size_t c = 0; c < 3; ++c) {
            const int axis = static_cast<int>(c);
            places.point[c][k] = points[k][axis];
            places.normal[c][k] = normals[k][axis];
            places.view[c][k] = -normals[k][axis];
        }
    }
    return places;
}

/// The colours in the space of the scene.
std::vector<glm::dvec3> sceneColors(const Textures& textures, const Material& material, SurfacePoints& places,
                                    TileScratch& work) {
    std::vector<glm::dvec3> colors(places.size(), glm::dvec3(0));
    if (!material.patterned()) {
        const Color& color = std::get<SolidPigment>(material.pigment).color;
        std::fill(colors.begin(), colors.end(), glm::dvec3(color.red, color.green, color.blue));
        return colors;
    }
    textures.lookUp(places, work);
    for (std::size_t k = 0; k < places.size(); ++k) {
        const glm::dvec3 pigment = at(places.pigment, k);
        if (places.weighted)
            colors[places.samples[k]] += at(places.weight, k) * pigment;
        else if (material.pigmentTape)
            colors[places.samples[k]] = pigment;
        else if (const auto* solid = std::get_if<SolidPigment>(&material.pigment))
            colors[places.samples[k]] = {solid->color.red, solid->color.green, solid->color.blue};
    }
    return colors;
}

}  // namespace

std::vector<std::uint32_t> meshColors(const Scene& scene, MaterialId material,
                                      std::span<const glm::dvec3> points, std::span<const glm::dvec3> normals,
                                      int threads, const std::stop_token& stop) {
    if (material < 0 || static_cast<std::size_t>(material) >= scene.materials.size()) return {};
    const Material& look = scene.materials[static_cast<std::size_t>(material)];
    if (!look.patterned() && !std::holds_alternative<SolidPigment>(look.pigment)) return {};
    const Textures textures(scene, false);
    std::vector<std::uint32_t> encoded(points.size(), 0xff000000);
    WorkerPool workers(threads);
    workers.run((points.size() + pointsOfBatch - 1) / pointsOfBatch, [&](std::size_t batch) {
        if (stop.stop_requested()) return;
        const LoopStop loops(stop);
        const std::size_t first = batch * pointsOfBatch,
                          count = std::min(pointsOfBatch, points.size() - first);
        const auto work = std::make_unique<TileScratch>();
        work->context = TraceContext(scene.parameterTable, RootFinder::certified);
        SurfacePoints places =
            pointsOf(points.subspan(first, count), normals.subspan(first, count), material);
        const std::vector<glm::dvec3> colors = sceneColors(textures, look, places, *work);
        std::vector<LinearColor> linear(count);
        makePixels(colors, scene.settings.assumedGamma, linear);
        encodePixels(linear, std::span(encoded).subspan(first, count));
    });
    return encoded;
}

}  // namespace isoscope
