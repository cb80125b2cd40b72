// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/exchange/png_data.h"

#include <zlib.h>

#include <algorithm>
#include <atomic>
#include <memory>
#include <utility>

#include "core/render/progressive/worker_pool.h"

namespace isoscope {

namespace {

/// Rows of a band take about this many bytes.
constexpr std::size_t bandBytes = std::size_t{1} << 19;

int rowsOfBand(std::size_t rowBytes) {
    return static_cast<int>(std::clamp<std::size_t>(bandBytes / (rowBytes + 1), 1, std::size_t{1} << 16));
}

/// Rows [first, last), each with its filter in front: the difference from the pixel before.
std::vector<std::uint8_t> filteredRows(const PngRows& rows, int first, int last) {
    constexpr std::uint8_t sub = 1;
    std::vector<std::uint8_t> filtered((rows.bytes + 1) * static_cast<std::size_t>(last - first));
    std::vector<std::uint8_t> row(rows.bytes);
    std::uint8_t* into = filtered.data();
    for (int y = first; y < last; ++y) {
        rows.fill(y, row);
        *into++ = sub;
        into = std::copy_n(row.data(), rows.bytesPerPixel, into);
        for (std::size_t i = rows.bytesPerPixel; i < rows.bytes; ++i)
            *into++ = static_cast<std::uint8_t>(row[i] - row[i - rows.bytesPerPixel]);
    }
    return filtered;
}

}  // namespace

/// Some rows, compressed.
struct PngDeflater::Band {
    std::string data;
    uLong checksum = 0;  ///< of the filtered rows
    std::size_t size = 0;

    /// Without the frame of zlib, so that bands can follow each other. False when zlib fails.
    bool deflateRows(const std::vector<std::uint8_t>& bytes, bool isLast);
};

bool PngDeflater::Band::deflateRows(const std::vector<std::uint8_t>& bytes, bool isLast) {
    z_stream stream{};
    constexpr int level = 1, rawWindow = -15, memory = 8;
    if (deflateInit2(&stream, level, Z_DEFLATED, rawWindow, memory, Z_RLE) != Z_OK) return false;
    // Where memory is refused, too.
    const std::unique_ptr<z_stream, decltype(&deflateEnd)> ended(&stream, deflateEnd);
    // A flush adds a few bytes to the bound.
    data.resize(deflateBound(&stream, bytes.size()) + 16);
    stream.next_in = const_cast<Bytef*>(bytes.data());
    stream.avail_in = static_cast<uInt>(bytes.size());
    stream.next_out = reinterpret_cast<Bytef*>(data.data());
    stream.avail_out = static_cast<uInt>(data.size());
    const int result = deflate(&stream, isLast ? Z_FINISH : Z_SYNC_FLUSH);
    data.resize(stream.total_out);
    size = bytes.size();
    checksum = adler32(adler32(0, nullptr, 0), bytes.data(), static_cast<uInt>(bytes.size()));
    return result == (isLast ? Z_STREAM_END : Z_OK) && stream.avail_in == 0;
}

/// What stands in the file: the frame of zlib around all bands is its header and the checksum of all rows.
std::string PngDeflater::finish(Band band, bool last) {
    if (!std::exchange(begun_, true)) band.data.insert(0, "\x78\x01");
    checksum_ = static_cast<std::uint32_t>(
        adler32_combine(checksum_, band.checksum, static_cast<z_off_t>(band.size)));
    if (last)
        for (int shift : {24, 16, 8, 0}) band.data.push_back(static_cast<char>(checksum_ >> shift & 0xff));
    return std::move(band.data);
}

std::vector<std::string> PngDeflater::add(const PngRows& rows, bool last, int threads) {
    const int bandRows = rowsOfBand(rows.bytes);
    const int count = (rows.count + bandRows - 1) / bandRows;
    std::vector<Band> bands(static_cast<std::size_t>(count));
    std::atomic<bool> failed = bands.empty();
    const auto encode = [&](std::size_t k) {
        const int first = static_cast<int>(k) * bandRows, end = std::min(first + bandRows, rows.count);
        if (!bands[k].deflateRows(filteredRows(rows, first, end), last && end == rows.count)) failed = true;
    };
    if (count == 1)
        encode(0);
    else
        WorkerPool(threads).run(bands.size(), encode);
    if (failed) return {};
    std::vector<std::string> pieces;
    for (Band& band : bands)
        pieces.push_back(finish(std::move(band), last && pieces.size() + 1 == bands.size()));
    return pieces;
}

bool PngDeflater::addZeros(int count, std::size_t bytes, bool last,
                           const std::function<bool(std::string_view)>& put) {
    const PngRows zeros{count, bytes, 1, [](int, std::span<std::uint8_t> row) { std::ranges::fill(row, 0); }};
    const int bandRows = rowsOfBand(bytes);
    Band full;
    if (count > bandRows && !full.deflateRows(filteredRows(zeros, 0, bandRows), false)) return false;
    for (; count > bandRows; count -= bandRows)
        if (!put(finish(full, false))) return false;
    Band rest;
    return rest.deflateRows(filteredRows(zeros, 0, count), last) && put(finish(std::move(rest), last));
}

}  // namespace isoscope
