// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/texture/image_file.h"

#include <algorithm>
#include <cmath>

#include "core/image/brightness.h"
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
    const float weighed = brightness<float>(sample, sample, sample);
    return static_cast<float>(std::floor(255.0 * static_cast<double>(weighed)) / 255);
}

/// The gamma that the samples have.
double gammaIn(const Raster& raster, RasterFormat format, const ImageColors& colors) {
    if (colors.gamma) return *colors.gamma;
    if (colors.trustsFile && raster.gamma) return *raster.gamma == rasterSrgb ? srgbGamma : *raster.gamma;
    const bool plain = format == RasterFormat::tiff || format == RasterFormat::netpbm;
    return colors.supposesSrgb && !plain ? srgbGamma : colors.assumedGamma;
}

/// The same, or the scene's where it differs by less than 1 %: POV-Ray then leaves the samples as they are.
double gammaOf(const Raster& raster, RasterFormat format, const ImageColors& colors) {
    const double gamma = gammaIn(raster, format, colors), assumed = colors.assumedGamma;
    return std::abs(gamma - assumed) < 0.01 * std::min(gamma, assumed) ? assumed : gamma;
}

/// The samples of an image, as colours and as they are stored.
class Samples {
  public:
    Samples(const Raster& raster, RasterFormat format, const ImageColors& colors)
        : raster_(raster),
          weighs_(format == RasterFormat::png && !raster.indexed && raster.channels == 1 &&
                  raster.largest == 255 && raster.alpha.empty()),
          steps_(format == RasterFormat::tiff ? std::min(raster.largest, 255) : raster.largest) {
        // Of a palette the bytes of its colours count.
        const int count = raster.indexed ? 255 : steps_;
        const double storedGamma = gammaOf(raster, format, colors);
        for (int k = 0; k <= count; ++k) {
            const double stored = static_cast<double>(k) / count;
            stored_.push_back(static_cast<float>(stored));
            colors_.push_back(static_cast<float>(sceneColor(stored, colors.assumedGamma, storedGamma)));
            if (weighs_) stored_.back() = weighedGray(stored_.back());
            if (weighs_) colors_.back() = weighedGray(colors_.back());
        }
    }

    /// Of pixel number `i`.
    void giveTo(ImageMap::Sample& color, ImageMap::Sample& stored, std::size_t i) const {
        std::array<std::size_t, 3> channels{};
        float opacity = 1;
        if (raster_.indexed) {
            const std::size_t index = raster_.samples[i];
            if (index < raster_.palette.size()) {
                const auto& entry = raster_.palette[index];
                channels = {entry[0], entry[1], entry[2]};
                opacity = static_cast<float>(entry[3]) / 255;
            }
        } else {
            const auto count = static_cast<std::size_t>(raster_.channels);
            for (std::size_t c = 0; c < 3; ++c)
                channels[c] = stepOf(raster_.samples[i * count + (count == 3 ? c : 0)]);
            if (!raster_.alpha.empty())
                opacity = static_cast<float>(raster_.alpha[i]) / static_cast<float>(raster_.largest);
        }
        for (std::size_t c = 0; c < 3; ++c) {
            color[c] = colors_[channels[c]];
            stored[c] = stored_[channels[c]];
        }
        color[4] = stored[4] = 1 - opacity;
    }

  private:
    std::size_t stepOf(std::uint16_t sample) const {
        const int value = std::min<int>(sample, raster_.largest);
        if (steps_ == raster_.largest) return static_cast<std::size_t>(value);
        return static_cast<std::size_t>(std::lround(static_cast<double>(value) * steps_ / raster_.largest));
    }

    const Raster& raster_;
    bool weighs_;
    int steps_;  ///< values of a sample, less one
    std::vector<float> colors_, stored_;
};

}  // namespace

std::optional<ImageMap> readImageMap(const std::filesystem::path& file, const ImageColors& wanted,
                                     std::string& problem) {
    const std::optional<RasterFormat> format = rasterFormat(file);
    const std::optional<Raster> raster = readRaster(file, problem);
    if (!raster || !format) return std::nullopt;
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
    const Samples samples(*raster, *format, wanted);
    std::vector<ImageMap::Sample> colors(count), stored(count);
    image.darkened = wanted.darkened.value_or(raster->darkened);
    for (std::size_t i = 0; i < count; ++i) {
        samples.giveTo(colors[i], stored[i], i);
        const float darkening = darkeningOf(image, colors[i]);
        for (std::size_t c = 0; c < 3; ++c) colors[i][c] /= darkening;
    }
    image.samples = std::make_shared<const std::vector<ImageMap::Sample>>(std::move(colors));
    image.stored = std::make_shared<const std::vector<ImageMap::Sample>>(std::move(stored));
    image.hasAlpha = !raster->alpha.empty() || *format == RasterFormat::tiff ||
                     (raster->indexed && *format != RasterFormat::bmp);
    if (raster->indexed) {
        auto indices = std::make_shared<std::vector<std::uint8_t>>();
        indices->reserve(count);
        for (const std::uint16_t index : raster->samples)
            indices->push_back(static_cast<std::uint8_t>(index));
        image.indices = std::move(indices);
    }
    return image;
}

}  // namespace isoscope
