// SPDX-License-Identifier: GPL-3.0-or-later
#include <tiffio.h>

#include <algorithm>
#include <memory>

#include "core/image/raster_file.h"

namespace isoscope {

namespace {

/// A file in memory, as libtiff reads it.
struct Source {
    std::span<const std::uint8_t> bytes;
    toff_t at = 0;
};

tmsize_t readSource(thandle_t handle, void* out, tmsize_t count) {
    auto& source = *static_cast<Source*>(handle);
    if (count <= 0 || source.at >= source.bytes.size()) return 0;
    const std::size_t taken =
        std::min(static_cast<std::size_t>(count), source.bytes.size() - static_cast<std::size_t>(source.at));
    std::copy_n(source.bytes.begin() + static_cast<std::ptrdiff_t>(source.at), taken,
                static_cast<std::uint8_t*>(out));
    source.at += taken;
    return static_cast<tmsize_t>(taken);
}

tmsize_t writeNothing(thandle_t, void*, tmsize_t) { return 0; }

toff_t seekSource(thandle_t handle, toff_t offset, int whence) {
    auto& source = *static_cast<Source*>(handle);
    if (whence == SEEK_SET) source.at = offset;
    if (whence == SEEK_CUR) source.at += offset;
    if (whence == SEEK_END) source.at = source.bytes.size() + offset;
    return source.at;
}

int closeSource(thandle_t) { return 0; }
toff_t sizeOfSource(thandle_t handle) { return static_cast<Source*>(handle)->bytes.size(); }

struct CloseTiff {
    void operator()(TIFF* tiff) const { TIFFClose(tiff); }
};

struct Layout {
    std::uint16_t bits = 1, samples = 1, meaning = PHOTOMETRIC_MINISBLACK;

    explicit Layout(TIFF* tiff) {
        TIFFGetFieldDefaulted(tiff, TIFFTAG_BITSPERSAMPLE, &bits);
        TIFFGetFieldDefaulted(tiff, TIFFTAG_SAMPLESPERPIXEL, &samples);
        TIFFGetField(tiff, TIFFTAG_PHOTOMETRIC, &meaning);
    }
    /// Grey values with black low, or indices of a palette, as numbers in a row.
    bool isPlain() const {
        const bool known = meaning == PHOTOMETRIC_MINISBLACK || meaning == PHOTOMETRIC_PALETTE;
        return known && samples == 1 && (bits == 1 || bits == 2 || bits == 4 || bits == 8 || bits == 16);
    }
};

/// Sample number `x` of a row; rows begin at whole bytes, and libtiff has put 16-bit samples into the
/// machine's order.
std::uint16_t sampleAt(const std::vector<std::uint8_t>& row, std::size_t x, unsigned bits) {
    if (bits == 16) return reinterpret_cast<const std::uint16_t*>(row.data())[x];
    const std::size_t bit = x * bits;
    const unsigned shift = 8 - bits - static_cast<unsigned>(bit % 8);
    return static_cast<std::uint16_t>(row[bit / 8] >> shift & ((1U << bits) - 1));
}

bool readPlain(TIFF* tiff, const Layout& layout, Raster& raster) {
    raster.indexed = layout.meaning == PHOTOMETRIC_PALETTE;
    raster.largest = (1 << layout.bits) - 1;
    const auto width = static_cast<std::size_t>(raster.width);
    const auto rowBytes = static_cast<std::size_t>(TIFFScanlineSize(tiff));
    if (rowBytes < (width * layout.bits + 7) / 8) return false;
    std::vector<std::uint8_t> row(rowBytes);
    for (int y = 0; y < raster.height; ++y) {
        if (TIFFReadScanline(tiff, row.data(), static_cast<std::uint32_t>(y)) < 0) return false;
        for (std::size_t x = 0; x < width; ++x) raster.samples.push_back(sampleAt(row, x, layout.bits));
    }
    return true;
}

bool readColors(TIFF* tiff, Raster& raster) {
    const auto width = static_cast<std::uint32_t>(raster.width),
               height = static_cast<std::uint32_t>(raster.height);
    std::vector<std::uint32_t> pixels(std::size_t{width} * height);
    if (!TIFFReadRGBAImageOriented(tiff, width, height, pixels.data(), ORIENTATION_TOPLEFT, 0)) return false;
    raster.channels = 3;
    for (const std::uint32_t pixel : pixels) {
        for (const std::uint32_t value : {TIFFGetR(pixel), TIFFGetG(pixel), TIFFGetB(pixel)})
            raster.samples.push_back(static_cast<std::uint16_t>(value));
        raster.alpha.push_back(static_cast<std::uint16_t>(TIFFGetA(pixel)));
    }
    return true;
}

/// What libtiff may ask for at once: files name the sizes of their parts, and lie.
constexpr tmsize_t memoryLimit = tmsize_t{1} << 28;

std::unique_ptr<TIFF, CloseTiff> openedTiff(Source& source) {
    TIFFOpenOptions* options = TIFFOpenOptionsAlloc();
    if (!options) return nullptr;
    TIFFOpenOptionsSetMaxSingleMemAlloc(options, memoryLimit);
    TIFF* tiff = TIFFClientOpenExt("image", "rm", &source, readSource, writeNothing, seekSource, closeSource,
                                   sizeOfSource, nullptr, nullptr, options);
    TIFFOpenOptionsFree(options);
    return std::unique_ptr<TIFF, CloseTiff>(tiff);
}

/// libtiff would print what it finds wrong.
void keepQuiet() {
    TIFFSetErrorHandler(nullptr);
    TIFFSetWarningHandler(nullptr);
}

}  // namespace

/// Grey values keep all their bits, of which POV-Ray 3.7 keeps 8. Colours have 8, and are darkened by alpha,
/// as there.
std::optional<Raster> decodeTiff(std::span<const std::uint8_t> bytes) {
    keepQuiet();
    Source source{bytes};
    const std::unique_ptr<TIFF, CloseTiff> tiff = openedTiff(source);
    if (!tiff) return std::nullopt;
    std::uint32_t width = 0, height = 0;
    TIFFGetField(tiff.get(), TIFFTAG_IMAGEWIDTH, &width);
    TIFFGetField(tiff.get(), TIFFTAG_IMAGELENGTH, &height);
    if (width == 0 || height == 0 || std::uint64_t{width} * height > rasterSampleLimit / 4)
        return std::nullopt;
    Raster raster;
    raster.width = static_cast<int>(width);
    raster.height = static_cast<int>(height);
    raster.darkened = true;
    const Layout layout(tiff.get());
    const bool plain = layout.isPlain() && !TIFFIsTiled(tiff.get());
    if (!(plain ? readPlain(tiff.get(), layout, raster) : readColors(tiff.get(), raster)))
        return std::nullopt;
    return raster;
}

}  // namespace isoscope
