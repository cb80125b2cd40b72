// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/exchange/sheets/picture_sheet.h"

#include <algorithm>
#include <array>
#include <string_view>

namespace isoscope {

namespace {

constexpr int glyphWidth = 3, glyphHeight = 5, advance = 4;
constexpr int gap = 4;  ///< between pictures
constexpr std::array<float, 3> ground{0.02f, 0.02f, 0.02f}, ink{0.8f, 0.8f, 0.8f};

struct Glyph {
    char character;
    std::array<std::uint8_t, glyphHeight> rows;  ///< three bits each, the left one highest
};

constexpr Glyph glyphs[] = {
    {'0', {7, 5, 5, 5, 7}}, {'1', {2, 6, 2, 2, 7}}, {'2', {7, 1, 7, 4, 7}}, {'3', {7, 1, 7, 1, 7}},
    {'4', {5, 5, 7, 1, 1}}, {'5', {7, 4, 7, 1, 7}}, {'6', {7, 4, 7, 5, 7}}, {'7', {7, 1, 1, 1, 1}},
    {'8', {7, 5, 7, 5, 7}}, {'9', {7, 5, 7, 1, 7}}, {'.', {0, 0, 0, 0, 2}}, {'-', {0, 0, 7, 0, 0}},
    {'+', {0, 2, 7, 2, 0}}, {'e', {0, 7, 7, 4, 7}}, {'=', {0, 7, 0, 7, 0}}, {',', {0, 0, 0, 2, 4}},
};

/// Labels are a tenth of the picture's height.
int scaleFor(int height) { return std::max(1, height / (10 * glyphHeight)); }

int labelHeight(int scale) { return (glyphHeight + 2) * scale; }

}  // namespace

PictureSheet::PictureSheet(int columns, int rows, int width, int height)
    : columns_(columns),
      rows_(rows),
      width_(width),
      height_(height),
      scale_(scaleFor(height)),
      image_(columns * (width + gap) - gap, rows * (height + labelHeight(scaleFor(height)) + gap) - gap) {
    std::ranges::fill(image_.pixels, ground);
}

double PictureSheet::pixels(int columns, int rows, int width, int height) {
    return (columns * (static_cast<double>(width) + gap) - gap) *
           (rows * (static_cast<double>(height) + labelHeight(scaleFor(height)) + gap) - gap);
}

void PictureSheet::put(int column, int row, const Image& picture, const std::string& label) {
    if (column < 0 || column >= columns_ || row < 0 || row >= rows_) return;
    const int left = column * (width_ + gap), top = row * (height_ + labelHeight(scale_) + gap);
    for (int y = 0; y < std::min(height_, picture.height); ++y)
        for (int x = 0; x < std::min(width_, picture.width); ++x)
            image_.pixels[static_cast<std::size_t>(top + y) * static_cast<std::size_t>(image_.width) +
                          static_cast<std::size_t>(left + x)] =
                picture.pixels[static_cast<std::size_t>(y) * static_cast<std::size_t>(picture.width) +
                               static_cast<std::size_t>(x)];
    const int fitting = std::max(1, width_ / (advance * scale_));
    const std::string shown = label.substr(0, static_cast<std::size_t>(fitting));
    const int taken = (advance * static_cast<int>(shown.size()) - 1) * scale_;
    write(left + std::max(0, (width_ - taken) / 2), top + height_ + scale_, shown);
}

std::optional<std::pair<int, int>> PictureSheet::placeAt(int x, int y) const {
    const int across = width_ + gap, down = height_ + labelHeight(scale_) + gap;
    if (x < 0 || y < 0 || x >= image_.width || y >= image_.height) return {};
    if (x % across >= width_ || y % down >= down - gap) return {};
    return std::pair(x / across, y / down);
}

void PictureSheet::write(int left, int top, const std::string& label) {
    for (std::size_t i = 0; i < label.size(); ++i) {
        const auto* glyph =
            std::ranges::find_if(glyphs, [&](const Glyph& one) { return one.character == label[i]; });
        if (glyph == std::end(glyphs)) continue;
        const int start = left + static_cast<int>(i) * advance * scale_;
        for (int y = 0; y < glyphHeight * scale_; ++y)
            for (int x = 0; x < glyphWidth * scale_; ++x) {
                const int bits = glyph->rows[static_cast<std::size_t>(y / scale_)];
                const int px = start + x, py = top + y;
                if (!(bits >> (glyphWidth - 1 - x / scale_) & 1) || px >= image_.width || py >= image_.height)
                    continue;
                image_.pixels[static_cast<std::size_t>(py) * static_cast<std::size_t>(image_.width) +
                              static_cast<std::size_t>(px)] = ink;
            }
    }
}

}  // namespace isoscope
