// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/render/stages/background.h"

#include <algorithm>
#include <span>

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

}  // namespace

Background::Background(const Scene& scene)
    : color_(scene.background.red, scene.background.green, scene.background.blue) {}

void Background::run(TileScratch& work, SampleBatch& batch) const {
    fill(batch.colors, color_);
    work.charge(StageKind::background);
}

}  // namespace isoscope
