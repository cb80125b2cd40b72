// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <png.h>

#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <vector>

namespace isoscope::test {

/// The samples of a PNG as they are stored, opacity included.
struct PngChannels {
    int width = 0, height = 0, bits = 0, channels = 0;
    std::vector<std::uint16_t> samples;

    /// Of column x, row y.
    int at(int x, int y, int channel) const {
        return samples[static_cast<std::size_t>((y * width + x) * channels + channel)];
    }
    /// The same between 0 and 1.
    double share(int x, int y, int channel) const {
        return at(x, y, channel) / (bits == 16 ? 65535.0 : 255.0);
    }
};

/// By libpng, without any change of what is stored; no samples when the file is none.
inline PngChannels readPngChannels(const std::filesystem::path& path) {
    PngChannels picture;
    std::FILE* file = std::fopen(path.c_str(), "rb");
    if (!file) return picture;
    png_structp png = png_create_read_struct(PNG_LIBPNG_VER_STRING, nullptr, nullptr, nullptr);
    png_infop info = png_create_info_struct(png);
    if (setjmp(png_jmpbuf(png)) == 0) {
        png_init_io(png, file);
        png_read_png(png, info, PNG_TRANSFORM_IDENTITY, nullptr);
        picture.width = static_cast<int>(png_get_image_width(png, info));
        picture.height = static_cast<int>(png_get_image_height(png, info));
        picture.bits = png_get_bit_depth(png, info);
        picture.channels = png_get_channels(png, info);
        png_bytepp rows = png_get_rows(png, info);
        for (int y = 0; y < picture.height; ++y)
            for (int i = 0; i < picture.width * picture.channels; ++i)
                picture.samples.push_back(
                    picture.bits == 16 ? static_cast<std::uint16_t>(rows[y][2 * i] << 8 | rows[y][2 * i + 1])
                                       : rows[y][i]);
    }
    png_destroy_read_struct(&png, &info, nullptr);
    std::fclose(file);
    return picture;
}

}  // namespace isoscope::test
