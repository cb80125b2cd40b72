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
enum class ImageInterpolation { none, bilinear };

/// An image as a pigment: its samples in the colours of the scene, from the top left.
struct ImageMap {
    /// Red, green, blue, filter, transmit.
    using Sample = std::array<float, 5>;

    int width = 0;
    int height = 0;
    /// Row by row, width * height of them; shared by all maps of a file.
    std::shared_ptr<const std::vector<Sample>> samples;
    ImageMapType type = ImageMapType::planar;
    ImageInterpolation interpolation = ImageInterpolation::none;
    bool once = false;  ///< clear beyond the first copy
};

/// The colour of the image at a point of its own coordinates, as POV-Ray 3.7 has it (measured): planar images
/// fill the unit square of x and y, over and over; those of the other types are wrapped about the y axis.
/// Where there is no image (`once`, or a point that is not finite) it is clear: black that transmits all.
Color imageColor(const ImageMap& image, const glm::dvec3& point);

}  // namespace isoscope
