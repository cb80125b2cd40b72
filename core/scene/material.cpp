// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/scene/material.h"

namespace isoscope {

Material moved(Material material, const Transform& transform) {
    material.pigmentTransform = material.pigmentTransform.then(transform);
    return material;
}

}  // namespace isoscope
