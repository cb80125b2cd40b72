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

/// What a scene says of the colours of an image.
struct ImageColors {
    double assumedGamma = 1;      ///< GlobalSettings::assumedGamma
    std::optional<double> gamma;  ///< `gamma` of the image itself
    bool trustsFile = true;       ///< what the file says counts: version 3.7, or assumed_gamma was given
    bool supposesSrgb = true;  ///< version 3.7: PNG, GIF, TGA, JPEG and BMP images that say nothing are sRGB
    /// `premultiplied`: whether the colours have been multiplied by alpha; else as the kind of file has it.
    std::optional<bool> darkened;
};

/// Reads an image, of the kinds of readRaster(), in the colours of the scene, as POV-Ray 3.7 does
/// (docs/povray/patterns.md, kinds of image files). What is not opaque transmits. Nothing, and the reason in
/// `problem`, when the file cannot be read.
std::optional<ImageMap> readImageMap(const std::filesystem::path& file, const ImageColors& colors,
                                     std::string& problem);

}  // namespace isoscope
