// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
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
    if (header.bits <= 8) {
        const std::uint32_t most = 1U << header.bits;
        if (header.paletteSize == 0 || header.paletteSize > most) header.paletteSize = most;
    }
    return header;
}

/// The colours, stored as blue, green, red and nothing. Empty for files that end before.
std::vector<std::array<std::uint8_t, 4>> paletteOf(std::span<const std::uint8_t> b, const BmpHeader& header) {
    std::vector<std::array<std::uint8_t, 4>> palette;
    if (header.bits > 8 || header.palette + 4 * header.paletteSize > b.size()) return palette;
    for (std::size_t at = header.palette; palette.size() < header.paletteSize; at += 4)
        palette.push_back({b[at + 2], b[at + 1], b[at], 255});
    return palette;
}

/// Run-length coded indices, row by row as stored; those that the file passes over are 0. A pair of bytes is
/// a run of one index (of two by turns, where they have 4 bits), or a command behind 0. Nothing where pixels
/// lie outside of the image or the file ends before it says so.
std::optional<std::vector<std::uint8_t>> unpackedRuns(std::span<const std::uint8_t> data, std::size_t width,
                                                      std::size_t height, bool halves) {
    enum : std::uint8_t { endOfLine = 0, endOfImage = 1, move = 2 };
    std::vector<std::uint8_t> indices(width * height);
    std::size_t x = 0, y = 0, at = 0;
    const auto put = [&](std::uint8_t byte, std::size_t number) {
        const auto index = !halves ? byte : number % 2 == 0 ? byte >> 4 : byte & 15;
        indices[y * width + x++] = static_cast<std::uint8_t>(index);
    };
    while (at + 2 <= data.size()) {
        const std::size_t count = data[at], value = data[at + 1];
        at += 2;
        if (count > 0 || value > move) {
            const std::size_t pixels = count > 0 ? count : value;
            if (y >= height || pixels > width - x) return std::nullopt;
            // Pixels one by one fill whole words of two bytes.
            const std::size_t bytes = count > 0 ? 0 : halves ? (pixels + 1) / 2 : pixels;
            if (bytes + bytes % 2 > data.size() - at) return std::nullopt;
            for (std::size_t i = 0; i < pixels; ++i)
                put(count > 0 ? data[at - 1] : data[at + (halves ? i / 2 : i)], i);
            at += bytes + bytes % 2;
        } else if (value == endOfLine) {
            x = 0;
            ++y;
        } else if (value == endOfImage) {
            return indices;
        } else {
            if (at + 2 > data.size() || data[at] > width - x || data[at + 1] > height - y)
                return std::nullopt;
            x += data[at];
            y += data[at + 1];
            at += 2;
        }
    }
    return std::nullopt;
}

/// Indices as they are stored, in rows that are filled up to `rowBytes`.
std::vector<std::uint8_t> plainIndices(std::span<const std::uint8_t> data, std::size_t width,
                                       std::size_t height, std::size_t rowBytes, std::size_t bits) {
    std::vector<std::uint8_t> indices;
    indices.reserve(width * height);
    for (std::size_t row = 0; row < height; ++row)
        for (std::size_t x = 0; x < width; ++x) {
            const std::size_t shift = 8 - bits - x * bits % 8;
            const int byte = data[row * rowBytes + x * bits / 8];
            indices.push_back(static_cast<std::uint8_t>(byte >> shift & ((1 << bits) - 1)));
        }
    return indices;
}

/// Whether images of so many bits a pixel are read, coded in this way.
bool isKnown(const BmpHeader& header) {
    switch (header.compression) {
        case 0: return std::ranges::count(std::array{1, 4, 8, 24, 32}, header.bits) > 0;
        case 1: return header.bits == 8 && header.height > 0;  // runs go from the bottom up
        case 2: return header.bits == 4 && header.height > 0;
        default: return false;
    }
}

}  // namespace

std::optional<Raster> decodeBmp(std::span<const std::uint8_t> bytes) {
    if (bytes.size() < headerSize) return std::nullopt;
    const BmpHeader header = headerOf(bytes);
    if (!isKnown(header) || header.width <= 0 || header.height == 0) return std::nullopt;
    const auto width = static_cast<std::size_t>(header.width);
    const auto height = static_cast<std::size_t>(std::llabs(header.height));
    if (width > rasterSampleLimit / 4 / height || header.pixels > bytes.size()) return std::nullopt;
    const auto bits = static_cast<std::size_t>(header.bits);
    // Rows are filled up to whole words of four bytes.
    const std::size_t rowBytes = (width * bits + 31) / 32 * 4;
    const auto data = bytes.subspan(header.pixels);
    // The memory is not asked for where the file is too short: two bytes are a run of 255 pixels at most.
    if ((header.compression == 0 ? rowBytes * height : width * height / 128) > data.size())
        return std::nullopt;
    Raster raster;
    raster.width = static_cast<int>(width);
    raster.height = static_cast<int>(height);
    raster.channels = bits <= 8 ? 1 : 3;
    raster.palette = paletteOf(bytes, header);
    raster.indexed = bits <= 8;
    std::optional<std::vector<std::uint8_t>> indices;
    if (bits <= 8)
        indices = header.compression == 0 ? plainIndices(data, width, height, rowBytes, bits)
                                          : unpackedRuns(data, width, height, bits == 4);
    if (bits <= 8 && !indices) return std::nullopt;
    raster.samples.reserve(width * height * static_cast<std::size_t>(raster.channels));
    for (std::size_t row = 0; row < height; ++row) {
        // From the bottom up, unless the height is negative.
        const std::size_t stored = header.height > 0 ? height - 1 - row : row;
        for (std::size_t x = 0; x < width; ++x)
            if (indices)
                raster.samples.push_back((*indices)[stored * width + x]);
            else
                for (const std::size_t channel : {2u, 1u, 0u})  // stored as blue, green, red
                    raster.samples.push_back(data[stored * rowBytes + x * bits / 8 + channel]);
    }
    return raster;
}

}  // namespace isoscope
