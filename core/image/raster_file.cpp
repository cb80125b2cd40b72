// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/image/raster_file.h"

#include <algorithm>
#include <fstream>
#include <iterator>

namespace isoscope {

namespace {

constexpr std::uintmax_t fileSizeLimit = std::uintmax_t{256} << 20;

std::optional<RasterFormat> formatOf(std::span<const std::uint8_t> bytes, const std::filesystem::path& file) {
    const auto startsWith = [&](std::string_view mark) {
        return bytes.size() >= mark.size() &&
               std::equal(mark.begin(), mark.end(), bytes.begin(),
                          [](char a, std::uint8_t b) { return static_cast<std::uint8_t>(a) == b; });
    };
    if (startsWith("\x89PNG")) return RasterFormat::png;
    if (startsWith("GIF8")) return RasterFormat::gif;
    if (startsWith("P2") || startsWith("P3") || startsWith("P5") || startsWith("P6"))
        return RasterFormat::netpbm;
    if (startsWith("BM")) return RasterFormat::bmp;
    if (startsWith("\xff\xd8\xff")) return RasterFormat::jpeg;
    if (startsWith({"II*\0", 4}) || startsWith({"MM\0*", 4})) return RasterFormat::tiff;
    std::string ending = file.extension().string();
    std::transform(ending.begin(), ending.end(), ending.begin(), [](char c) { return c | 0x20; });
    if (ending == ".tga") return RasterFormat::tga;
    return std::nullopt;
}

}  // namespace

std::optional<RasterFormat> rasterFormat(const std::filesystem::path& file) {
    std::ifstream input(file, std::ios::binary);
    std::vector<char> start(8);
    input.read(start.data(), static_cast<std::streamsize>(start.size()));
    const std::vector<std::uint8_t> bytes(start.begin(), start.begin() + input.gcount());
    return formatOf(bytes, file);
}

std::optional<Raster> readRaster(const std::filesystem::path& file, std::string& problem) {
    std::error_code failed;
    const std::uintmax_t size = std::filesystem::file_size(file, failed);
    std::ifstream input(file, std::ios::binary);
    if (failed || !input || size > fileSizeLimit) {
        problem = size > fileSizeLimit && !failed ? "it is larger than 256 MB" : "it cannot be read";
        return std::nullopt;
    }
    const std::vector<char> read{std::istreambuf_iterator<char>(input), {}};
    const std::vector<std::uint8_t> bytes(read.begin(), read.end());
    const std::optional<RasterFormat> format = formatOf(bytes, file);
    if (!format) {
        problem = "it is no PNG, GIF, TGA, BMP, PGM, PPM, JPEG or TIFF image";
        return std::nullopt;
    }
    std::optional<Raster> raster;
    switch (*format) {
        case RasterFormat::png: raster = decodePng(bytes); break;
        case RasterFormat::gif: raster = decodeGif(bytes); break;
        case RasterFormat::tga: raster = decodeTga(bytes); break;
        case RasterFormat::jpeg: raster = decodeJpeg(bytes); break;
        case RasterFormat::tiff: raster = decodeTiff(bytes); break;
        case RasterFormat::bmp: raster = decodeBmp(bytes); break;
        case RasterFormat::netpbm: raster = decodeNetpbm(bytes); break;
    }
    if (!raster) problem = "it is damaged, too large, or of a kind that is not read";
    return raster;
}

}  // namespace isoscope
