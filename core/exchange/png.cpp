// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/exchange/png.h"

#include <png.h>
#include <zlib.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <vector>

#include "core/render/camera/pixel.h"
#include "core/text/whole_file.h"

namespace isoscope {

namespace {

/// Larger files are refused rather than decoded: no picture of ours comes near, and a hostile header could
/// ask for any amount of memory.
constexpr std::size_t pixelLimit = std::size_t{1} << 28;

void append(png_structp png, png_bytep bytes, png_size_t count) {
    static_cast<std::string*>(png_get_io_ptr(png))->append(reinterpret_cast<const char*>(bytes), count);
}

/// What stands before the picture data. Makes no objects with destructors: libpng leaves it by longjmp. No
/// time stamp: the same picture gives the same bytes.
bool writeHeader(std::string* file, const PngForm& form, int colorType) {
    // No exception may go through libpng: append() finds room for all.
    constexpr std::size_t room = 256;
    file->reserve(file->size() + room);
    png_structp png = png_create_write_struct(PNG_LIBPNG_VER_STRING, nullptr, nullptr, nullptr);
    png_infop info = png ? png_create_info_struct(png) : nullptr;
    if (!info || setjmp(png_jmpbuf(png))) {
        png_destroy_write_struct(&png, &info);
        return false;
    }
    png_set_write_fn(png, file, append, nullptr);
    png_set_IHDR(png, info, static_cast<png_uint_32>(form.width), static_cast<png_uint_32>(form.height),
                 form.bits, colorType, PNG_INTERLACE_NONE, PNG_COMPRESSION_TYPE_DEFAULT,
                 PNG_FILTER_TYPE_DEFAULT);
    if (colorType != PNG_COLOR_TYPE_GRAY) png_set_sRGB_gAMA_and_cHRM(png, info, PNG_sRGB_INTENT_PERCEPTUAL);
    png_write_info(png, info);
    png_destroy_write_struct(&png, &info);
    return true;
}

/// Four bytes, the highest first.
void appendNumber(std::string& bytes, std::uint32_t number) {
    for (const int shift : {24, 16, 8, 0}) bytes.push_back(static_cast<char>(number >> shift & 0xff));
}

/// A piece of the file: length, name, data and checksum.
std::string chunkOf(const char* name, std::string_view data) {
    std::string chunk;
    chunk.reserve(data.size() + 12);
    appendNumber(chunk, static_cast<std::uint32_t>(data.size()));
    chunk.append(name, 4).append(data);
    const auto* bytes = reinterpret_cast<const Bytef*>(chunk.data()) + 4;
    appendNumber(chunk, static_cast<std::uint32_t>(crc32_z(crc32_z(0, nullptr, 0), bytes, chunk.size() - 4)));
    return chunk;
}

/// Row `row` as the form stores it, with the colours that stand before what shines through.
class RowWriter {
  public:
    RowWriter(const PngForm& form, const Image& image) : form_(form), image_(image) {}

    void fill(int row, std::span<std::uint8_t> into) const {
        const auto width = static_cast<std::size_t>(image_.width),
                   first = width * static_cast<std::size_t>(row);
        std::span<const LinearColor> colors = std::span(image_.pixels).subspan(first, width);
        std::vector<LinearColor> straight;
        if (form_.opacity && !image_.opacity.empty()) {
            straight.assign(colors.begin(), colors.end());
            for (std::size_t x = 0; x < width; ++x) unmultiply(straight[x], image_.opacity[first + x]);
            colors = straight;
        }
        if (form_.bits == 16)
            fill16(colors, first, into.data());
        else
            fill8(colors, first, into.data());
    }

  private:
    static void unmultiply(LinearColor& color, float opacity) {
        for (float& channel : color) channel = opacity > 0 ? channel / opacity : 0;
    }
    float opacity(std::size_t pixel) const {
        return image_.opacity.empty() ? 1.0f : std::clamp(image_.opacity[pixel], 0.0f, 1.0f);
    }

    void fill8(std::span<const LinearColor> colors, std::size_t first, std::uint8_t* byte) const {
        std::vector<std::uint32_t> pixels(colors.size());
        encodePixels(colors, pixels);
        for (std::size_t x = 0; x < pixels.size(); ++x) {
            for (const int shift : {16, 8, 0}) *byte++ = static_cast<std::uint8_t>(pixels[x] >> shift);
            if (form_.opacity) *byte++ = static_cast<std::uint8_t>(std::lround(255 * opacity(first + x)));
        }
    }
    void fill16(std::span<const LinearColor> colors, std::size_t first, std::uint8_t* byte) const {
        const auto put = [&byte](std::uint16_t value) {
            *byte++ = static_cast<std::uint8_t>(value >> 8);
            *byte++ = static_cast<std::uint8_t>(value);
        };
        for (std::size_t x = 0; x < colors.size(); ++x) {
            for (const float channel : colors[x]) put(encodeChannel16(channel));
            if (form_.opacity) put(static_cast<std::uint16_t>(std::lround(65535 * opacity(first + x))));
        }
    }

    const PngForm& form_;
    const Image& image_;
};

bool writeFile(const std::filesystem::path& file, const std::string& content) {
    return !content.empty() && writeWhole(file, content).empty();
}

}  // namespace

PngStream::PngStream(const PngForm& form, std::function<bool(std::string_view)> sink, int threads)
    : form_(form), sink_(std::move(sink)), threads_(threads) {
    std::string header;
    failed_ = form.width <= 0 || form.height <= 0 || (form.bits != 8 && form.bits != 16) ||
              !writeHeader(&header, form, form.opacity ? PNG_COLOR_TYPE_RGB_ALPHA : PNG_COLOR_TYPE_RGB) ||
              !sink_(header);
}

bool PngStream::put(const char* chunk, std::string_view data) { return sink_(chunkOf(chunk, data)); }

std::size_t PngStream::pixelBytes() const {
    return static_cast<std::size_t>(form_.bits / 8) * (form_.opacity ? 4 : 3);
}

/// Counts the next rows; false where there are too many.
bool PngStream::take(int rows) {
    failed_ = failed_ || rows <= 0 || rows > form_.height - rows_;
    if (!failed_) rows_ += rows;
    return !failed_;
}

bool PngStream::add(const Image& rows) {
    failed_ = failed_ || rows.width != form_.width;
    if (!take(rows.height)) return false;
    const bool last = rows_ == form_.height;
    const RowWriter writer(form_, rows);
    const std::vector<std::string> pieces =
        deflater_.add({rows.height, pixelBytes() * static_cast<std::size_t>(rows.width), pixelBytes(),
                       [&](int row, std::span<std::uint8_t> into) { writer.fill(row, into); }},
                      last, threads_);
    failed_ = pieces.empty();
    for (const std::string& piece : pieces) failed_ = failed_ || !put("IDAT", piece);
    if (last) failed_ = failed_ || !put("IEND", {});
    return !failed_;
}

bool PngStream::addBlack(int rows) {
    if (!take(rows)) return false;
    const bool last = rows_ == form_.height;
    failed_ = !deflater_.addZeros(rows, pixelBytes() * static_cast<std::size_t>(form_.width), last,
                                  [this](std::string_view piece) { return put("IDAT", piece); });
    if (last) failed_ = failed_ || !put("IEND", {});
    return !failed_;
}

std::string encodePng(const Image& image, int threads, int bits) {
    std::string file;
    const auto take = [&file](std::string_view bytes) {
        file += bytes;
        return true;
    };
    PngStream stream({image.width, image.height, bits, !image.opacity.empty()}, take, threads);
    return stream.add(image) ? file : std::string();
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
    std::string file;
    const std::vector<std::string> pieces =
        PngDeflater().add({grid.rows, 2 * static_cast<std::size_t>(grid.columns), 2, fill}, true, 1);
    if (pieces.empty() || !writeHeader(&file, {grid.columns, grid.rows, 16, false}, PNG_COLOR_TYPE_GRAY))
        return {};
    for (const std::string& piece : pieces) file += chunkOf("IDAT", piece);
    return file + chunkOf("IEND", {});
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
