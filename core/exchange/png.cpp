// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/exchange/png.h"

#include <png.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <vector>

#include "core/exchange/png_data.h"
#include "core/text/whole_file.h"

namespace isoscope {

namespace {

/// Larger files are refused rather than decoded: no picture of ours comes near, and a hostile header could
/// ask for any amount of memory.
constexpr std::size_t pixelLimit = std::size_t{1} << 28;

void append(png_structp png, png_bytep bytes, png_size_t count) {
    static_cast<std::string*>(png_get_io_ptr(png))->append(reinterpret_cast<const char*>(bytes), count);
}

/// Makes no objects with destructors: libpng leaves it by longjmp. No time stamp: the same picture gives the
/// same bytes.
bool writePieces(std::string* file, const std::vector<std::string>& pieces, int width, int height,
                 bool heights) {
    png_structp png = png_create_write_struct(PNG_LIBPNG_VER_STRING, nullptr, nullptr, nullptr);
    png_infop info = png ? png_create_info_struct(png) : nullptr;
    if (!info || setjmp(png_jmpbuf(png))) {
        png_destroy_write_struct(&png, &info);
        return false;
    }
    png_set_write_fn(png, file, append, nullptr);
    png_set_IHDR(png, info, static_cast<png_uint_32>(width), static_cast<png_uint_32>(height),
                 heights ? 16 : 8, heights ? PNG_COLOR_TYPE_GRAY : PNG_COLOR_TYPE_RGB, PNG_INTERLACE_NONE,
                 PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
    if (!heights) png_set_sRGB_gAMA_and_cHRM(png, info, PNG_sRGB_INTENT_PERCEPTUAL);
    png_write_info(png, info);
    const auto chunk = [&](const char* name, const char* data, std::size_t size) {
        png_write_chunk(png, reinterpret_cast<png_const_bytep>(name), reinterpret_cast<png_const_bytep>(data),
                        size);
    };
    for (const std::string& piece : pieces) chunk("IDAT", piece.data(), piece.size());
    chunk("IEND", nullptr, 0);
    png_destroy_write_struct(&png, &info);
    return true;
}

std::string encoded(const PngRows& rows, int width, bool heights, int threads) {
    const std::vector<std::string> pieces = deflatedRows(rows, threads);
    std::string file;
    if (pieces.empty() || !writePieces(&file, pieces, width, rows.count, heights)) file.clear();
    return file;
}

bool writeFile(const std::filesystem::path& file, const std::string& content) {
    return !content.empty() && writeWhole(file, content).empty();
}

}  // namespace

std::string encodePng(const Image& image, int threads) {
    if (image.width <= 0 || image.height <= 0) return {};
    const auto width = static_cast<std::size_t>(image.width);
    const auto fill = [&](int row, std::span<std::uint8_t> into) {
        std::vector<std::uint32_t> pixels(width);
        encodePixels(std::span(image.pixels).subspan(width * static_cast<std::size_t>(row), width), pixels);
        std::uint8_t* byte = into.data();
        for (const std::uint32_t pixel : pixels)
            for (const int shift : {16, 8, 0}) *byte++ = static_cast<std::uint8_t>(pixel >> shift);
    };
    return encoded({image.height, 3 * width, 3, fill}, image.width, false, threads);
}

bool writePng(const std::filesystem::path& file, const Image& image) {
    return writeFile(file, encodePng(image));
}

std::string encodeHeightPng(const HeightGrid& grid) {
    if (grid.columns <= 0 || grid.rows <= 0) return {};
    const auto fill = [&](int row, std::span<std::uint8_t> into) {
        for (int column = 0; column < grid.columns; ++column) {
            const double height = std::clamp(grid.at(column, grid.rows - 1 - row), 0.0, 1.0);
            const auto steps = static_cast<unsigned>(std::lround(65535 * height));
            into[2 * static_cast<std::size_t>(column)] = static_cast<std::uint8_t>(steps >> 8);
            into[2 * static_cast<std::size_t>(column) + 1] = static_cast<std::uint8_t>(steps);
        }
    };
    return encoded({grid.rows, 2 * static_cast<std::size_t>(grid.columns), 2, fill}, grid.columns, true, 1);
}

Image readPng(const std::filesystem::path& file) {
    png_image png;
    std::memset(&png, 0, sizeof png);
    png.version = PNG_IMAGE_VERSION;
    Image image;
    if (!png_image_begin_read_from_file(&png, file.c_str())) return image;
    png.format = PNG_FORMAT_RGBA;
    if (std::size_t{png.width} * png.height > pixelLimit) {
        png_image_free(&png);
        return image;
    }
    // Bytes and our own curve: libpng's linear formats take sRGB for a power law and miss some of the 256
    // steps.
    std::vector<png_byte> samples(PNG_IMAGE_SIZE(png));
    if (!png_image_finish_read(&png, nullptr, samples.data(), 0, nullptr)) return image;
    image = Image(static_cast<int>(png.width), static_cast<int>(png.height));
    for (std::size_t i = 0; i < image.pixels.size(); ++i)
        for (std::size_t channel = 0; channel < 3; ++channel)
            image.pixels[i][channel] = decodeChannel(samples[4 * i + channel] / 255.0);
    return image;
}

}  // namespace isoscope
