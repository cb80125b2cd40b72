// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/viewport/heat_overlay.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <QCoreApplication>
#include <QLocale>
#include <QPainter>

namespace isoscope {

namespace {

struct Words {
    Q_DECLARE_TR_FUNCTIONS(HeatOverlay)
};

QString countText(std::uint64_t count) { return QLocale::c().toString(static_cast<qulonglong>(count)); }

QString shareText(double share) {
    return std::isfinite(share) ? QString::number(share, 'g', 3) : QStringLiteral("∞");
}

struct Stop {
    double at;
    int red, green, blue;
};
/// Up to 1 after the map "viridis": even in lightness, and readable with every common colour blindness.
constexpr std::array<Stop, 6> stops{{{0, 68, 1, 84},
                                     {0.25, 59, 82, 139},
                                     {0.5, 33, 145, 140},
                                     {0.75, 94, 201, 98},
                                     {0.999, 200, 226, 60},
                                     {1, 253, 231, 37}}};
constexpr Stop justOver{1, 176, 0, 20}, farOver{4, 255, 90, 90};

QColor between(const Stop& a, const Stop& b, double value) {
    const double t = std::clamp((value - a.at) / (b.at - a.at), 0.0, 1.0);
    const auto mix = [t](int from, int to) { return static_cast<int>(std::lround(from + (to - from) * t)); };
    return {mix(a.red, b.red), mix(a.green, b.green), mix(a.blue, b.blue)};
}

}  // namespace

QColor heatColor(double share) {
    if (std::isnan(share)) return {};
    if (share > 1) return between(justOver, farOver, share);
    const double value = std::max(0.0, share);
    std::size_t next = 1;
    while (next + 1 < stops.size() && stops[next].at < value) ++next;
    return between(stops[next - 1], stops[next], value);
}

QImage heatImage(const GradientHeatMap& map) {
    constexpr QRgb veil = qRgba(0, 0, 0, 120);
    QImage image(map.width, map.height, QImage::Format_ARGB32_Premultiplied);
    auto share = map.shares.begin();
    for (int y = 0; y < image.height(); ++y) {
        auto* line = reinterpret_cast<QRgb*>(image.scanLine(y));
        for (int x = 0; x < image.width(); ++x, ++share)
            line[x] = std::isnan(*share) ? qPremultiply(veil) : heatColor(*share).rgb();
    }
    return image;
}

QString heatSummary(const GradientHeatMap& map) {
    if (map.seen == 0) return Words::tr("No isosurface is seen in this view");
    const QString largest = shareText(map.largest);
    if (map.over == 0) return Words::tr("Gradient here: at most %1 of max_gradient").arg(largest);
    return Words::tr("Gradient here: up to %1 times max_gradient, over it in %2 of %3 pixels")
        .arg(largest, countText(map.over), countText(map.seen));
}

QRect paintHeatScale(QPainter& painter, const QRect& area, const GradientHeatMap& map) {
    constexpr int margin = 10, padding = 8, barHeight = 12, barWidth = 200;
    const int line = painter.fontMetrics().height() + 2;
    const int width = std::min(barWidth, area.width() - 2 * (margin + padding));
    const QRect box(area.left() + margin, area.bottom() - margin - 2 * line - barHeight - 2 * padding,
                    width + 2 * padding, 2 * line + barHeight + 2 * padding);
    painter.setPen(Qt::NoPen);
    painter.setBrush(QColor(0x2b, 0x2e, 0x33, 225));
    painter.drawRoundedRect(box, 5, 5);
    painter.setPen(Qt::white);
    const int left = box.left() + padding, top = box.top() + padding;
    painter.drawText(QRect(left, top, width, line), Qt::AlignLeft | Qt::AlignVCenter,
                     Words::tr("|∇f| ÷ max_gradient"));
    // Two thirds for what is allowed, one for what is over.
    const double end = std::clamp(std::isfinite(map.largest) ? map.largest : 4.0, 1.5, 4.0);
    const int atOne = width * 2 / 3;
    for (int x = 0; x < width; ++x) {
        const double share = x <= atOne ? static_cast<double>(x) / atOne
                                        : 1 + (end - 1) * (x - atOne) / std::max(1, width - atOne);
        painter.fillRect(left + x, top + line, 1, barHeight, heatColor(share));
    }
    const QRect labels(left, top + line + barHeight, width, line);
    painter.drawText(labels, Qt::AlignLeft, QStringLiteral("0"));
    painter.drawText(QRect(left + atOne - 20, labels.top(), 40, line), Qt::AlignHCenter, QStringLiteral("1"));
    painter.drawText(labels, Qt::AlignRight,
                     map.largest > end ? Words::tr("over %1").arg(shareText(end)) : shareText(end));
    return area.adjusted(0, 0, 0, box.top() - area.bottom());
}

}  // namespace isoscope
