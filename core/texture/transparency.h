// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/scene/material.h"

namespace isoscope {

/// Whether light may come through the pigment somewhere, by `filter` or `transmit`. True in doubt.
bool mayLetLightThrough(const Pigment& pigment);
/// The same for a whole texture: of layers all must, the lowest too.
bool mayLetLightThrough(const Material& material);
/// Whether some finish in it, layers and maps included, has reflection.
bool mayReflect(const Material& material);

}  // namespace isoscope
