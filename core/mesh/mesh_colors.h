// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <span>
#include <stop_token>
#include <vector>

#include "core/scene/scene.h"

namespace isoscope {

/// The colours of a material's pigments at points of the world, as a look straight on shows them without
/// light: layers and maps together, what shines through left out. 0xffRRGGBB in sRGB, one for each point;
/// empty where the material is none of the scene. `normals`, one for each point, point out of the solid.
std::vector<std::uint32_t> meshColors(const Scene& scene, MaterialId material,
                                      std::span<const glm::dvec3> points, std::span<const glm::dvec3> normals,
                                      int threads, const std::stop_token& stop);

}  // namespace isoscope
