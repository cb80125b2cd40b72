// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <mutex>
#include <optional>

#include "core/function/patterns/pattern_warp.h"
#include "core/function/point_table.h"
#include "core/texture/image_map.h"
#include "core/texture/tables/sample_bounds.h"

namespace isoscope {

/// What of an image is looked up.
enum class ImageChannel {
    red,
    green,
    blue,
    filter,
    transmit,            ///< these as imageColor()
    storedGray,          ///< of bumps
    patternGray,         ///< the same of patterns, no less than 0 and no more than 1
    storedTransparency,  ///< 0 where the file is opaque
    storedRed,           ///< as it is in the file
    index                ///< imageIndex()
};

/// One channel of an image at u and v, the first two coordinates, for functions: where the image is not
/// `once`, over and over.
class ImageTable : public PointTable {
  public:
    /// Stored greys are those so many samples to the right and below.
    ImageTable(const ImageMap& image, ImageChannel channel, int right = 0, int below = 0);
    ImageTable(const ImageTable&) = delete;
    ImageTable& operator=(const ImageTable&) = delete;

    double value(const std::array<double, 3>& point) const override;
    double low() const override;
    double high() const override;
    /// Not of images that are interpolated by distance.
    bool hasRanges() const override;
    Straightness straightness(const std::array<Interval, 3>& box, const std::array<double, 3>& slope,
                              const std::array<double, 3>& errors) const override;

  private:
    Interval rangeIn(const std::array<Interval, 3>& box) const override;
    double joined(double u, double v) const;
    double sample(int column, int row) const;
    double channelOf(const Color& color) const;
    bool isEndless() const;
    bool isGray() const {
        return channel_ == ImageChannel::storedGray || channel_ == ImageChannel::patternGray;
    }
    bool isCutOff() const {
        return channel_ == ImageChannel::patternGray && image_.interpolation == ImageInterpolation::bicubic;
    }
    std::array<Interval, 3> gridOf(const Interval& u, const Interval& v) const;
    const SampleBounds& bounds() const;
    void makeBounds() const;

    ImageMap image_;  ///< planar
    ImageChannel channel_;
    int right_, below_;
    mutable std::once_flag bounded_;
    mutable std::optional<SampleBounds> bounds_;  ///< made when they are asked for
};

/// A channel of an image as an operation, on the place of a point on images of its type.
Expression imageValue(const std::shared_ptr<const ImageMap>& image, ImageChannel channel,
                      const PatternPoint& point, int right = 0, int below = 0);

}  // namespace isoscope
