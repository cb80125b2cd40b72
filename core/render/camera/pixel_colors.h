// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <glm/vec3.hpp>
#include <span>

#include "core/render/camera/pixel.h"
#include "core/render/image.h"
#include "core/render/sample_batch.h"

namespace isoscope {

/// The cells of a grid whose first is `corner`, as pixels.
void placePixels(std::span<const PixelIndex> cells, const PixelIndex& corner, std::span<PixelIndex> pixels);

/// The middles of pixels, as samples.
void placeInMiddles(std::span<const PixelIndex> pixels, std::span<SampleBatch::PixelPosition> places);

/// Every pixel becomes the mean of the next samples.size() / pixels.size() samples: clipped to [0, 1] (NaN
/// counts as 0), made linear by the scene's gamma, and added up in this order.
void makePixels(std::span<const glm::dvec3> samples, double gamma, std::span<LinearColor> pixels);

/// All of them become this one.
void fillPixels(const LinearColor& color, std::span<LinearColor> pixels);

/// Puts the colours of pixels that are drawn in squares of 4 x 4, whole ones (PixelOrder::squares), where
/// they belong.
void writeSquares(std::span<const PixelIndex> pixels, std::span<const LinearColor> colors, Image& image);

/// Colours of the scene, between 0 and 1, as linear light.
void makeLinear(std::span<LinearColor> colors, double gamma);

}  // namespace isoscope
