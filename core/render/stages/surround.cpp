// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/render/stages/surround.h"

namespace isoscope {

Surround::Surround(const RenderRequest& request)
    : camera_(request.camera), width_(request.width), height_(request.height) {}

void Surround::run(TileScratch& work, SampleBatch& batch) const {
    if (!batch.fromCamera()) return;
    for (std::size_t i = 0; i < batch.size(); ++i) {
        const SampleBatch::PixelPosition& place = batch.places[i];
        const Ray ray = camera_.ray(place.x / width_ - 0.5, 0.5 - place.y / height_);
        if (ray.direction == glm::dvec3(0)) batch.colors[i] = glm::dvec3(0);
    }
    work.charge(StageKind::surround);
}

}  // namespace isoscope
