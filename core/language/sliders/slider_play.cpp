// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/language/sliders/slider_play.h"

#include <algorithm>
#include <cmath>

namespace isoscope {

PlayPlace playPlace(const SliderPlay& play, double start, double elapsed) {
    if (play.mode == PlayMode::once && start >= 1) start = 0;
    const double way = std::clamp(start, 0.0, 1.0) + std::max(0.0, elapsed) / play.seconds;
    if (play.mode == PlayMode::once) return {std::min(way, 1.0), way >= 1};
    if (play.mode == PlayMode::loop) return {way - std::floor(way), false};
    const double round = way - 2 * std::floor(way / 2);
    return {round <= 1 ? round : 2 - round, false};
}

}  // namespace isoscope
