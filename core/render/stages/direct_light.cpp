// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/render/stages/direct_light.h"

#include "core/render/light_arrival.h"
#include "core/render/surface_light.h"

namespace isoscope {

DirectLight::DirectLight(const Scene& scene, std::vector<const LightFilter*> filters)
    : scene_(scene), filters_(std::move(filters)) {}

void DirectLight::run(TileWork& work) const {
    ownLight(work);
    for (std::size_t light = 0; light < scene_.lights.size(); ++light) {
        gather(work, scene_.lights[light]);
        if (!filters_.empty()) work.charge(StageKind::directLight);
        for (const LightFilter* filter : filters_) filter->filter(work, light);
        add(work);
    }
    work.charge(StageKind::directLight);
}

const Material& DirectLight::material(const Hit& hit) const {
    const auto id = static_cast<std::size_t>(hit.material);
    return hit.material >= 0 && id < scene_.materials.size() ? scene_.materials[id] : plain_;
}

void DirectLight::ownLight(TileWork& work) const {
    SampleBatch& batch = work.batch;
    const glm::dvec3 ambientLight = rgb(scene_.settings.ambientLight);
    for (std::size_t i = 0; i < batch.size(); ++i)
        if (batch.nearest[i].found) batch.colors[i] = selfLight(material(batch.nearest[i].hit), ambientLight);
}

void DirectLight::gather(TileWork& work, const LightSource& light) const {
    SampleBatch& batch = work.batch;
    for (std::size_t i = 0; i < batch.size(); ++i) {
        batch.arriving[i] = glm::dvec3(0);
        if (!batch.nearest[i].found) continue;
        const Hit& hit = batch.nearest[i].hit;
        LightArrival& arrival = batch.arrivals[i];
        arrival = lightArrival(light, hit.point);
        if (arrival.color == glm::dvec3(0)) continue;
        batch.arriving[i] = returnedLight(material(hit), hit.normal, batch.rays[i].direction, arrival);
    }
}

void DirectLight::add(TileWork& work) const {
    SampleBatch& batch = work.batch;
    for (std::size_t i = 0; i < batch.size(); ++i) batch.colors[i] += batch.arriving[i];
}

}  // namespace isoscope
