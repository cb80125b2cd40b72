// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include "core/render/sample_batch.h"
#include "core/scene/camera.h"

namespace isoscope {

/// Makes the rays through many samples together.
class CameraRays {
  public:
    /// For a picture of this size in pixels.
    CameraRays(const Camera& camera, int width, int height)
        : camera_(camera), width_(width), height_(height) {}

    /// Appends the rays through the samples `places`, numbered from `first` on. They are those of
    /// Camera::ray, bit for bit; where a curved picture shows nothing, without a direction.
    void append(std::span<const SampleBatch::PixelPosition> places, std::size_t first, RayBatch& rays) const;
    /// Lets the rays, by their samples, go through other places of the lens than its middle.
    void spread(std::span<const glm::dvec2> lens, RayBatch& rays) const;

    /// Takes away the rays without a direction.
    void dropBlind(RayBatch& rays) const;

    /// The rectangle around samples, of which there must be at least one.
    static SampleBatch::Extent extent(std::span<const SampleBatch::PixelPosition> places);
    /// Holds the rays of all samples in the rectangle.
    RayBundle bundle(const SampleBatch::Extent& extent) const;
    RayBundle bundle(std::span<const SampleBatch::PixelPosition> places) const {
        return bundle(extent(places));
    }

  private:
    void bend(std::span<const SampleBatch::PixelPosition> places, std::size_t first, RayBatch& rays) const;
    void appendCurved(std::span<const SampleBatch::PixelPosition> places, std::size_t first,
                      RayBatch& rays) const;

    Camera camera_;
    double width_;
    double height_;
};

}  // namespace isoscope
