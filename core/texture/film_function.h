// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/function/function_graph.h"
#include "core/scene/material.h"

namespace isoscope {

/// How thick the film of `irid { }` is at a point of the world: thickness * (1 + turbulence * (2 Turb - 1)),
/// where Turb is the scalar turbulence of docs/povray/noise.md, section 7, with five octaves. Textures that
/// are moved do not take their film along. Measured on pictures of POV-Ray 3.7.
Function filmFunction(const Finish& finish, int noiseGenerator);

}  // namespace isoscope
