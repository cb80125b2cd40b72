// SPDX-License-Identifier: GPL-3.0-or-later
#include <csetjmp>
#include <cstdio>
// jpeglib.h needs cstdio before it.
#include <jpeglib.h>

#include "core/image/raster_file.h"

namespace isoscope {

namespace {

/// A progressive image of more passes is made to cost time.
constexpr int passLimit = 500;

struct Errors {
    jpeg_error_mgr manager;
    std::jmp_buf escape;
};

[[noreturn]] void giveUp(j_common_ptr jpeg) { std::longjmp(reinterpret_cast<Errors*>(jpeg->err)->escape, 1); }

/// Warnings are given for damaged data, of which POV-Ray, too, shows what can be read.
void beQuiet(j_common_ptr, int) {}

void limitPasses(j_common_ptr jpeg) {
    if (reinterpret_cast<j_decompress_ptr>(jpeg)->input_scan_number > passLimit) giveUp(jpeg);
}

struct Header {
    unsigned width = 0, height = 0;
    int channels = 0;
};

/// Kept free of objects with destructors: errors leave it by longjmp. Called once for the header alone, with
/// `samples` null, and once more for everything.
bool decode(std::span<const std::uint8_t> bytes, Header& header, JSAMPLE* samples) {
    jpeg_decompress_struct jpeg;
    Errors errors;
    jpeg_progress_mgr progress{};
    progress.progress_monitor = limitPasses;
    jpeg.err = jpeg_std_error(&errors.manager);
    errors.manager.error_exit = giveUp;
    errors.manager.emit_message = beQuiet;
    if (setjmp(errors.escape)) {
        jpeg_destroy_decompress(&jpeg);
        return false;
    }
    jpeg_create_decompress(&jpeg);
    jpeg.progress = &progress;
    jpeg_mem_src(&jpeg, bytes.data(), bytes.size());
    jpeg_read_header(&jpeg, TRUE);
    const bool usable = jpeg.num_components == 1 || jpeg.num_components == 3;
    if (usable) {
        jpeg.out_color_space = jpeg.num_components == 1 ? JCS_GRAYSCALE : JCS_RGB;
        header = {jpeg.image_width, jpeg.image_height, jpeg.num_components};
    }
    if (usable && samples) {
        jpeg_start_decompress(&jpeg);
        const std::size_t stride = std::size_t{header.width} * static_cast<std::size_t>(header.channels);
        while (jpeg.output_scanline < jpeg.output_height) {
            JSAMPROW row = samples + stride * jpeg.output_scanline;
            jpeg_read_scanlines(&jpeg, &row, 1);
        }
    }
    jpeg_destroy_decompress(&jpeg);
    return usable;
}

}  // namespace

/// Grey images and colours; CMYK is not read, as in POV-Ray.
std::optional<Raster> decodeJpeg(std::span<const std::uint8_t> bytes) {
    Header header;
    if (!decode(bytes, header, nullptr)) return std::nullopt;
    const std::size_t pixels = std::size_t{header.width} * header.height;
    if (pixels == 0 || pixels > rasterSampleLimit / 4) return std::nullopt;
    std::vector<JSAMPLE> samples(pixels * static_cast<std::size_t>(header.channels));
    if (!decode(bytes, header, samples.data())) return std::nullopt;
    Raster raster;
    raster.width = static_cast<int>(header.width);
    raster.height = static_cast<int>(header.height);
    raster.channels = header.channels;
    raster.samples.assign(samples.begin(), samples.end());
    return raster;
}

}  // namespace isoscope
