// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/render/stages/background.h"

#include <algorithm>

namespace isoscope {

Background::Background(const Scene& scene)
    : color_(scene.background.red, scene.background.green, scene.background.blue) {}

void Background::run(TileWork& work) const {
    std::fill(work.batch.colors.begin(), work.batch.colors.end(), color_);
    work.charge(StageKind::background);
}

}  // namespace isoscope
