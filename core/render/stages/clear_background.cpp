// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/render/stages/clear_background.h"

namespace isoscope {

void ClearBackground::run(TileScratch& work, SampleBatch& batch) const {
    batch.cleared.assign(batch.size(), 1);
    for (const std::uint32_t sample : batch.points.samples) batch.cleared[sample] = 0;
    for (std::uint32_t i = 0; i < batch.size(); ++i) {
        // What a mirror with an exponent bends has no weight of its own.
        if (batch.path(i).reflected || batch.target(i) >= work.batch.size()) batch.cleared[i] = 0;
        if (batch.cleared[i]) batch.colors[i] = glm::dvec3(0);
    }
    work.charge(StageKind::background);
}

void beginBackgroundSeen(TileScratch& work) { work.backgroundSeen.assign(work.batch.size(), 0); }

void noteBackgroundSeen(TileScratch& work, const SampleBatch& batch) {
    for (std::uint32_t i = 0; i < batch.cleared.size(); ++i) {
        if (!batch.cleared[i]) continue;
        glm::dvec3 share = batch.path(i).weight;
        if (!batch.through.empty()) share *= batch.through[i];
        work.backgroundSeen[batch.target(i)] += (share.x + share.y + share.z) / 3;
    }
}

}  // namespace isoscope
