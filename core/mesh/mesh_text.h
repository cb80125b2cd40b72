// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "core/mesh/isosurface_mesh.h"

namespace isoscope {

/// What is known of a mesh, a sentence a line: its size, its form, whether it is closed, how far it is from
/// the surface, and what is not proven.
std::string meshText(const MeshReport& report);

}  // namespace isoscope
