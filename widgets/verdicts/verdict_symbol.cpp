// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/verdicts/verdict_symbol.h"

#include <cmath>
#include <QPainter>
#include <QPainterPath>

namespace isoscope {

namespace {

/// In a square from -1 to 1, as lines.
QPainterPath signOf(std::optional<GradientVerdict> verdict) {
    QPainterPath path;
    const auto line = [&path](std::initializer_list<QPointF> points) {
        path.moveTo(*points.begin());
        for (const QPointF& point : points) path.lineTo(point);
    };
    if (!verdict) {
        for (const double x : {-0.45, 0.0, 0.45}) line({{x, 0.0}, {x + 0.01, 0.0}});
        return path;
    }
    switch (*verdict) {
        case GradientVerdict::right: line({{-0.45, 0.05}, {-0.1, 0.4}, {0.5, -0.35}}); break;
        case GradientVerdict::holes: line({{0, -0.55}, {0, 0.12}}), line({{0, 0.52}, {0.01, 0.52}}); break;
        case GradientVerdict::wasteful:  // a clock
            line({{0, -0.5}, {0, 0.05}, {0.4, 0.3}});
            break;
        case GradientVerdict::unbounded:  // an arrow without end
            line({{0, 0.55}, {0, -0.55}}), line({{-0.35, -0.15}, {0, -0.55}, {0.35, -0.15}});
            break;
        case GradientVerdict::unproven:
            path.moveTo(-0.32, -0.25);
            path.cubicTo({-0.3, -0.75}, {0.45, -0.65}, {0.3, -0.15});
            path.quadTo({0, 0.0}, {0, 0.22});
            line({{0, 0.58}, {0.01, 0.58}});
            break;
    }
    return path;
}

}  // namespace

namespace {

QColor usualColor(std::optional<GradientVerdict> verdict, bool dark) {
    if (!verdict) return dark ? QColor(0x7d, 0x85, 0x90) : QColor(0x6b, 0x72, 0x7c);
    switch (*verdict) {
        case GradientVerdict::right: return dark ? QColor(0x2e, 0x9e, 0x5b) : QColor(0x1a, 0x7f, 0x45);
        case GradientVerdict::holes: return QColor(0xc6, 0x28, 0x28);
        case GradientVerdict::wasteful: return QColor(0x1d, 0x6f, 0xd0);
        case GradientVerdict::unbounded: return QColor(0x8e, 0x24, 0xaa);
        case GradientVerdict::unproven: return QColor(0xa8, 0x5f, 0x00);
    }
    return {};
}

}  // namespace

QColor verdictSymbolColor(std::optional<GradientVerdict> verdict, Look look) {
    const QColor usual = usualColor(verdict, look != Look::light);
    return look == Look::highContrast ? legible(usual, Qt::black, highContrastRatio) : usual;
}

QImage verdictSymbol(std::optional<GradientVerdict> verdict, int size, double pixelRatio, Look look) {
    const int pixels = static_cast<int>(std::ceil(size * pixelRatio));
    QImage image(pixels, pixels, QImage::Format_ARGB32);
    image.fill(Qt::transparent);
    QPainter painter(&image);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.translate(pixels / 2.0, pixels / 2.0);
    painter.scale(pixels / 2.0 - 0.5, pixels / 2.0 - 0.5);
    painter.setPen(Qt::NoPen);
    painter.setBrush(verdictSymbolColor(verdict, look));
    painter.drawEllipse(QPointF(0, 0), 1, 1);
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen(look == Look::highContrast ? Qt::black : Qt::white, 0.26, Qt::SolidLine, Qt::RoundCap,
                        Qt::RoundJoin));
    painter.drawPath(signOf(verdict));
    painter.end();
    image.setDevicePixelRatio(pixelRatio);
    return image;
}

QIcon verdictIcon(std::optional<GradientVerdict> verdict, Look look) {
    QIcon icon;
    // The larger one is for larger interfaces: icons are made smaller, never larger.
    for (const int size : {16, 32})
        for (const double ratio : {1.0, 2.0})
            icon.addPixmap(QPixmap::fromImage(verdictSymbol(verdict, size, ratio, look)));
    return icon;
}

}  // namespace isoscope
