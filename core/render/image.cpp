// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/render/image.h"

#include <cmath>

namespace isoscope {

namespace {

std::uint32_t encodeChannel(double linear) {
    if (!(linear > 0)) return 0;
    if (linear >= 1) return 255;
    const double curve = linear <= 0.0031308 ? 12.92 * linear : 1.055 * std::pow(linear, 1 / 2.4) - 0.055;
    return static_cast<std::uint32_t>(std::floor(curve * 255 + 0.5));
}

}  // namespace

std::uint32_t encodePixel(const std::array<float, 3>& linear) {
    return 0xff000000u | encodeChannel(linear[0]) << 16 | encodeChannel(linear[1]) << 8 |
           encodeChannel(linear[2]);
}

float decodeChannel(double encoded) {
    if (!(encoded > 0)) return 0;
    if (encoded <= 0.04045) return static_cast<float>(encoded / 12.92);
    return static_cast<float>(std::pow((encoded + 0.055) / 1.055, 2.4));
}

}  // namespace isoscope
