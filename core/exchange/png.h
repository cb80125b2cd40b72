// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>

#include "core/render/image.h"
#include "core/shapes/patches/height_field.h"

namespace isoscope {

/// The bytes of an 8-bit RGB PNG with sRGB chunk; none for an image without pixels. `threads` as for
/// WorkerPool: large pictures are made by several, with the same bytes for any number.
std::string encodePng(const Image& image, int threads = 1);

/// Writes that file whole or not at all (core/text/whole_file.h); false when it cannot be.
bool writePng(const std::filesystem::path& file, const Image& image);

/// The heights as a grey 16-bit PNG without gamma, which POV-Ray's height_field reads as they are.
std::string encodeHeightPng(const HeightGrid& grid);

/// Reads any PNG, in 8 bits a channel and without its alpha, as linear light; an empty image when that fails.
Image readPng(const std::filesystem::path& file);

}  // namespace isoscope
