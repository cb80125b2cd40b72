// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/scene/pigment.h"

namespace isoscope {

/// The colours that a pattern has when the scene gives none, from black to white for most. Measured on
/// POV-Ray 3.7.
std::vector<MappedPigment::Entry> ownColors(PatternKind kind);

}  // namespace isoscope
