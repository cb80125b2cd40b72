// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/render/image.h"

// foreach_target.h includes this very file once per instruction set.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/render/image.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>

#ifndef ISOSCOPE_RENDER_IMAGE_ONCE
#define ISOSCOPE_RENDER_IMAGE_ONCE
namespace isoscope {

/// The sRGB transfer function in (0, 1) for every float, without its power: floats with the same upper 16
/// bits (seven of them mantissa) have one code, or two that meet at a step.
class EncodingTable {
  public:
    /// 2^-13; everything below has code 0.
    static constexpr std::uint32_t firstBucket = std::bit_cast<std::uint32_t>(0x1p-13f) >> 16;
    static constexpr std::uint32_t bucketCount = (std::bit_cast<std::uint32_t>(1.0f) >> 16) - firstBucket;

    EncodingTable() {
        for (std::uint32_t bucket = 0; bucket < bucketCount; ++bucket) {
            const std::uint32_t first = (firstBucket + bucket) << 16;
            const std::int32_t code = encodeByFormula(std::bit_cast<float>(first));
            std::uint32_t low = first, high = first + 0x10000;
            while (high - low > 1) {
                const std::uint32_t middle = low + (high - low) / 2;
                (encodeByFormula(std::bit_cast<float>(middle)) == code ? low : high) = middle;
            }
            steps_[bucket] = std::bit_cast<float>(high);
            codes_[bucket] = code;
        }
    }

    static const EncodingTable& instance() {
        static const EncodingTable table;
        return table;
    }

    // Of each bucket.
    const float* steps() const { return steps_.data(); }
    const std::int32_t* codes() const { return codes_.data(); }

  private:
    static std::int32_t encodeByFormula(double linear) {
        const double curve = linear <= 0.0031308 ? 12.92 * linear : 1.055 * std::pow(linear, 1 / 2.4) - 0.055;
        return static_cast<std::int32_t>(std::floor(curve * 255 + 0.5));
    }

    std::array<float, bucketCount> steps_;
    std::array<std::int32_t, bucketCount> codes_;
};

}  // namespace isoscope
#endif

HWY_BEFORE_NAMESPACE();
namespace isoscope::HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;

using Floats = hn::ScalableTag<float>;
using Codes = hn::RebindToSigned<Floats>;

HWY_INLINE hn::Vec<Codes> encode(hn::Vec<Floats> linear, const EncodingTable& table) {
    const Floats d;
    const Codes codes;
    const auto zero = hn::Zero(codes);
    // The least number that is not code 0 throughout, and the largest below 1; not a number counts as 0.
    const auto least = hn::Set(d, 0x1p-13f), most = hn::Set(d, 0x1.fffffep-1f);
    const auto dark = hn::Not(hn::Ge(linear, least)), bright = hn::Gt(linear, most);
    const auto usual = hn::Min(hn::IfThenElse(dark, least, linear), most);
    const auto bucket = hn::Sub(hn::ShiftRight<16>(hn::BitCast(codes, usual)),
                                hn::Set(codes, static_cast<std::int32_t>(EncodingTable::firstBucket)));
    const auto code = hn::GatherIndex(codes, table.codes(), bucket);
    const auto beyond = hn::Ge(usual, hn::GatherIndex(d, table.steps(), bucket));
    const auto found = hn::Sub(code, hn::VecFromMask(codes, hn::RebindMask(codes, beyond)));
    const auto clipped = hn::IfThenElse(hn::RebindMask(codes, bright), hn::Set(codes, 255), found);
    return hn::IfThenElse(hn::RebindMask(codes, dark), zero, clipped);
}

void encodeAll(const float* linear, std::size_t count, std::uint32_t* encoded) {
    const Floats d;
    const hn::RebindToUnsigned<Floats> words;
    const EncodingTable& table = EncodingTable::instance();
    const std::size_t lanes = hn::Lanes(d);
    for (std::size_t i = 0; i < count; i += lanes) {
        // The last vector of a list that has one begins earlier.
        if (i + lanes > count) i = count - lanes;
        hn::Vec<Floats> red, green, blue;
        hn::LoadInterleaved3(d, linear + 3 * i, red, green, blue);
        const auto code = [&](hn::Vec<Floats> channel)
                              HWY_ATTR { return hn::BitCast(words, encode(channel, table)); };
        const auto color = hn::Or(hn::Or(hn::ShiftLeft<16>(code(red)), hn::ShiftLeft<8>(code(green))),
                                  hn::Or(code(blue), hn::Set(words, 0xff000000u)));
        hn::StoreU(color, words, encoded + i);
    }
}

std::size_t vectorPixels() { return hn::Lanes(Floats()); }

}  // namespace
}  // namespace isoscope::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace isoscope {

HWY_EXPORT(encodeAll);
HWY_EXPORT(vectorPixels);

/// No vector holds more floats.
constexpr std::size_t largestVector = 64;

void encodePixels(std::span<const std::array<float, 3>> linear, std::span<std::uint32_t> encoded) {
    if (linear.empty()) return;
    if (linear.size() >= HWY_DYNAMIC_DISPATCH(vectorPixels)())
        return HWY_DYNAMIC_DISPATCH(encodeAll)(linear[0].data(), linear.size(), encoded.data());
    std::array<std::array<float, 3>, largestVector> padded{};
    std::array<std::uint32_t, largestVector> codes;
    std::copy(linear.begin(), linear.end(), padded.begin());
    HWY_DYNAMIC_DISPATCH(encodeAll)(padded[0].data(), padded.size(), codes.data());
    std::copy_n(codes.begin(), linear.size(), encoded.begin());
}

std::uint32_t encodePixel(const std::array<float, 3>& linear) {
    std::uint32_t encoded = 0;
    encodePixels({&linear, 1}, {&encoded, 1});
    return encoded;
}

std::uint16_t encodeChannel16(float linear) {
    if (!(linear > 0)) return 0;
    if (linear >= 1) return 0xffff;
    const double value = linear;
    const double curve = value <= 0.0031308 ? 12.92 * value : 1.055 * std::pow(value, 1 / 2.4) - 0.055;
    return static_cast<std::uint16_t>(std::lround(65535 * curve));
}

float decodeChannel(double encoded) {
    if (!(encoded > 0)) return 0;
    if (encoded <= 0.04045) return static_cast<float>(encoded / 12.92);
    return static_cast<float>(std::pow((encoded + 0.055) / 1.055, 2.4));
}

}  // namespace isoscope
#endif
