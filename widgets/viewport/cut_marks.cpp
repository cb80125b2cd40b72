// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/viewport/cut_marks.h"

#include <algorithm>
#include <cmath>

#include "core/render/verdict_map.h"

namespace isoscope {

namespace {

/// Most of what is around the pixel is cut, too: hatching of slivers would look like dirt on the surface.
bool insideCut(const VerdictMap& map, int x, int y) {
    constexpr int most = 5;
    int count = 0;
    for (int dy = -1; dy <= 1; ++dy)
        for (int dx = -1; dx <= 1; ++dx) count += map.wall(x + dx, y + dy);
    return count >= most;
}

}  // namespace

QImage cutImage(const VerdictMap& map, double ratio) {
    if (!map.hasWalls()) return {};
    // A light line beside a dark one is seen on every colour, and changes none in the mean.
    constexpr QRgb light = qRgba(255, 255, 255, 90), dark = qRgba(0, 0, 0, 90);
    const int apart = std::max(4, static_cast<int>(std::lround(9 * ratio)));
    const int thick = std::max(1, static_cast<int>(std::lround(ratio)));
    QImage image(map.width(), map.height(), QImage::Format_ARGB32_Premultiplied);
    image.fill(Qt::transparent);
    for (int y = 0; y < image.height(); ++y) {
        auto* line = reinterpret_cast<QRgb*>(image.scanLine(y));
        // Along the lines alone: a picture that plays has these marks sixty times a second.
        for (int first = -(y % apart); first < image.width(); first += apart)
            for (int k = 0; k < 2 * thick; ++k) {
                const int x = first + k;
                if (x < image.width() && map.wall(x, y) && insideCut(map, x, y))
                    line[x] = qPremultiply(k < thick ? light : dark);
            }
    }
    return image;
}

}  // namespace isoscope
