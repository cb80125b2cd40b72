// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/render/effect_reasons.h"
#include "core/render/picture_parts.h"

namespace isoscope {

namespace {

/// Paints black what lies around the round picture of a fisheye or omnimax camera, as POV-Ray does: no sky
/// and no background is seen there. Sends no rays.
class Surround : public Stage {
  public:
    explicit Surround(const RenderRequest& request);

    void run(TileScratch& work, SampleBatch& batch) const override;

  private:
    Camera camera_;
    double width_;
    double height_;
};

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

EffectReason reasonFor(const Scene& scene) {
    const CameraKind kind = scene.camera.kind;
    if (kind != CameraKind::fisheye && kind != CameraKind::omnimax)
        return {false, "the camera fills the picture"};
    return {true, "the picture of the camera is round"};
}

void build(PictureParts& parts) { parts.addStage(std::make_unique<Surround>(parts.request)); }

}  // namespace

const EffectDescription effects::surround{
    .name = "surround", .reasonFor = reasonFor, .build = build, .canBeLeftOut = false};

}  // namespace isoscope
