// SPDX-License-Identifier: GPL-3.0-or-later
#include <png.h>

#include <algorithm>
#include <array>
#include <cstring>

#include "core/image/raster_file.h"

namespace isoscope {

namespace {

struct Input {
    const std::uint8_t* next;
    std::size_t left;
};

void readBytes(png_structp png, png_bytep out, std::size_t count) {
    auto* input = static_cast<Input*>(png_get_io_ptr(png));
    if (count > input->left) png_error(png, "truncated");
    std::memcpy(out, input->next, count);
    input->next += count;
    input->left -= count;
}

/// libpng would print what it finds wrong.
[[noreturn]] void giveUp(png_structp png, png_const_charp) { png_longjmp(png, 1); }
void beQuiet(png_structp, png_const_charp) {}

struct Header {
    png_uint_32 width = 0, height = 0;
    int depth = 0, type = 0;
    bool isSrgb = false;
    double encoding = 0;  ///< of the samples, where the file says it; else 0
    std::array<std::array<std::uint8_t, 4>, 256> palette{};
    std::size_t colors = 0;
};

void readColorSpace(png_structp png, png_infop info, Header& header) {
    int intent = 0;
    header.isSrgb = png_get_sRGB(png, info, &intent) != 0;
    png_get_gAMA(png, info, &header.encoding);
    png_colorp colors = nullptr;
    int count = 0;
    if (!png_get_PLTE(png, info, &colors, &count)) return;
    png_bytep opacities = nullptr;
    int opacityCount = 0;
    png_get_tRNS(png, info, &opacities, &opacityCount, nullptr);
    header.colors = std::min(static_cast<std::size_t>(std::max(count, 0)), header.palette.size());
    for (std::size_t i = 0; i < header.colors; ++i) {
        const bool opaque = !opacities || i >= static_cast<std::size_t>(opacityCount);
        header.palette[i] = {colors[i].red, colors[i].green, colors[i].blue,
                             opaque ? std::uint8_t{255} : opacities[i]};
    }
}

/// Kept free of objects with destructors: libpng leaves it by longjmp. Called once for the header alone, with
/// `rows` null, and once more for everything.
bool decode(Input input, Header& header, png_bytep samples, png_bytepp rows) {
    png_structp png = png_create_read_struct(PNG_LIBPNG_VER_STRING, nullptr, giveUp, beQuiet);
    png_infop info = png ? png_create_info_struct(png) : nullptr;
    if (!info || setjmp(png_jmpbuf(png))) {
        png_destroy_read_struct(&png, &info, nullptr);
        return false;
    }
    png_set_read_fn(png, &input, readBytes);
    png_read_info(png, info);
    png_get_IHDR(png, info, &header.width, &header.height, &header.depth, &header.type, nullptr, nullptr,
                 nullptr);
    if (rows) {
        // Everything becomes 8 or 16 bits a sample; palette indices stay indices.
        readColorSpace(png, info, header);
        if (header.depth < 8) png_set_packing(png);
        if (header.type == PNG_COLOR_TYPE_GRAY && header.depth < 8) png_set_expand_gray_1_2_4_to_8(png);
        png_read_update_info(png, info);
        const std::size_t stride = png_get_rowbytes(png, info);
        for (png_uint_32 y = 0; y < header.height; ++y) rows[y] = samples + stride * y;
        png_read_image(png, rows);
        png_read_end(png, nullptr);
    }
    png_destroy_read_struct(&png, &info, nullptr);
    return true;
}

}  // namespace

std::optional<Raster> decodePng(std::span<const std::uint8_t> bytes) {
    const Input input{bytes.data(), bytes.size()};
    Header header;
    if (!decode(input, header, nullptr, nullptr)) return std::nullopt;
    Raster raster;
    raster.indexed = header.type == PNG_COLOR_TYPE_PALETTE;
    raster.channels = !raster.indexed && (header.type & PNG_COLOR_MASK_COLOR) ? 3 : 1;
    raster.largest = header.depth == 16 ? 65535 : 255;
    const bool transparent = header.type & PNG_COLOR_MASK_ALPHA;
    const auto colors = static_cast<std::size_t>(raster.channels), stored = colors + (transparent ? 1 : 0);
    const std::size_t pixels = std::size_t{header.width} * header.height, count = pixels * stored;
    if (count == 0 || pixels > rasterSampleLimit / 4) return std::nullopt;
    // Deflate makes 1032 bytes of one at most: the memory is not asked for where the file is too short. Eight
    // samples of one bit are a byte.
    constexpr std::size_t mostPerByte = 1032;
    if (count / 8 > mostPerByte * bytes.size()) return std::nullopt;
    const std::size_t sampleBytes = header.depth == 16 ? 2 : 1;
    std::vector<png_byte> samples(count * sampleBytes);
    std::vector<png_bytep> rows(header.height);
    if (!decode(input, header, samples.data(), rows.data())) return std::nullopt;
    raster.width = static_cast<int>(header.width);
    raster.height = static_cast<int>(header.height);
    if (raster.indexed)
        raster.palette.assign(header.palette.begin(),
                              header.palette.begin() + static_cast<std::ptrdiff_t>(header.colors));
    if (header.isSrgb)
        raster.gamma = rasterSrgb;
    else if (header.encoding > 0)
        raster.gamma = 1 / header.encoding;
    raster.samples.reserve(pixels * colors);
    if (transparent) raster.alpha.reserve(pixels);
    for (std::size_t i = 0; i < count; ++i) {
        const auto sample = sampleBytes == 1
                                ? std::uint16_t{samples[i]}
                                : static_cast<std::uint16_t>(samples[2 * i] << 8 | samples[2 * i + 1]);
        (i % stored < colors ? raster.samples : raster.alpha).push_back(sample);
    }
    return raster;
}

}  // namespace isoscope
