// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/exchange/frame_sequence.h"

#include <array>
#include <charconv>
#include <cstdint>
#include <fstream>

namespace isoscope {

namespace {

namespace fs = std::filesystem;

bool readWhole(std::string_view text, int& value) {
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    return error == std::errc() && end == text.data() + text.size();
}

/// The four bytes at `at`, the highest first.
int bigEndian(const std::array<char, 24>& bytes, std::size_t at) {
    std::uint32_t value = 0;
    for (std::size_t i = 0; i < 4; ++i) value = value << 8 | static_cast<unsigned char>(bytes[at + i]);
    return static_cast<int>(value);
}

}  // namespace

std::optional<WorkPart> readWorkPart(std::string_view text) {
    const std::size_t slash = text.find('/');
    WorkPart part;
    if (slash == std::string_view::npos || !readWhole(text.substr(0, slash), part.number) ||
        !readWhole(text.substr(slash + 1), part.count))
        return std::nullopt;
    return part.number >= 1 && part.number <= part.count ? std::optional(part) : std::nullopt;
}

double FrameSequence::clock(int frame) const {
    if (last <= first) return firstClock;
    if (frame == last) return finalClock;
    return firstClock + (finalClock - firstClock) * (double(frame) - first) / (double(last) - first);
}

fs::path FrameSequence::file(int frame) const {
    std::string number = std::to_string(frame);
    number.insert(0, std::to_string(last).size() - number.size(), '0');
    return beginning + number + ".png";
}

std::vector<int> FrameSequence::framesOf(const WorkPart& part) const {
    std::vector<int> frames;
    for (long long frame = static_cast<long long>(first) + part.number - 1; frame <= last;
         frame += part.count)
        frames.push_back(static_cast<int>(frame));
    return frames;
}

bool isDrawn(const fs::path& file, int width, int height, const fs::path& scene) {
    std::error_code failed;
    const auto drawn = fs::last_write_time(file, failed);
    if (failed || drawn < fs::last_write_time(scene, failed) || failed) return false;
    // By a clock that was set back since: the scene may have changed at what is earlier now.
    if (drawn > fs::file_time_type::clock::now()) return false;
    // Signature, length and name of the first chunk, then the two sizes.
    std::array<char, 24> head{};
    std::ifstream input(file, std::ios::binary);
    input.read(head.data(), head.size());
    constexpr std::string_view signature = "\x89PNG\r\n\x1a\n";
    constexpr std::size_t widthAt = 16, heightAt = 20;
    return input && std::string_view(head.data(), signature.size()) == signature &&
           bigEndian(head, widthAt) == width && bigEndian(head, heightAt) == height;
}

}  // namespace isoscope
