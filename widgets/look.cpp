// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/look.h"

#include <algorithm>
#include <cmath>
#include <QPalette>

namespace isoscope {
namespace {

/// The lightest ground that text has in high contrast: that of the caret's line.
constexpr QRgb lightestGround = 0xff1a1a1a;

/// Relative luminance of sRGB, WCAG 2.1.
double luminance(const QColor& color) {
    const auto linear = [](double part) {
        return part <= 0.04045 ? part / 12.92 : std::pow((part + 0.055) / 1.055, 2.4);
    };
    return 0.2126 * linear(color.redF()) + 0.7152 * linear(color.greenF()) + 0.0722 * linear(color.blueF());
}

QColor mixed(const QColor& a, const QColor& b, double share) {
    const auto part = [share](int from, int to) {
        return static_cast<int>(std::lround(from + share * (to - from)));
    };
    return {part(a.red(), b.red()), part(a.green(), b.green()), part(a.blue(), b.blue())};
}

}  // namespace

Look lookOf(const QPalette& palette) {
    const QColor ground = palette.color(QPalette::Base);
    if (ground == QColor(Qt::black)) return Look::highContrast;
    return ground.lightness() < 128 ? Look::dark : Look::light;
}

QColor lookColor(Look look, QRgb light, QRgb dark) {
    if (look == Look::light) return QColor::fromRgb(light);
    const QColor color = QColor::fromRgb(dark);
    return look == Look::dark ? color : legible(color, QColor::fromRgb(lightestGround), highContrastRatio);
}

double contrastRatio(const QColor& a, const QColor& b) {
    const auto [darker, lighter] = std::minmax({luminance(a), luminance(b)});
    return (lighter + 0.05) / (darker + 0.05);
}

QColor legible(const QColor& color, const QColor& ground, double ratio) {
    const QColor white(Qt::white), black(Qt::black);
    const QColor goal = contrastRatio(white, ground) >= contrastRatio(black, ground) ? white : black;
    constexpr int steps = 64;
    for (int step = 0; step < steps; ++step) {
        const QColor tried = mixed(color, goal, static_cast<double>(step) / steps);
        if (contrastRatio(tried, ground) >= ratio) return tried;
    }
    return goal;
}

}  // namespace isoscope
