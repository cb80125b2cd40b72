// SPDX-License-Identifier: GPL-3.0-or-later
#include <gif_lib.h>

#include <algorithm>
#include <array>
#include <memory>

#include "core/image/raster_file.h"

namespace isoscope {

namespace {

int readBytes(GifFileType* gif, GifByteType* out, int count) {
    auto& left = *static_cast<std::span<const std::uint8_t>*>(gif->UserData);
    const std::size_t taken = std::min(left.size(), static_cast<std::size_t>(std::max(count, 0)));
    std::copy_n(left.begin(), taken, out);
    left = left.subspan(taken);
    return static_cast<int>(taken);
}

struct CloseGif {
    void operator()(GifFileType* gif) const { DGifCloseFile(gif, nullptr); }
};

/// Whether the decoder stands before the first image of the file. `transparent` becomes the index that is not
/// shown, if there is one.
bool findImage(GifFileType* gif, int& transparent) {
    GifRecordType type = UNDEFINED_RECORD_TYPE;
    while (DGifGetRecordType(gif, &type) == GIF_OK) {
        if (type == IMAGE_DESC_RECORD_TYPE) return DGifGetImageDesc(gif) == GIF_OK;
        if (type != EXTENSION_RECORD_TYPE) return false;
        int code = 0;
        GifByteType* extension = nullptr;
        if (DGifGetExtension(gif, &code, &extension) != GIF_OK) return false;
        while (extension) {
            GraphicsControlBlock control;
            // The first byte is the length.
            if (code == GRAPHICS_EXT_FUNC_CODE && DGifExtensionToGCB(extension[0], extension + 1, &control))
                transparent = control.TransparentColor;
            if (DGifGetExtensionNext(gif, &extension) != GIF_OK) return false;
        }
    }
    return false;
}

}  // namespace

/// The first image alone, as palette indices; interlaced or not.
std::optional<Raster> decodeGif(std::span<const std::uint8_t> bytes) {
    const std::unique_ptr<GifFileType, CloseGif> gif(DGifOpen(&bytes, readBytes, nullptr));
    int transparent = NO_TRANSPARENT_COLOR;
    if (!gif || !findImage(gif.get(), transparent)) return std::nullopt;
    const GifImageDesc& image = gif->Image;
    if (image.Width <= 0 || image.Height <= 0) return std::nullopt;
    const auto width = static_cast<std::size_t>(image.Width), height = static_cast<std::size_t>(image.Height);
    // A code of three bits at least stands for 4096 pixels at most: the memory is not asked for where the
    // file is too short.
    constexpr std::size_t mostPerCode = 4096, leastBits = 3;
    if (width * height > std::min(rasterSampleLimit, (8 * bytes.size() / leastBits + 1) * mostPerCode))
        return std::nullopt;
    Raster raster;
    raster.width = image.Width;
    raster.height = image.Height;
    raster.indexed = true;
    if (const ColorMapObject* colors = image.ColorMap ? image.ColorMap : gif->SColorMap)
        for (const GifColorType& color :
             std::span(colors->Colors, static_cast<std::size_t>(colors->ColorCount)))
            raster.palette.push_back({color.Red, color.Green, color.Blue, 255});
    if (transparent >= 0 && static_cast<std::size_t>(transparent) < raster.palette.size())
        raster.palette[static_cast<std::size_t>(transparent)][3] = 0;
    raster.samples.resize(width * height);
    std::vector<GifPixelType> line(width);
    // Interlaced images come in four passes.
    struct Pass {
        std::size_t first, step;
    };
    static constexpr std::array<Pass, 4> interlaced{{{0, 8}, {4, 8}, {2, 4}, {1, 2}}};
    static constexpr std::array<Pass, 1> plain{{{0, 1}}};
    const std::span<const Pass> passes = image.Interlace ? std::span<const Pass>(interlaced) : plain;
    for (const Pass& pass : passes)
        for (std::size_t y = pass.first; y < height; y += pass.step) {
            if (DGifGetLine(gif.get(), line.data(), image.Width) != GIF_OK) return std::nullopt;
            std::copy(line.begin(), line.end(),
                      raster.samples.begin() + static_cast<std::ptrdiff_t>(y * width));
        }
    return raster;
}

}  // namespace isoscope
