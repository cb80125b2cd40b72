// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace isoscope {

/// The rows of a picture for deflatedRows(): `fill` writes row `row`, `bytes` long, as PNG has it before
/// filtering. It is called from several threads.
struct PngRows {
    int count = 0;
    std::size_t bytes = 0;
    std::size_t bytesPerPixel = 0;
    std::function<void(int row, std::span<std::uint8_t> into)> fill;
};

/// The compressed picture data of a PNG, in pieces that belong one behind the other: bands of rows, each
/// filtered by `Sub` and deflated by itself as runs of equal bytes, which takes a fifth of the time of a
/// search for longer matches and an eighth more room.
class PngDeflater {
  public:
    /// The pieces of the next rows of the picture. `threads` as for WorkerPool; the bytes are the same for
    /// any number of them. Empty when zlib fails.
    std::vector<std::string> add(const PngRows& rows, bool last, int threads);
    /// The same for `count` rows of zeros, `bytes` each, handed to `put` one by one: soon, however many they
    /// are, for few bands are compressed for all. False when zlib fails, or put() returns false.
    bool addZeros(int count, std::size_t bytes, bool last, const std::function<bool(std::string_view)>& put);

  private:
    struct Band;

    std::string finish(Band band, bool last);

    bool begun_ = false;
    std::uint32_t checksum_ = 1;  ///< Adler-32 of the filtered rows so far
};

}  // namespace isoscope
