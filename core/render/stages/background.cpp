// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/render/stages/background.h"

namespace isoscope {

Background::Background(const Scene& scene)
    : color_(scene.background.red, scene.background.green, scene.background.blue) {}

void Background::run(TileWork& work) const {
    SampleBatch& batch = work.batch;
    for (std::size_t i = 0; i < batch.size(); ++i)
        if (!batch.nearest[i].found) batch.colors[i] = color_;
    work.charge(StageKind::background);
}

}  // namespace isoscope
