// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <span>

#include "core/render/effect_reasons.h"
#include "core/render/picture_parts.h"

namespace isoscope {

namespace {

/// std::fill writes number by number; copies of what is filled already go by whole vectors.
void fill(std::span<glm::dvec3> colors, const glm::dvec3& color) {
    std::size_t filled = std::min<std::size_t>(colors.size(), 32);
    std::fill_n(colors.begin(), filled, color);
    while (filled < colors.size()) {
        const std::size_t count = std::min(filled, colors.size() - filled);
        std::copy_n(colors.begin(), count, colors.begin() + static_cast<std::ptrdiff_t>(filled));
        filled += count;
    }
}

/// Colours all samples as if their rays met nothing; what they do meet paints over it (DirectLight). Sends no
/// rays.
class Background : public Stage {
  public:
    explicit Background(const Scene& scene);

    void run(TileScratch& work, SampleBatch& batch) const override;

  private:
    glm::dvec3 color_;
};

Background::Background(const Scene& scene)
    : color_(scene.background.red, scene.background.green, scene.background.blue) {}

void Background::run(TileScratch& work, SampleBatch& batch) const {
    fill(batch.colors, color_);
    work.charge(StageKind::background);
}

EffectReason reasonFor(const Scene& scene) {
    return {true, countObjects(scene, &SceneObject::visible) == 0 ? "nothing stands in front of it"
                                                                  : "rays that meet nothing show it"};
}

/// It is the same everywhere: pictures of nothing else can be filled.
void build(PictureParts& parts) { parts.stages.push_back(std::make_unique<Background>(parts.scene())); }

}  // namespace

const EffectDescription effects::background{
    .name = "background", .reasonFor = reasonFor, .build = build, .canBeLeftOut = false};

}  // namespace isoscope
