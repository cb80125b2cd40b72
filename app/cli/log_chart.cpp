// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/log_chart.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace isoscope::cli {

namespace {

using Color = std::array<float, 3>;
constexpr Color white{1, 1, 1}, grid{0.75f, 0.75f, 0.78f}, ink{0.1f, 0.1f, 0.1f};
constexpr int margin = 44;

/// Digits and what else "1e-9" needs, 3 by 5, one bit a pixel, rows from the top.
std::uint16_t glyph(char letter) {
    switch (letter) {
        case '0': return 0b111'101'101'101'111;
        case '1': return 0b010'110'010'010'111;
        case '2': return 0b111'001'111'100'111;
        case '3': return 0b111'001'111'001'111;
        case '4': return 0b101'101'111'001'001;
        case '5': return 0b111'100'111'001'111;
        case '6': return 0b111'100'111'101'111;
        case '7': return 0b111'001'010'010'010;
        case '8': return 0b111'101'111'101'111;
        case '9': return 0b111'101'111'001'111;
        case 'e': return 0b000'111'111'100'111;
        case '-': return 0b000'000'111'000'000;
        default: return 0;
    }
}

class Canvas {
  public:
    Canvas(int width, int height) : image_(width, height) {
        std::fill(image_.pixels.begin(), image_.pixels.end(), white);
    }

    void set(int x, int y, const Color& color) {
        if (x < 0 || y < 0 || x >= image_.width || y >= image_.height) return;
        image_.pixels[static_cast<std::size_t>(y) * static_cast<std::size_t>(image_.width) +
                      static_cast<std::size_t>(x)] = color;
    }
    void line(double x0, double y0, double x1, double y1, int thickness, const Color& color) {
        const int steps = static_cast<int>(std::ceil(std::max(std::abs(x1 - x0), std::abs(y1 - y0)))) + 1;
        for (int k = 0; k <= steps; ++k) {
            const double s = static_cast<double>(k) / steps;
            const int x = static_cast<int>(std::lround(x0 + s * (x1 - x0))),
                      y = static_cast<int>(std::lround(y0 + s * (y1 - y0)));
            for (int dx = 0; dx < thickness; ++dx)
                for (int dy = 0; dy < thickness; ++dy) set(x + dx, y + dy, color);
        }
    }
    void text(int x, int y, const std::string& letters) {
        constexpr int size = 2;
        for (const char letter : letters) {
            const std::uint16_t bits = glyph(letter);
            for (int row = 0; row < 5 * size; ++row)
                for (int column = 0; column < 3 * size; ++column)
                    if ((bits >> (14 - (row / size * 3 + column / size)) & 1) != 0)
                        set(x + column, y + row, ink);
            x += 4 * size;
        }
    }
    Image take() { return std::move(image_); }

  private:
    Image image_;
};

/// One axis: whole decades.
struct Axis {
    int low = 0, high = 1;

    static Axis around(const std::vector<ChartLine>& lines, std::size_t index) {
        double least = INFINITY, most = -INFINITY;
        for (const ChartLine& line : lines)
            for (const auto& point : line.points) {
                if (!(point[index] > 0)) continue;
                least = std::min(least, std::log10(point[index]));
                most = std::max(most, std::log10(point[index]));
            }
        if (!(least <= most)) return {};
        Axis axis{static_cast<int>(std::floor(least)), static_cast<int>(std::ceil(most))};
        if (axis.high == axis.low) ++axis.high;
        return axis;
    }
    double place(double value) const { return (std::log10(value) - low) / (high - low); }
};

}  // namespace

Image drawLogChart(const std::vector<ChartLine>& lines, int width, int height) {
    Canvas canvas(width, height);
    const Axis horizontal = Axis::around(lines, 0), vertical = Axis::around(lines, 1);
    const int right = width - 12, bottom = height - 28, top = 12;
    const auto x = [&](double value) { return margin + horizontal.place(value) * (right - margin); };
    const auto y = [&](double value) { return bottom - vertical.place(value) * (bottom - top); };
    for (int decade = horizontal.low; decade <= horizontal.high; ++decade) {
        const double at = x(std::pow(10, decade));
        canvas.line(at, top, at, bottom, 1, grid);
        canvas.text(static_cast<int>(at) - 12, bottom + 8, "1e" + std::to_string(decade));
    }
    for (int decade = vertical.low; decade <= vertical.high; ++decade) {
        const double at = y(std::pow(10, decade));
        canvas.line(margin, at, right, at, 1, grid);
        canvas.text(4, static_cast<int>(at) - 5, "1e" + std::to_string(decade));
    }
    for (const ChartLine& line : lines) {
        const std::array<double, 2>* before = nullptr;
        for (const auto& point : line.points) {
            if (!(point[0] > 0) || !(point[1] > 0)) continue;
            if (before)
                canvas.line(x((*before)[0]), y((*before)[1]), x(point[0]), y(point[1]), 2, line.color);
            canvas.line(x(point[0]) - 2, y(point[1]) - 2, x(point[0]) - 2, y(point[1]) - 2, 5, line.color);
            before = &point;
        }
    }
    return canvas.take();
}

}  // namespace isoscope::cli
