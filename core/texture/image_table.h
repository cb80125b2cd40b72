// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>

#include "core/function/patterns/pattern_warp.h"
#include "core/function/point_table.h"
#include "core/texture/image_map.h"

namespace isoscope {

/// What of an image is looked up.
enum class ImageChannel {
    red,
    green,
    blue,
    filter,
    transmit,            ///< these as imageColor()
    storedGray,          ///< of patterns and bumps
    storedTransparency,  ///< 0 where the file is opaque
    index                ///< imageIndex()
};

/// One channel of an image at points of its own coordinates, for functions.
class ImageTable : public PointTable {
  public:
    /// Stored greys are those so many samples to the right and below.
    ImageTable(std::shared_ptr<const ImageMap> image, ImageChannel channel, int right = 0, int below = 0)
        : image_(std::move(image)), channel_(channel), right_(right), below_(below) {}

    double value(const std::array<double, 3>& point) const override;
    double low() const override;
    double high() const override;

  private:
    std::shared_ptr<const ImageMap> image_;
    ImageChannel channel_;
    int right_, below_;
};

/// A channel of an image as an operation.
Expression imageValue(const std::shared_ptr<const ImageMap>& image, ImageChannel channel,
                      const PatternPoint& point, int right = 0, int below = 0);

}  // namespace isoscope
