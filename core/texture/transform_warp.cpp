// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/texture/transform_warp.h"

namespace isoscope {

TransformWarp transformWarp(const Transform& transform) {
    TransformWarp warp;
    const glm::dmat4& m = transform.backward();
    for (int row = 0; row < 4; ++row)
        for (int column = 0; column < 3; ++column)
            warp.inverse[static_cast<std::size_t>(3 * row + column)] = m[row][column];
    return warp;
}

}  // namespace isoscope
