// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>

#include "core/render/image.h"
#include "core/shapes/height_field.h"

namespace isoscope {

/// Writes an 8-bit RGB PNG with sRGB chunk. False, with nothing left behind, when the file cannot be written.
bool writePng(const std::filesystem::path& file, const Image& image);

/// Writes the heights as a grey 16-bit PNG without gamma, which POV-Ray's height_field reads as they are.
/// False as above.
bool writeHeightPng(const std::filesystem::path& file, const HeightGrid& grid);

/// Reads any PNG, in 8 bits a channel and without its alpha, as linear light; an empty image when that fails.
Image readPng(const std::filesystem::path& file);

}  // namespace isoscope
