// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string_view>

namespace isoscope {

/// Nanoseconds that a call of an elementary function, or of one of functions.inc, takes POV-Ray, with the
/// parameters' defaults, on the machine that the figures of povray_time.h stand for: the mean of two timings,
/// right to some ten nanoseconds. Nothing for functions whose time depends on a parameter (octaves, tubes) or
/// much on the place (noise), and for names of no such function. tools/povray-time --calls times anew, by how
/// much longer `x + 0.001*f(x, y, z, ...)` takes than `x + 0.001*y`.
std::optional<double> povrayCallTime(std::string_view function);

}  // namespace isoscope
