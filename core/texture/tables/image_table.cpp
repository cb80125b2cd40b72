// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/texture/tables/image_table.h"

#include <algorithm>
#include <cmath>

#include "core/image/brightness.h"
#include "core/texture/image_place.h"

namespace isoscope {

namespace {

/// More than transparencyLimit, and than a colour over the smallest alpha of single precision.
constexpr double endless = 1e9;

double gray(const Color& color) { return brightness(color.red, color.green, color.blue); }

}  // namespace

ImageTable::ImageTable(const ImageMap& image, ImageChannel channel, int right, int below)
    : image_(image), channel_(channel), right_(right), below_(below) {
    image_.type = ImageMapType::planar;
}

double ImageTable::value(const std::array<double, 3>& p) const {
    const double value = joined(p[0], p[1]);
    return isCutOff() ? std::clamp(value, 0.0, 1.0) : value;
}

/// Before anything is cut off.
double ImageTable::joined(double u, double v) const {
    const glm::dvec3 point(u, v, 0);
    switch (channel_) {
        case ImageChannel::storedGray:
        case ImageChannel::patternGray: return channelOf(storedColor(image_, point, right_, below_));
        case ImageChannel::storedTransparency:
        case ImageChannel::storedRed: return channelOf(storedColor(image_, point));
        case ImageChannel::index: return imageIndex(image_, point);
        default: return channelOf(imageColor(image_, point));
    }
}

double ImageTable::channelOf(const Color& color) const {
    switch (channel_) {
        case ImageChannel::red:
        case ImageChannel::storedRed: return color.red;
        case ImageChannel::green: return color.green;
        case ImageChannel::blue: return color.blue;
        case ImageChannel::filter: return color.filter;
        case ImageChannel::transmit:
        case ImageChannel::storedTransparency: return color.transmit;
        case ImageChannel::storedGray:
        case ImageChannel::patternGray: return gray(color);
        case ImageChannel::index: break;
    }
    return 0;
}

bool ImageTable::hasRanges() const {
    return channel_ == ImageChannel::index || image_.interpolation != ImageInterpolation::distance;
}

/// What is stored there, from the left and from above.
double ImageTable::sample(int column, int row) const {
    const auto number = static_cast<std::size_t>(row) * static_cast<std::size_t>(image_.width) +
                        static_cast<std::size_t>(column);
    if (channel_ == ImageChannel::index && image_.indices) return (*image_.indices)[number];
    const bool isStored = isGray() || channel_ == ImageChannel::storedTransparency ||
                          channel_ == ImageChannel::storedRed || channel_ == ImageChannel::index;
    const auto& samples = isStored ? image_.stored : image_.samples;
    if (!samples) return value({NAN, NAN, 0});
    const auto& [red, green, blue, filter, transmit] = (*samples)[number];
    if (channel_ == ImageChannel::index) return static_cast<double>(std::lround(255 * red));
    return channelOf({red, green, blue, filter, transmit});
}

void ImageTable::makeBounds() const {
    const int width = image_.width, height = image_.height;
    const bool wraps = !image_.once;
    const std::array<SampleAxis, 3> axes{
        {{width, 0.5, wraps, wraps}, {height, 0.5, wraps, wraps}, {1, 0, false, false}}};
    const bool bicubic = image_.interpolation == ImageInterpolation::bicubic;
    const SampleJoin join =
        channel_ == ImageChannel::index || image_.interpolation == ImageInterpolation::none ? SampleJoin::none
        : bicubic ? SampleJoin::cubic
                  : SampleJoin::linear;
    bounds_.emplace(axes, join,
                    [this](const std::array<int, 3>& place) { return sample(place[0], place[1]); });
}

const SampleBounds& ImageTable::bounds() const {
    std::call_once(bounded_, [this] { makeBounds(); });
    return *bounds_;
}

/// Coordinates of the samples, from the left and from above.
std::array<Interval, 3> ImageTable::gridOf(const Interval& u, const Interval& v) const {
    const Interval width = Interval::point(image_.width), height = Interval::point(image_.height);
    return {u * width + Interval::point(isGray() ? right_ : 0),
            (Interval::point(1) - v) * height + Interval::point(isGray() ? below_ : 0), Interval::point(0)};
}

PointTable::Straightness ImageTable::straightness(const std::array<Interval, 3>& box,
                                                  const std::array<double, 3>& slope,
                                                  const std::array<double, 3>& errors) const {
    if (image_.width <= 0 || image_.height <= 0 || !hasRanges()) return {};
    if (image_.once)
        for (std::size_t k = 0; k < 2; ++k)
            if (!(box[k].low >= 0 && box[k].high < 1)) return {};
    // Where values are cut off there is an edge.
    if (isCutOff()) {
        const Interval range = rangeIn(box);
        if (!(range.low > 0 && range.high < 1)) return {};
    }
    const double width = image_.width, height = image_.height;
    return bounds().straightness(gridOf(box[0], box[1]), {slope[0] * width, slope[1] * height, 0},
                                 {errors[0] * width, errors[1] * height, 0});
}

Interval ImageTable::rangeIn(const std::array<Interval, 3>& box) const {
    // Weights by distance are steeper than lines.
    if (image_.width <= 0 || image_.height <= 0 || !hasRanges()) return {low(), high(), false};
    Interval u = box[0], v = box[1];
    bool isWithin = true;
    if (image_.once)
        for (Interval* side : {&u, &v}) {
            if (!(side->high >= 0 && side->low < 1)) return Interval::point(value({NAN, NAN, 0}));
            isWithin = isWithin && side->low >= 0 && side->high < 1;
            *side = {std::max(side->low, 0.0), std::min(side->high, std::nextafter(1, 0)), false};
        }
    const auto middleOf = [](const Interval& side) { return side.low + (side.high - side.low) / 2; };
    const double middle = joined(middleOf(u), middleOf(v));
    Interval inside = bounds().over(gridOf(u, v), middle);
    if (isCutOff()) inside = {std::clamp(inside.low, 0.0, 1.0), std::clamp(inside.high, 0.0, 1.0), false};
    return isWithin ? inside : hull(inside, Interval::point(value({NAN, NAN, 0})));
}

/// Whether values may be far from 0 to 1: settings add up to transparencyLimit to transparency, and
/// colours that are divided by alpha grow.
bool ImageTable::isEndless() const {
    switch (channel_) {
        case ImageChannel::filter:
        case ImageChannel::transmit: return true;
        case ImageChannel::red:
        case ImageChannel::green:
        case ImageChannel::blue: return image_.darkened;
        default: return false;
    }
}

// Cubic interpolation overshoots by at most a quarter in each direction.
double ImageTable::low() const {
    if (isEndless()) return -endless;
    return image_.interpolation == ImageInterpolation::bicubic && !isCutOff() ? -1 : 0;
}

double ImageTable::high() const {
    if (isEndless()) return endless;
    if (channel_ == ImageChannel::index) return 255;
    return image_.interpolation == ImageInterpolation::bicubic && !isCutOff() ? 2 : 1;
}

Expression imageValue(const std::shared_ptr<const ImageMap>& image, ImageChannel channel,
                      const PatternPoint& point, int right, int below) {
    CrackleSettings settings;
    settings.table = std::make_shared<const ImageTable>(*image, channel, right, below);
    FunctionGraph& graph = point[0].graph();
    auto [u, v] = imagePlace(image->type, point[0], point[1], point[2]);
    // An image that is there once lies between 0 and 1.
    if (image->once && image->type != ImageMapType::planar) u = u - floor(u);
    return {graph, graph.crackle(settings, u.node(), v.node(), u.number(0).node())};
}

}  // namespace isoscope
