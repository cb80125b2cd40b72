// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace isoscope {

/// A picture of linear light, row by row from the top left; three floats a pixel.
struct Image {
    int width = 0;
    int height = 0;
    std::vector<std::array<float, 3>> pixels;
    /// How much of each pixel hides what is behind the picture, 0 to 1; empty: all of it. Where it is there,
    /// the colours are multiplied by it already: what a pixel adds to what shines through.
    std::vector<float> opacity;

    Image() = default;
    Image(int imageWidth, int imageHeight)
        : width(imageWidth),
          height(imageHeight),
          pixels(static_cast<std::size_t>(imageWidth) * static_cast<std::size_t>(imageHeight)) {}
};

/// 0xffRRGGBB as POV-Ray writes it into a PNG file: clipped to [0, 1], sRGB transfer function (File_Gamma
/// sRGB). NaN counts as 0.
std::uint32_t encodePixel(const std::array<float, 3>& linear);
/// The same for many pixels; `encoded` has as many.
void encodePixels(std::span<const std::array<float, 3>> linear, std::span<std::uint32_t> encoded);

/// One channel in 16 bits, by the same rules.
std::uint16_t encodeChannel16(float linear);

/// The inverse curve: linear light of an sRGB channel in [0, 1]. Values above 1 go on along the curve; NaN
/// and values below 0 count as 0.
float decodeChannel(double encoded);

}  // namespace isoscope
