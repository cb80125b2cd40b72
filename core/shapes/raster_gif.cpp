// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/shapes/raster_file.h"

namespace isoscope {

namespace {

/// Reads forward through a file; behind its end all bytes are 0 and `good` is false.
class ByteReader {
  public:
    explicit ByteReader(std::span<const std::uint8_t> bytes) : bytes_(bytes) {}

    int byte() {
        if (at_ < bytes_.size()) return bytes_[at_++];
        good = false;
        return 0;
    }
    int word() {
        const int low = byte();
        return low | byte() << 8;
    }
    void skip(std::size_t count) { at_ += count; }

    bool good = true;

  private:
    std::span<const std::uint8_t> bytes_;
    std::size_t at_ = 0;
};

/// The codes of a GIF image: of growing width, packed from the low bit up into blocks of at most 255 bytes.
class CodeReader {
  public:
    explicit CodeReader(ByteReader& input) : input_(input) {}

    /// -1 behind the last block.
    int next(int width) {
        while (bits_ < width) {
            if (left_ == 0) left_ = input_.byte();
            if (left_ == 0 || !input_.good) return -1;
            --left_;
            pending_ |= static_cast<unsigned>(input_.byte()) << bits_;
            bits_ += 8;
        }
        const int code = static_cast<int>(pending_ & ((1u << width) - 1));
        pending_ >>= width;
        bits_ -= width;
        return code;
    }

  private:
    ByteReader& input_;
    unsigned pending_ = 0;
    int bits_ = 0;
    int left_ = 0;
};

/// Lempel, Ziv and Welch's compression as GIF has it.
std::vector<std::uint8_t> decompress(ByteReader& input, std::size_t count) {
    const int rootBits = input.byte();
    if (rootBits < 2 || rootBits > 8) return {};
    constexpr int codeLimit = 4096;
    const int clear = 1 << rootBits, end = clear + 1;
    std::vector<int> prefix(codeLimit, -1);
    std::vector<std::uint8_t> suffix(codeLimit), first(codeLimit), out, reversed;
    for (int code = 0; code < clear; ++code)
        suffix[static_cast<std::size_t>(code)] = first[static_cast<std::size_t>(code)] =
            static_cast<std::uint8_t>(code);
    CodeReader codes(input);
    int next = end + 1, width = rootBits + 1, before = -1;
    while (out.size() < count) {
        const int code = codes.next(width);
        if (code < 0 || code == end) break;
        if (code == clear) {
            next = end + 1;
            width = rootBits + 1;
            before = -1;
            continue;
        }
        if (code > next || (before < 0 && code >= clear) || (code == next && before < 0)) return {};
        const int head = code < next ? code : before;
        if (before >= 0 && next < codeLimit) {
            prefix[static_cast<std::size_t>(next)] = before;
            first[static_cast<std::size_t>(next)] = first[static_cast<std::size_t>(before)];
            suffix[static_cast<std::size_t>(next)] = first[static_cast<std::size_t>(head)];
            ++next;
        } else if (code >= next) {
            return {};
        }
        reversed.clear();
        for (int walk = code; walk >= 0; walk = walk < clear ? -1 : prefix[static_cast<std::size_t>(walk)])
            reversed.push_back(suffix[static_cast<std::size_t>(walk)]);
        out.insert(out.end(), reversed.rbegin(), reversed.rend());
        before = code;
        if (next == 1 << width && width < 12) ++width;
    }
    out.resize(count);
    return out;
}

}  // namespace

std::optional<Raster> decodeGif(std::span<const std::uint8_t> bytes) {
    ByteReader input(bytes);
    input.skip(10);
    const int flags = input.byte();
    input.skip(2);
    if (flags & 0x80) input.skip(std::size_t{3} << ((flags & 7) + 1));
    for (int block = input.byte(); input.good && block != 0x2c; block = input.byte()) {
        if (block != 0x21) return std::nullopt;
        input.byte();
        for (int size = input.byte(); size > 0 && input.good; size = input.byte())
            input.skip(static_cast<std::size_t>(size));
    }
    input.skip(4);
    Raster raster;
    raster.indexed = true;
    raster.width = input.word();
    raster.height = input.word();
    const int imageFlags = input.byte();
    if (imageFlags & 0x80) input.skip(std::size_t{3} << ((imageFlags & 7) + 1));
    const std::size_t count =
        static_cast<std::size_t>(raster.width) * static_cast<std::size_t>(raster.height);
    if (!input.good || count == 0 || count > rasterSampleLimit) return std::nullopt;
    const std::vector<std::uint8_t> indices = decompress(input, count);
    if (indices.size() != count) return std::nullopt;
    raster.samples.resize(count);
    // Interlaced images store every eighth row first, then those between.
    std::vector<int> order;
    if (imageFlags & 0x40) {
        for (const auto& [from, step] : {std::pair{0, 8}, {4, 8}, {2, 4}, {1, 2}})
            for (int y = from; y < raster.height; y += step) order.push_back(y);
    } else {
        for (int y = 0; y < raster.height; ++y) order.push_back(y);
    }
    const auto width = static_cast<std::size_t>(raster.width);
    for (std::size_t row = 0; row < order.size(); ++row)
        for (std::size_t x = 0; x < width; ++x)
            raster.samples[static_cast<std::size_t>(order[row]) * width + x] = indices[row * width + x];
    return raster;
}

}  // namespace isoscope
