// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/section/section_colors.h"

#include <algorithm>
#include <cmath>

#include "widgets/look.h"

namespace isoscope {

namespace {

using Rgb = SectionColors::Rgb;

Rgb toRgb(const QColor& color) {
    return {static_cast<std::uint8_t>(color.red()), static_cast<std::uint8_t>(color.green()),
            static_cast<std::uint8_t>(color.blue())};
}

Rgb mix(const Rgb& a, const Rgb& b, double t) {
    Rgb mixed;
    for (std::size_t i = 0; i < 3; ++i)
        mixed[i] = static_cast<std::uint8_t>(std::lround(a[i] + (b[i] - a[i]) * t));
    return mixed;
}

}  // namespace

SectionColors::SectionColors(const QPalette& palette) {
    const bool dark = lookOf(palette) != Look::light;
    background = toRgb(palette.color(QPalette::Base));
    text = toRgb(palette.color(QPalette::Text));
    outline = mix(background, text, 0.45);
    line = dark ? Rgb{255, 255, 255} : Rgb{16, 18, 22};
    ground_ = mix(background, text, 0.25);
    hatch_ = mix(background, text, 0.45);
    // Blue and orange after Moreland's advice for diverging maps: both ends equally far from the middle in
    // lightness.
    const Rgb inside = dark ? Rgb{58, 134, 236} : Rgb{33, 94, 183};
    const Rgb outside = dark ? Rgb{232, 131, 42} : Rgb{200, 92, 10};
    const Rgb middle = dark ? Rgb{44, 47, 54} : Rgb{244, 244, 242};
    for (int level = 0; level < 256; ++level) {
        const auto one = static_cast<std::uint8_t>(level);
        const Rgb mixed = mix({one, one, one}, background, 0.75);
        for (std::size_t k = 0; k < 3; ++k) faded_[k][static_cast<std::size_t>(level)] = mixed[k];
    }
    for (int i = 0; i < steps; ++i) {
        const double value = 2.0 * i / (steps - 1) - 1;
        // Spreads the middle: what is close to the threshold is what one looks at.
        table_[static_cast<std::size_t>(i)] =
            mix(middle, value < 0 ? inside : outside, std::pow(std::abs(value), 0.7));
    }
}

Rgb SectionColors::color(double value) const {
    if (std::isnan(value)) return ground_;
    const double place = (std::clamp(value, -1.0, 1.0) + 1) / 2 * (steps - 1);
    return table_[static_cast<std::size_t>(place + 0.5)];
}

Rgb SectionColors::faded(const Rgb& color) const {
    return {faded_[0][color[0]], faded_[1][color[1]], faded_[2][color[2]]};
}

Rgb SectionColors::undefined(int column, int row) const { return (column + row) % 8 < 3 ? hatch_ : ground_; }

}  // namespace isoscope
