// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "core/language/parse.h"

namespace isoscope {

/// A VirtuaLight text as a scene for POV-Ray 3.7: each shape as the object of POV-Ray that is the same
/// surface (the table in core/exchange/virtualight_shapes.h), declared names kept, seen by `camera`. A
/// comment stands for what cannot be written. `parsed` comes from parseVirtualight().
std::string exportVirtualight(const ParseResult& parsed, const Camera& camera);

/// The same objects without camera, lights and settings, for `#include` in a scene; "" when none is shown.
std::string virtualightObjects(const ParseResult& parsed);

}  // namespace isoscope
