// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <glm/vec4.hpp>
#include <span>
#include <vector>

#include "core/render/camera/pixel.h"
#include "core/render/sample_batch.h"

namespace isoscope {

/// Focal blur: every pixel is the mean of rays through many places of the pixel and of the lens. As in
/// POV-Ray a pixel gets no more of them than it needs: until the mean is known to `variance` with
/// `confidence`, at most `samples`. The places are spread evenly and differ from pixel to pixel, in a way
/// that depends on the pixel alone.
class LensSampling {
  public:
    /// Finds the colours of samples, none below 0, and how much of the background each shows; false when it
    /// was stopped.
    using Shade = std::function<bool(std::span<const SampleBatch::PixelPosition> places,
                                     std::span<const glm::dvec2> lens, std::vector<glm::dvec4>& colors)>;

    explicit LensSampling(const FocalBlur& blur) : blur_(blur) {}

    /// The colours of `pixels`, and how much of the background they show (unless that span is empty), clipped
    /// to [0, 1]. False when `shade` was stopped.
    bool draw(std::span<const PixelIndex> pixels, const Shade& shade, std::span<LinearColor> colors,
              std::span<float> background = {}) const;

  private:
    FocalBlur blur_;
};

}  // namespace isoscope
