// SPDX-License-Identifier: GPL-3.0-or-later
#include <cctype>

#include "core/image/raster_file.h"

namespace isoscope {

namespace {

class NetpbmReader {
  public:
    explicit NetpbmReader(std::span<const std::uint8_t> bytes) : bytes_(bytes) {}

    /// A number of the header or of a plain image, comments before it skipped; -1 when there is none.
    int number() {
        for (; at_ < bytes_.size(); ++at_) {
            if (bytes_[at_] == '#')
                while (at_ + 1 < bytes_.size() && bytes_[at_] != '\n') ++at_;
            else if (!std::isspace(bytes_[at_]))
                break;
        }
        if (at_ >= bytes_.size() || !std::isdigit(bytes_[at_])) return -1;
        int value = 0;
        for (; at_ < bytes_.size() && std::isdigit(bytes_[at_]) && value < 100'000'000; ++at_)
            value = value * 10 + (bytes_[at_] - '0');
        return value;
    }
    int raw(bool wide) {
        const std::size_t count = wide ? 2 : 1;
        if (at_ + count > bytes_.size()) return -1;
        int value = bytes_[at_++];
        if (wide) value = value << 8 | bytes_[at_++];
        return value;
    }
    void skip(std::size_t count) { at_ += count; }

  private:
    std::span<const std::uint8_t> bytes_;
    std::size_t at_ = 0;
};

}  // namespace

std::optional<Raster> decodeNetpbm(std::span<const std::uint8_t> bytes) {
    if (bytes.size() < 2 || bytes[0] != 'P') return std::nullopt;
    const char kind = static_cast<char>(bytes[1]);
    const bool plain = kind == '2' || kind == '3';
    Raster raster;
    raster.channels = kind == '3' || kind == '6' ? 3 : 1;
    NetpbmReader input(bytes);
    input.skip(2);
    raster.width = input.number();
    raster.height = input.number();
    raster.largest = input.number();
    if (raster.width < 1 || raster.height < 1 || raster.largest < 1 || raster.largest > 65535)
        return std::nullopt;
    const std::size_t count = static_cast<std::size_t>(raster.width) *
                              static_cast<std::size_t>(raster.height) *
                              static_cast<std::size_t>(raster.channels);
    // Not more samples than bytes, whatever the header claims.
    if (count > rasterSampleLimit || count > bytes.size()) return std::nullopt;
    if (!plain) input.skip(1);
    raster.samples.resize(count);
    for (std::uint16_t& sample : raster.samples) {
        const int value = plain ? input.number() : input.raw(raster.largest > 255);
        if (value < 0 || value > raster.largest) return std::nullopt;
        sample = static_cast<std::uint16_t>(value);
    }
    return raster;
}

}  // namespace isoscope
