// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/render/image.h"

#include <array>
#include <bit>
#include <cmath>

namespace isoscope {

namespace {

/// The sRGB transfer function in (0, 1).
std::uint32_t encodeByFormula(double linear) {
    const double curve = linear <= 0.0031308 ? 12.92 * linear : 1.055 * std::pow(linear, 1 / 2.4) - 0.055;
    return static_cast<std::uint32_t>(std::floor(curve * 255 + 0.5));
}

/// The formula for every float in (0, 1), without its power: floats with the same upper 16 bits (seven of
/// them mantissa) have one code, or two that meet at `step`.
class EncodingTable {
  public:
    EncodingTable() {
        for (std::uint32_t bucket = 0; bucket < bucketCount; ++bucket) {
            const std::uint32_t first = (firstBucket + bucket) << 16;
            const std::uint32_t code = encodeByFormula(std::bit_cast<float>(first));
            std::uint32_t low = first, high = first + 0x10000;
            while (high - low > 1) {
                const std::uint32_t middle = low + (high - low) / 2;
                (encodeByFormula(std::bit_cast<float>(middle)) == code ? low : high) = middle;
            }
            buckets_[bucket] = {std::bit_cast<float>(high), code};
        }
    }

    std::uint32_t encode(float linear) const {
        if (!(linear > 0)) return 0;
        if (linear >= 1) return 255;
        const std::uint32_t bits = std::bit_cast<std::uint32_t>(linear) >> 16;
        if (bits < firstBucket) return 0;
        const Bucket& bucket = buckets_[bits - firstBucket];
        return bucket.code + (linear >= bucket.step ? 1 : 0);
    }

  private:
    struct Bucket {
        float step = 0;
        std::uint32_t code = 0;
    };
    /// 2^-13; everything below has code 0.
    static constexpr std::uint32_t firstBucket = std::bit_cast<std::uint32_t>(0x1p-13f) >> 16;
    static constexpr std::uint32_t bucketCount = (std::bit_cast<std::uint32_t>(1.0f) >> 16) - firstBucket;
    std::array<Bucket, bucketCount> buckets_;
};

}  // namespace

std::uint32_t encodePixel(const std::array<float, 3>& linear) {
    static const EncodingTable table;
    return 0xff000000u | table.encode(linear[0]) << 16 | table.encode(linear[1]) << 8 |
           table.encode(linear[2]);
}

float decodeChannel(double encoded) {
    if (!(encoded > 0)) return 0;
    if (encoded <= 0.04045) return static_cast<float>(encoded / 12.92);
    return static_cast<float>(std::pow((encoded + 0.055) / 1.055, 2.4));
}

}  // namespace isoscope
