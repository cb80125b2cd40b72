// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <glm/vec3.hpp>
#include <memory>
#include <vector>

#include "core/scene/color.h"

namespace isoscope {

/// How an image is wrapped: `map_type`.
enum class ImageMapType { planar = 0, spherical = 1, cylindrical = 2, torus = 5 };
/// `interpolate`.
enum class ImageInterpolation { none, bilinear, bicubic, distance };

/// An image as a pigment: its samples in the colours of the scene, from the top left.
struct ImageMap {
    /// Red, green, blue, filter, transmit.
    using Sample = std::array<float, 5>;

    int width = 0;
    int height = 0;
    /// Row by row, width * height of them; shared by all maps of a file.
    std::shared_ptr<const std::vector<Sample>> samples;
    /// As they are in the file, 0 to 1: the greys of patterns and bumps.
    std::shared_ptr<const std::vector<Sample>> stored;
    /// Numbers of the palette, for images that have one; else null.
    std::shared_ptr<const std::vector<std::uint8_t>> indices;
    ImageMapType type = ImageMapType::planar;
    ImageInterpolation interpolation = ImageInterpolation::none;
    bool once = false;      ///< clear beyond the first copy
    bool darkened = false;  ///< the file has colours times alpha; those of the samples are divided by it
    bool hasAlpha = false;  ///< the file may say what is transparent, as POV-Ray sees it
};

/// Settings of an image add no more than that to transparency, and no less than its negative.
constexpr float transparencyLimit = 1e6F;

/// What an image of darkened colours divides a sample's by; 1 for others, and where all is transmitted.
float darkeningOf(const ImageMap& image, const ImageMap::Sample& sample);

/// The colour of the image at a point of its own coordinates, as POV-Ray 3.7 has it (measured): planar images
/// fill the unit square of x and y, over and over; those of the other types are wrapped about the y axis.
/// Where there is no image (`once`, or a point that is not finite) it is clear: white that transmits all.
Color imageColor(const ImageMap& image, const glm::dvec3& point);

/// The colour as it is stored in the file, there or so many samples to the right and below; black and opaque
/// where there is no image.
Color storedColor(const ImageMap& image, const glm::dvec3& point, int right = 0, int below = 0);

/// The number there, not interpolated: that of the palette, or the red as 0 to 255; 0 where there is none.
int imageIndex(const ImageMap& image, const glm::dvec3& point);

}  // namespace isoscope
