// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <glm/vec4.hpp>
#include <span>
#include <vector>

#include "core/render/camera/antialiasing.h"
#include "core/render/camera/pixel.h"
#include "core/render/sample_batch.h"

namespace isoscope {

/// POV-Ray's two methods of anti-aliasing: more samples where colours differ, and only there. Which samples
/// were averaged with which weight was measured on POV-Ray 3.7.0.10. A pixel's colour depends on its own
/// surroundings, not on the pixels it is drawn with; jitter is at random by place.
class AdaptiveSampling {
  public:
    /// Finds the colours of samples, none below 0, and how much of the background each shows; false when it
    /// was stopped.
    using Shade = std::function<bool(std::span<const SampleBatch::PixelPosition> places,
                                     std::vector<glm::dvec4>& colors)>;

    /// For a picture of this size; `settings.method` must not be the box.
    AdaptiveSampling(const Antialiasing& settings, int width, int height);

    /// The colours of `pixels`, and how much of the background they show (unless that span is empty), clipped
    /// to [0, 1]. False when `shade` was stopped.
    bool draw(std::span<const PixelIndex> pixels, const Shade& shade, std::span<LinearColor> colors,
              std::span<float> background = {}) const;

  private:
    bool drawGrids(std::span<const PixelIndex> pixels, const Shade& shade, std::span<glm::dvec4> sums) const;
    bool drawDivided(std::span<const PixelIndex> pixels, const Shade& shade,
                     std::span<glm::dvec4> sums) const;
    bool differ(const glm::dvec4& a, const glm::dvec4& b) const;
    SampleBatch::PixelPosition moved(double x, double y, double reach) const;

    Antialiasing settings_;
    int width_;
    int height_;
};

}  // namespace isoscope
