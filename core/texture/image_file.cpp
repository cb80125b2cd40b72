// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/texture/image_file.h"

#include <png.h>

#include <cmath>

#include "core/scene/scene.h"
#include "core/shapes/raster_file.h"

namespace isoscope {

namespace {

constexpr std::size_t pixelLimit = std::size_t{1} << 23;

/// From 0..1 as stored to the colours of the scene.
class ChannelTable {
  public:
    explicit ChannelTable(double assumedGamma) {
        for (int k = 0; k < 256; ++k) values_[k] = static_cast<float>(decoded(k / 255.0, assumedGamma));
    }
    float operator[](int stored) const { return values_[stored]; }

  private:
    static double decoded(double stored, double assumedGamma) {
        if (assumedGamma == srgbGamma) return stored;
        const double light = stored <= 0.04045 ? stored / 12.92 : std::pow((stored + 0.055) / 1.055, 2.4);
        return assumedGamma > 0 ? std::pow(light, 1 / assumedGamma) : light;
    }
    float values_[256];
};

std::optional<ImageMap> readPng(const std::filesystem::path& file, double assumedGamma,
                                std::string& problem) {
    png_image png{};
    png.version = PNG_IMAGE_VERSION;
    if (!png_image_begin_read_from_file(&png, file.c_str())) {
        problem = png.message;
        return std::nullopt;
    }
    png.format = PNG_FORMAT_RGBA;
    const std::size_t count = static_cast<std::size_t>(png.width) * png.height;
    if (count == 0 || count > pixelLimit) {
        png_image_free(&png);
        problem = "the image is too large";
        return std::nullopt;
    }
    std::vector<png_byte> bytes(PNG_IMAGE_SIZE(png));
    if (!png_image_finish_read(&png, nullptr, bytes.data(), 0, nullptr)) {
        problem = png.message;
        return std::nullopt;
    }
    const ChannelTable table(assumedGamma);
    ImageMap image;
    image.width = static_cast<int>(png.width);
    image.height = static_cast<int>(png.height);
    std::vector<ImageMap::Sample> samples(count);
    for (std::size_t i = 0; i < count; ++i)
        samples[i] = {table[bytes[4 * i]], table[bytes[4 * i + 1]], table[bytes[4 * i + 2]], 0,
                      1 - static_cast<float>(bytes[4 * i + 3]) / 255};
    image.samples = std::make_shared<const std::vector<ImageMap::Sample>>(std::move(samples));
    return image;
}

}  // namespace

std::optional<ImageMap> readImageMap(const std::filesystem::path& file, double assumedGamma,
                                     std::string& problem) {
    if (rasterFormat(file) == RasterFormat::png) return readPng(file, assumedGamma, problem);
    const std::optional<Raster> raster = readRaster(file, problem);
    if (!raster) return std::nullopt;
    if (raster->indexed && raster->palette.empty()) {
        problem = "its palette is not understood";
        return std::nullopt;
    }
    const ChannelTable table(assumedGamma);
    ImageMap image;
    image.width = raster->width;
    image.height = raster->height;
    const std::size_t count = static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height);
    if (count == 0 || count > pixelLimit) {
        problem = "the image is too large";
        return std::nullopt;
    }
    std::vector<ImageMap::Sample> samples(count, ImageMap::Sample{});
    const double largest = raster->largest > 0 ? raster->largest : 255;
    for (std::size_t i = 0; i < count; ++i) {
        const auto channels = static_cast<std::size_t>(raster->channels);
        for (std::size_t c = 0; c < 3; ++c) {
            const std::uint16_t sample = raster->samples[i * channels + (channels == 3 ? c : 0)];
            int stored = static_cast<int>(std::lround(255 * std::min(1.0, sample / largest)));
            if (raster->indexed) stored = sample < raster->palette.size() ? raster->palette[sample][c] : 0;
            samples[i][c] = table[stored];
        }
    }
    image.samples = std::make_shared<const std::vector<ImageMap::Sample>>(std::move(samples));
    return image;
}

}  // namespace isoscope
