// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/viewport/hole_overlay.h"

#include <array>
#include <QCoreApplication>
#include <QLocale>

namespace isoscope {

namespace {

constexpr std::array kinds{HolePixel::background, HolePixel::right, HolePixel::lost, HolePixel::gained,
                           HolePixel::wrongPlace};

struct Words {
    Q_DECLARE_TR_FUNCTIONS(HoleOverlay)
};

QString countText(std::uint64_t count) { return QLocale::c().toString(static_cast<qulonglong>(count)); }

QRgb pixelColor(HolePixel pixel, HoleStyle style) {
    if (const QColor color = holeColor(pixel); color.isValid()) return color.rgba();
    if (style == HoleStyle::marks) return qRgba(0, 0, 0, 120);
    return pixel == HolePixel::right ? qRgb(0x50, 0x52, 0x56) : qRgb(0, 0, 0);
}

}  // namespace

QColor holeColor(HolePixel pixel) {
    // Told apart by brightness too, for those who do not see the hues.
    switch (pixel) {
        case HolePixel::lost: return QColor(0xe5, 0x1c, 0x23);
        case HolePixel::gained: return QColor(0x3f, 0xa9, 0xff);
        case HolePixel::wrongPlace: return QColor(0xff, 0xe0, 0x5c);
        default: return {};
    }
}

QImage holeImage(const HoleMap& map, HoleStyle style) {
    QImage image(map.width, map.height, QImage::Format_ARGB32_Premultiplied);
    std::array<QRgb, kinds.size()> colors{};
    for (const HolePixel kind : kinds)
        colors[static_cast<std::size_t>(kind)] = qPremultiply(pixelColor(kind, style));
    auto pixel = map.pixels.begin();
    for (int y = 0; y < image.height(); ++y) {
        auto* line = reinterpret_cast<QRgb*>(image.scanLine(y));
        for (int x = 0; x < image.width(); ++x) line[x] = colors[static_cast<std::size_t>(*pixel++)];
    }
    return image;
}

QString holeSummary(const HoleMap& map) {
    if (map.mistakes() == 0)
        return Words::tr("POV-Ray's method loses none of %1 pixels").arg(countText(map.pixels.size()));
    return Words::tr("POV-Ray's method: %1 lost, %2 gained, %3 at a wrong place")
        .arg(countText(map.count(HolePixel::lost)), countText(map.count(HolePixel::gained)),
             countText(map.count(HolePixel::wrongPlace)));
}

QList<LegendEntry> holeLegend(const HoleMap& map) {
    const auto entry = [&](HolePixel kind, const QString& text) {
        return LegendEntry{holeColor(kind), text.arg(countText(map.count(kind)))};
    };
    return {entry(HolePixel::lost, Words::tr("lost: a hole in POV-Ray's picture (%1)")),
            entry(HolePixel::gained, Words::tr("gained: POV-Ray hits where nothing is (%1)")),
            entry(HolePixel::wrongPlace,
                  Words::tr("wrong place: another sheet, or off by more than accuracy explains (%1)"))};
}

}  // namespace isoscope
