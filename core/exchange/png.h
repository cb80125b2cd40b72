// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <string_view>

#include "core/exchange/png_data.h"
#include "core/render/image.h"
#include "core/shapes/patches/height_field.h"

namespace isoscope {

/// How the pixels of a PNG are stored: RGB with the sRGB chunk.
struct PngForm {
    int width = 0;
    int height = 0;
    int bits = 8;          ///< of a channel: 8 or 16
    bool opacity = false;  ///< a fourth channel; colours are stored as if nothing shone through
};

/// A PNG that is made from the top, so that neither picture nor file need fit into memory.
class PngStream {
  public:
    /// Hands the bytes of the file to `sink`, in order; it returns whether it could take them. `threads` as
    /// for WorkerPool: the bytes are the same for any number.
    PngStream(const PngForm& form, std::function<bool(std::string_view)> sink, int threads = 1);
    /// The next rows, of the form's width; the file is whole when there are as many as its height. Without
    /// Image::opacity they hide everything. False after a failure.
    bool add(const Image& rows);
    /// The same for rows without light, which hide nothing where the form has opacity; soon, however many
    /// they are.
    bool addBlack(int rows);

  private:
    bool take(int rows);
    std::size_t pixelBytes() const;
    bool put(const char* chunk, std::string_view data);

    PngForm form_;
    std::function<bool(std::string_view)> sink_;
    int threads_;
    int rows_ = 0;
    bool failed_ = false;
    PngDeflater deflater_;
};

/// The bytes of an RGB PNG, with opacity where the image has it; none for an image without pixels. `threads`
/// as for WorkerPool: large pictures are made by several, with the same bytes for any number.
std::string encodePng(const Image& image, int threads = 1, int bits = 8);

/// Writes that file whole or not at all (core/text/whole_file.h); false when it cannot be.
bool writePng(const std::filesystem::path& file, const Image& image);

/// The heights as a grey 16-bit PNG without gamma, which POV-Ray's height_field reads as they are.
std::string encodeHeightPng(const HeightGrid& grid);

/// Reads any PNG, in 8 bits a channel and without its alpha, as linear light; an empty image when that fails.
Image readPng(const std::filesystem::path& file);

}  // namespace isoscope
