// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/texture/image_file.h"

#include <algorithm>
#include <png.h>

#include <cmath>

#include "core/image/raster_file.h"
#include "core/scene/scene.h"

namespace isoscope {

double sceneColor(double stored, double assumedGamma, double storedGamma) {
    if (assumedGamma == storedGamma) return stored;
    const double light = storedGamma > 0     ? std::pow(stored, storedGamma)
                         : stored <= 0.04045 ? stored / 12.92
                                             : std::pow((stored + 0.055) / 1.055, 2.4);
    if (assumedGamma == 1) return light;
    if (assumedGamma > 0) return std::pow(std::max(light, 0.0), 1 / assumedGamma);
    return light <= 0.0031308 ? light * 12.92 : 1.055 * std::pow(light, 1 / 2.4) - 0.055;
}

namespace {

constexpr std::size_t pixelLimit = std::size_t{1} << 23;

/// What POV-Ray makes of the grey samples of an 8-bit PNG file: weighed as colours in single precision, and
/// cut off (measured on all 256).
float weighedGray(float sample) {
    const float weighed = 0.297F * sample + 0.589F * sample + 0.114F * sample;
    return static_cast<float>(std::floor(255.0 * static_cast<double>(weighed)) / 255);
}

/// From 0..1 as stored to the colours of the scene.
class ChannelTable {
  public:
    ChannelTable(double assumedGamma, double fileGamma) {
        for (int k = 0; k < 256; ++k) {
            stored_[k] = static_cast<float>(k) / 255;
            colors_[k] = static_cast<float>(sceneColor(k / 255.0, assumedGamma, fileGamma));
        }
    }
    float stored(int k) const { return stored_[k]; }
    float color(int k) const { return colors_[k]; }
    /// POV-Ray keeps grey images in 8 bits.
    float gray(int k) const { return std::floor(255 * colors_[k] + 1e-3F) / 255; }

  private:
    float stored_[256];
    float colors_[256];
};

/// The samples of an image, as colours and as they are stored.
struct Samples {
    explicit Samples(std::size_t count) : colors(count), stored(count) {}

    void set(std::size_t i, const ChannelTable& table, const std::array<int, 3>& channels, bool gray,
             float alpha) {
        for (std::size_t c = 0; c < 3; ++c) {
            colors[i][c] = gray ? table.gray(channels[c]) : table.color(channels[c]);
            stored[i][c] = table.stored(channels[c]);
        }
        colors[i][4] = stored[i][4] = 1 - alpha;
    }
    void giveTo(ImageMap& image) {
        image.samples = std::make_shared<const std::vector<ImageMap::Sample>>(std::move(colors));
        image.stored = std::make_shared<const std::vector<ImageMap::Sample>>(std::move(stored));
    }

    std::vector<ImageMap::Sample> colors, stored;
};

/// The numbers of the palette, of images that have one.
void readIndices(const Raster& raster, ImageMap& image) {
    if (!raster.indexed || raster.channels != 1 || raster.width != image.width ||
        raster.height != image.height)
        return;
    auto indices = std::make_shared<std::vector<std::uint8_t>>();
    indices->reserve(raster.samples.size());
    for (const std::uint16_t sample : raster.samples) indices->push_back(static_cast<std::uint8_t>(sample));
    image.indices = std::move(indices);
}

std::optional<ImageMap> readPng(const std::filesystem::path& file, const ChannelTable& table,
                                std::string& problem) {
    png_image png{};
    png.version = PNG_IMAGE_VERSION;
    if (!png_image_begin_read_from_file(&png, file.c_str())) {
        problem = png.message;
        return std::nullopt;
    }
    const bool gray = !(png.format & (PNG_FORMAT_FLAG_COLOR | PNG_FORMAT_FLAG_COLORMAP));
    const bool weighed = gray && !(png.format & (PNG_FORMAT_FLAG_ALPHA | PNG_FORMAT_FLAG_LINEAR));
    const bool palette = (png.format & PNG_FORMAT_FLAG_COLORMAP) != 0;
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
    ImageMap image;
    image.width = static_cast<int>(png.width);
    image.height = static_cast<int>(png.height);
    Samples samples(count);
    for (std::size_t i = 0; i < count; ++i)
        samples.set(i, table, {bytes[4 * i], bytes[4 * i + 1], bytes[4 * i + 2]}, gray,
                    static_cast<float>(bytes[4 * i + 3]) / 255);
    if (weighed)
        for (ImageMap::Sample& sample : samples.stored)
            for (std::size_t c = 0; c < 3; ++c) sample[c] = weighedGray(sample[c]);
    samples.giveTo(image);
    if (palette) {
        std::string ignored;
        if (const std::optional<Raster> raster = readRaster(file, ignored)) readIndices(*raster, image);
    }
    return image;
}

}  // namespace

std::optional<ImageMap> readImageMap(const std::filesystem::path& file, double assumedGamma,
                                     std::optional<double> fileGamma, std::string& problem) {
    const ChannelTable table(assumedGamma, fileGamma.value_or(srgbGamma));
    if (rasterFormat(file) == RasterFormat::png) return readPng(file, table, problem);
    const std::optional<Raster> raster = readRaster(file, problem);
    if (!raster) return std::nullopt;
    if (raster->indexed && raster->palette.empty()) {
        problem = "its palette is not understood";
        return std::nullopt;
    }
    ImageMap image;
    image.width = raster->width;
    image.height = raster->height;
    const std::size_t count = static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height);
    if (count == 0 || count > pixelLimit) {
        problem = "the image is too large";
        return std::nullopt;
    }
    Samples samples(count);
    const double largest = raster->largest > 0 ? raster->largest : 255;
    const auto channels = static_cast<std::size_t>(raster->channels);
    for (std::size_t i = 0; i < count; ++i) {
        std::array<int, 3> stored{};
        for (std::size_t c = 0; c < 3; ++c) {
            const std::uint16_t sample = raster->samples[i * channels + (channels == 3 ? c : 0)];
            stored[c] = static_cast<int>(std::lround(255 * std::min(1.0, sample / largest)));
            if (raster->indexed) stored[c] = sample < raster->palette.size() ? raster->palette[sample][c] : 0;
        }
        samples.set(i, table, stored, channels == 1 && !raster->indexed, 1);
    }
    samples.giveTo(image);
    readIndices(*raster, image);
    return image;
}

}  // namespace isoscope
