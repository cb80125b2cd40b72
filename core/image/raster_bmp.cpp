// SPDX-License-Identifier: GPL-3.0-or-later
#include <cstdlib>

#include "core/image/raster_file.h"

namespace isoscope {

namespace {

/// The file header and the info header that Windows writes; later ones begin the same way.
constexpr std::size_t headerSize = 54;

std::uint32_t wordAt(std::span<const std::uint8_t> b, std::size_t at) {
    return static_cast<std::uint32_t>(b[at]) | static_cast<std::uint32_t>(b[at + 1]) << 8 |
           static_cast<std::uint32_t>(b[at + 2]) << 16 | static_cast<std::uint32_t>(b[at + 3]) << 24;
}

struct BmpHeader {
    std::size_t pixels;       ///< where they begin
    std::size_t palette;      ///< where it begins
    std::size_t paletteSize;  ///< colours
    std::int64_t width, height;
    int bits;
    std::uint32_t compression;
};

BmpHeader headerOf(std::span<const std::uint8_t> b) {
    BmpHeader header{};
    header.pixels = wordAt(b, 10);
    header.palette = 14 + std::size_t{wordAt(b, 14)};
    header.width = static_cast<std::int32_t>(wordAt(b, 18));
    header.height = static_cast<std::int32_t>(wordAt(b, 22));
    header.bits = b[28] | b[29] << 8;
    header.compression = wordAt(b, 30);
    header.paletteSize = wordAt(b, 46);
    if (header.paletteSize == 0 && header.bits == 8) header.paletteSize = 256;
    return header;
}

/// Whether all colours of a palette are grey and each is its own index, as writers of grey images make it.
bool isGreyScale(std::span<const std::uint8_t> b, const BmpHeader& header) {
    if (header.palette + 4 * header.paletteSize > b.size()) return false;
    for (std::size_t i = 0; i < header.paletteSize; ++i)
        for (std::size_t channel = 0; channel < 3; ++channel)
            if (b[header.palette + 4 * i + channel] != i) return false;
    return true;
}

}  // namespace

std::optional<Raster> decodeBmp(std::span<const std::uint8_t> bytes) {
    if (bytes.size() < headerSize) return std::nullopt;
    const BmpHeader header = headerOf(bytes);
    const bool known = header.bits == 8 || header.bits == 24 || header.bits == 32;
    if (!known || header.compression != 0 || header.width <= 0 || header.height == 0) return std::nullopt;
    const auto width = static_cast<std::size_t>(header.width);
    const auto height = static_cast<std::size_t>(std::llabs(header.height));
    if (width > rasterSampleLimit / 4 / height) return std::nullopt;
    const auto pixelBytes = static_cast<std::size_t>(header.bits / 8);
    // Rows are filled up to whole words of four bytes.
    const std::size_t rowBytes = (width * pixelBytes + 3) / 4 * 4;
    if (header.pixels > bytes.size() || rowBytes * height > bytes.size() - header.pixels) return std::nullopt;
    Raster raster;
    raster.width = static_cast<int>(width);
    raster.height = static_cast<int>(height);
    raster.channels = pixelBytes == 1 ? 1 : 3;
    raster.indexed = pixelBytes == 1 && !isGreyScale(bytes, header);
    raster.samples.reserve(width * height * static_cast<std::size_t>(raster.channels));
    for (std::size_t row = 0; row < height; ++row) {
        // From the bottom up, unless the height is negative.
        const std::size_t stored = header.height > 0 ? height - 1 - row : row;
        const auto line = bytes.subspan(header.pixels + stored * rowBytes, rowBytes);
        for (std::size_t x = 0; x < width; ++x) {
            if (raster.channels == 1) {
                raster.samples.push_back(line[x]);
                continue;
            }
            for (const std::size_t channel : {2u, 1u, 0u})  // stored as blue, green, red
                raster.samples.push_back(line[x * pixelBytes + channel]);
        }
    }
    return raster;
}

}  // namespace isoscope
