// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/image/raster_file.h"

namespace isoscope {

namespace {

constexpr std::size_t headerSize = 18;

struct TgaHeader {
    int identity, paletteKind, kind, paletteFirst, paletteCount, paletteBits, width, height, bits, flags;
};

TgaHeader headerOf(std::span<const std::uint8_t> b) {
    const auto word = [&](std::size_t at) { return b[at] | b[at + 1] << 8; };
    return {b[0], b[1], b[2], word(3), word(5), b[7], word(12), word(14), b[16], b[17]};
}

/// The pixels as stored, one after another, runs written out; fewer when the file ends early.
std::vector<std::uint8_t> unpacked(std::span<const std::uint8_t> data, std::size_t pixelBytes,
                                   std::size_t total, bool runs) {
    std::vector<std::uint8_t> out;
    if (!runs) {
        if (data.size() >= total) out.assign(data.begin(), data.begin() + static_cast<std::ptrdiff_t>(total));
        return out;
    }
    std::size_t at = 0;
    while (out.size() < total && at < data.size()) {
        const std::uint8_t packet = data[at++];
        const std::size_t count = (packet & 0x7fu) + 1u;
        const std::size_t bytes = packet & 0x80 ? pixelBytes : pixelBytes * count;
        if (at + bytes > data.size()) break;
        for (std::size_t round = 0; round < (packet & 0x80 ? count : 1); ++round)
            out.insert(out.end(), data.begin() + static_cast<std::ptrdiff_t>(at),
                       data.begin() + static_cast<std::ptrdiff_t>(at + bytes));
        at += bytes;
    }
    return out;
}

/// The colours of a palette of 24 or 32 bits each: blue, green, red. Empty for others.
std::vector<std::array<std::uint8_t, 4>> paletteOf(std::span<const std::uint8_t> data,
                                                   const TgaHeader& header) {
    std::vector<std::array<std::uint8_t, 4>> palette;
    if (header.paletteBits != 24 && header.paletteBits != 32) return palette;
    const auto step = static_cast<std::size_t>(header.paletteBits / 8);
    palette.resize(static_cast<std::size_t>(header.paletteFirst));
    for (std::size_t at = 0; at + step <= data.size(); at += step)
        palette.push_back({data[at + 2], data[at + 1], data[at], 255});
    return palette;
}

}  // namespace

std::optional<Raster> decodeTga(std::span<const std::uint8_t> bytes) {
    if (bytes.size() < headerSize) return std::nullopt;
    const TgaHeader header = headerOf(bytes);
    const bool runs = header.kind >= 9;
    const int kind = runs ? header.kind - 8 : header.kind;
    if (kind < 1 || kind > 3) return std::nullopt;
    if (kind == 2 ? header.bits != 24 && header.bits != 32 : header.bits != 8) return std::nullopt;
    const std::size_t paletteBytes = header.paletteKind == 1
                                         ? static_cast<std::size_t>(header.paletteCount) *
                                               static_cast<std::size_t>((header.paletteBits + 7) / 8)
                                         : 0;
    const std::size_t start = headerSize + static_cast<std::size_t>(header.identity) + paletteBytes;
    const auto pixelBytes = static_cast<std::size_t>(header.bits / 8);
    const std::size_t count =
        static_cast<std::size_t>(header.width) * static_cast<std::size_t>(header.height);
    if (start > bytes.size() || count == 0 || count > rasterSampleLimit / 4) return std::nullopt;
    const std::vector<std::uint8_t> pixels =
        unpacked(bytes.subspan(start), pixelBytes, count * pixelBytes, runs);
    if (pixels.size() < count * pixelBytes) return std::nullopt;
    Raster raster;
    raster.width = header.width;
    raster.height = header.height;
    raster.indexed = kind == 1;
    raster.channels = kind == 2 ? 3 : 1;
    if (raster.indexed) raster.palette = paletteOf(bytes.subspan(start - paletteBytes, paletteBytes), header);
    raster.samples.resize(count * static_cast<std::size_t>(raster.channels));
    if (header.bits == 32) raster.alpha.resize(count);
    const bool topDown = header.flags & 0x20, rightToLeft = header.flags & 0x10;
    for (int row = 0; row < header.height; ++row)
        for (int column = 0; column < header.width; ++column) {
            const int y = topDown ? row : header.height - 1 - row;
            const int x = rightToLeft ? header.width - 1 - column : column;
            const auto from = (static_cast<std::size_t>(row) * static_cast<std::size_t>(header.width) +
                               static_cast<std::size_t>(column)) *
                              pixelBytes;
            const auto to = (static_cast<std::size_t>(y) * static_cast<std::size_t>(header.width) +
                             static_cast<std::size_t>(x)) *
                            static_cast<std::size_t>(raster.channels);
            for (std::size_t c = 0; c < static_cast<std::size_t>(raster.channels); ++c)
                raster.samples[to + c] = pixels[from + (raster.channels == 3 ? 2 - c : 0)];
            if (header.bits == 32) raster.alpha[to / 3] = pixels[from + 3];
        }
    return raster;
}

}  // namespace isoscope
