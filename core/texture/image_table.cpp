// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/texture/image_table.h"

namespace isoscope {

namespace {

double gray(const Color& color) { return 0.297 * color.red + 0.589 * color.green + 0.114 * color.blue; }

}  // namespace

double ImageTable::value(const std::array<double, 3>& p) const {
    const glm::dvec3 point(p[0], p[1], p[2]);
    switch (channel_) {
        case ImageChannel::red: return imageColor(*image_, point).red;
        case ImageChannel::green: return imageColor(*image_, point).green;
        case ImageChannel::blue: return imageColor(*image_, point).blue;
        case ImageChannel::filter: return imageColor(*image_, point).filter;
        case ImageChannel::transmit: return imageColor(*image_, point).transmit;
        case ImageChannel::storedGray: return gray(storedColor(*image_, point, right_, below_));
        case ImageChannel::storedTransparency: return storedColor(*image_, point).transmit;
        case ImageChannel::index: return imageIndex(*image_, point);
    }
    return 0;
}

// Cubic interpolation overshoots by at most a quarter in each direction; settings may add to transparency
// what they like.
double ImageTable::low() const {
    const bool endless = channel_ == ImageChannel::filter || channel_ == ImageChannel::transmit;
    return endless ? -1e6 : image_->interpolation == ImageInterpolation::bicubic ? -1 : 0;
}

double ImageTable::high() const {
    const bool endless = channel_ == ImageChannel::filter || channel_ == ImageChannel::transmit;
    if (channel_ == ImageChannel::index) return 255;
    return endless ? 1e6 : image_->interpolation == ImageInterpolation::bicubic ? 2 : 1;
}

Expression imageValue(const std::shared_ptr<const ImageMap>& image, ImageChannel channel,
                      const PatternPoint& point, int right, int below) {
    CrackleSettings settings;
    settings.table = std::make_shared<const ImageTable>(image, channel, right, below);
    FunctionGraph& graph = point[0].graph();
    return {graph, graph.crackle(settings, point[0].node(), point[1].node(), point[2].node())};
}

}  // namespace isoscope
