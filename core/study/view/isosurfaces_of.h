// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <vector>

#include "core/shapes/isosurface/isosurface.h"

namespace isoscope {

/// The isosurfaces that a shape is made of, in order; each once.
std::vector<std::shared_ptr<const Isosurface>> isosurfacesOf(const ShapePointer& shape);

}  // namespace isoscope
