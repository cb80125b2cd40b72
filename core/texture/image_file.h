// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "core/texture/image_map.h"

namespace isoscope {

/// A channel that is stored by a power law, or by the sRGB curve where `storedGamma` is srgbGamma, as a
/// colour of a scene with this assumed_gamma. As in POV-Ray, what is negative stays so for 1 and srgbGamma,
/// and becomes 0 for others.
double sceneColor(double stored, double assumedGamma, double storedGamma);

/// Reads an image in the colours of a scene with this assumed_gamma (GlobalSettings::assumedGamma): stored
/// colours have this gamma, or are sRGB, as POV-Ray 3.7 takes them; what is not opaque transmits. Nothing,
/// and the reason in `problem`, when the file cannot be read. PNG, and what readRaster() knows.
std::optional<ImageMap> readImageMap(const std::filesystem::path& file, double assumedGamma,
                                     std::optional<double> fileGamma, std::string& problem);

}  // namespace isoscope
