// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace isoscope {

/// The value of Raster::gamma that stands for the sRGB curve.
constexpr double rasterSrgb = 0;

/// The samples of an image file as they are stored: no gamma, no palette applied.
struct Raster {
    int width = 0;
    int height = 0;
    int channels = 1;      ///< 1: grey values or palette indices; 3: red, green, blue
    int largest = 255;     ///< the value of white
    bool indexed = false;  ///< the samples are palette indices
    /// Red, green, blue and opacity of each index; empty where it is not understood.
    std::vector<std::array<std::uint8_t, 4>> palette;
    std::vector<std::uint16_t> samples;  ///< row by row from the top, channels together
    /// Of each pixel, where `largest` is opaque; empty where the file has none.
    std::vector<std::uint16_t> alpha;
    bool darkened = false;        ///< the samples have been multiplied by alpha
    std::optional<double> gamma;  ///< light is stored^gamma, or rasterSrgb, where the file says so

    /// Sample of column x, row y (from the top) and channel (below `channels`). No bounds are checked.
    std::uint16_t at(int x, int y, int channel = 0) const {
        return samples[(static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
                        static_cast<std::size_t>(x)) *
                           static_cast<std::size_t>(channels) +
                       static_cast<std::size_t>(channel)];
    }
};

/// Image formats that readRaster() understands; netpbm stands for PGM and PPM.
enum class RasterFormat { png, gif, tga, netpbm, jpeg, tiff, bmp };

/// Images with more samples are refused.
constexpr std::size_t rasterSampleLimit = std::size_t{1} << 27;

/// The format by the first bytes, or the ending of the name for TGA, which has no mark.
std::optional<RasterFormat> rasterFormat(const std::filesystem::path& file);

/// Nothing, and the reason in `problem`, when the file cannot be read or is damaged.
std::optional<Raster> readRaster(const std::filesystem::path& file, std::string& problem);

/// Whole files in memory. Empty for damaged files, for kinds that are not read, and above rasterSampleLimit.
/// PNG: any depth; 16 bits a sample are kept, fewer read as 8. Of colours that are meant to be transparent
/// those of a palette are known alone, as in POV-Ray. GIF: the first image, as palette indices.
std::optional<Raster> decodePng(std::span<const std::uint8_t> bytes);
std::optional<Raster> decodeGif(std::span<const std::uint8_t> bytes);
/// Grey, palette indices of 8 bits, and colours of 24 or 32 bits (the last 8 are alpha), plain or run-length
/// coded.
std::optional<Raster> decodeTga(std::span<const std::uint8_t> bytes);
/// Grey and colours; CMYK is not read, as in POV-Ray.
std::optional<Raster> decodeJpeg(std::span<const std::uint8_t> bytes);
/// The first image: grey values and palette indices keep all their bits, colours have 8 and are darkened.
std::optional<Raster> decodeTiff(std::span<const std::uint8_t> bytes);
/// 1, 4, 8, 24 or 32 bits a pixel; of 4 and 8 run-length coded, too.
std::optional<Raster> decodeBmp(std::span<const std::uint8_t> bytes);
/// PGM and PPM, plain and raw.
std::optional<Raster> decodeNetpbm(std::span<const std::uint8_t> bytes);

}  // namespace isoscope
