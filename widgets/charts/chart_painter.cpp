// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/charts/chart_painter.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <QFontMetricsF>
#include <QPainter>
#include <QPolygonF>

namespace isoscope {

namespace {

constexpr double swatchWidth = 18;
constexpr double legendGap = 6;
// In pixels.
constexpr double tickSpacingX = 60;
constexpr double tickSpacingY = 36;
constexpr double upperBorder = 22;
constexpr double rightBorder = 16;
constexpr double tickGap = 5;
constexpr double frameShare = 0.45, gridShare = 0.14;

int ticksAlong(double length, double spacing) { return std::max(2, static_cast<int>(length / spacing)); }

}  // namespace

QColor mixedColor(const QColor& ground, const QColor& ink, double share) {
    const auto mix = [share](int from, int to) {
        return static_cast<int>(std::lround(from + (to - from) * share));
    };
    return {mix(ground.red(), ink.red()), mix(ground.green(), ink.green()), mix(ground.blue(), ink.blue())};
}

void ChartPainter::paint(QPainter& painter, const QRectF& whole, const Chart& chart,
                         const QPalette& palette) {
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    painter.fillRect(whole, palette.color(QPalette::Base));
    const QFontMetricsF metrics(painter.font());
    if (chart.series.isEmpty() || !chart.x.usable() || !chart.y.usable()) {
        painter.setPen(palette.color(QPalette::PlaceholderText));
        painter.drawText(whole, Qt::AlignCenter | Qt::TextWordWrap, chart.empty);
        painter.restore();
        return;
    }
    double labels = 0;
    for (const ChartTick& tick : chartTicks(chart.y, ticksAlong(whole.height(), tickSpacingY)))
        labels = std::max(labels, metrics.horizontalAdvance(tick.label));
    const double line = metrics.height();
    const double left = labels + 2 * tickGap + (chart.y.title.isEmpty() ? 0 : line + tickGap);
    const double below = line + 2 * tickGap + (chart.x.title.isEmpty() ? 0 : line);
    const double above = upperBorder + (chart.title.isEmpty() ? 0 : line);
    const QRectF area = whole.adjusted(left, above, -rightBorder, -below);
    if (!chart.title.isEmpty()) {
        painter.setPen(palette.color(QPalette::Text));
        painter.drawText(QRectF(area.left(), whole.top() + 2, area.width(), line), Qt::AlignLeft,
                         chart.title);
    }
    const ChartPainter parts(chart, area, palette);
    parts.paintAxes(painter);
    painter.save();
    painter.setClipRect(area.adjusted(-1, -1, 1, 1));
    for (const ChartSeries& series : chart.series) parts.paintSeries(painter, series);
    painter.restore();
    parts.paintNotes(painter);
    parts.paintMarks(painter);
    if (chart.legend) parts.paintLegend(painter);
    painter.restore();
}

QPointF ChartPainter::positionOf(const QPointF& values) const {
    const auto share = [](const ChartAxis& axis, double value) {
        return (axis.place(value) - axis.placeLow()) / (axis.placeHigh() - axis.placeLow());
    };
    return {area_.left() + share(chart_.x, values.x()) * area_.width(),
            area_.bottom() - share(chart_.y, values.y()) * area_.height()};
}

void ChartPainter::paintAxes(QPainter& painter) const {
    const QColor ground = palette_.color(QPalette::Base), ink = palette_.color(QPalette::Text);
    const QPen grid(mixedColor(ground, ink, gridShare), 1), frame(mixedColor(ground, ink, frameShare), 1);
    const double line = QFontMetricsF(painter.font()).height();
    const auto share = [](const ChartAxis& axis, double place) {
        return (place - axis.placeLow()) / (axis.placeHigh() - axis.placeLow());
    };
    for (const ChartTick& tick : chartTicks(chart_.x, ticksAlong(area_.width(), tickSpacingX))) {
        const double x = area_.left() + share(chart_.x, tick.place) * area_.width();
        painter.setPen(grid);
        painter.drawLine(QPointF(x, area_.top()), QPointF(x, area_.bottom()));
        painter.setPen(ink);
        painter.drawText(QRectF(x - 60, area_.bottom() + tickGap, 120, line), Qt::AlignHCenter, tick.label);
    }
    const double labelled = area_.left() - tickGap;
    for (const ChartTick& tick : chartTicks(chart_.y, ticksAlong(area_.height(), tickSpacingY))) {
        const double y = area_.bottom() - share(chart_.y, tick.place) * area_.height();
        painter.setPen(grid);
        painter.drawLine(QPointF(area_.left(), y), QPointF(area_.right(), y));
        painter.setPen(ink);
        painter.drawText(QRectF(labelled - 120, y - line / 2, 120, line), Qt::AlignRight, tick.label);
    }
    painter.setPen(frame);
    painter.drawLine(area_.bottomLeft(), area_.bottomRight());
    painter.drawLine(area_.bottomLeft(), area_.topLeft());
    painter.setPen(ink);
    painter.drawText(QRectF(area_.left(), area_.bottom() + tickGap + line, area_.width(), line),
                     Qt::AlignHCenter, chart_.x.title);
    if (chart_.y.title.isEmpty()) return;
    double widest = 0;
    for (const ChartTick& tick : chartTicks(chart_.y, ticksAlong(area_.height(), tickSpacingY)))
        widest = std::max(widest, QFontMetricsF(painter.font()).horizontalAdvance(tick.label));
    painter.save();
    painter.translate(labelled - widest - tickGap - line, area_.bottom());
    painter.rotate(-90);
    painter.drawText(QRectF(0, 0, area_.height(), line), Qt::AlignHCenter, chart_.y.title);
    painter.restore();
}

void ChartPainter::paintSeries(QPainter& painter, const ChartSeries& series) const {
    using Form = ChartSeries::Shape;
    if (series.shape == Form::bars) return paintBars(painter, series);
    const bool marks = series.shape == Form::points || series.shape == Form::linePoints;
    painter.setPen(QPen(series.color, series.width, series.dashed ? Qt::DashLine : Qt::SolidLine,
                        series.shape == Form::segments ? Qt::FlatCap : Qt::RoundCap, Qt::RoundJoin));
    painter.setBrush(Qt::NoBrush);
    QPolygonF run;
    const auto flush = [&] {
        if (run.size() > 1) painter.drawPolyline(run);
        run.clear();
    };
    std::vector<QPointF> shown;
    for (const QPointF& point : series.points) {
        const QPointF at = positionOf(point);
        if (std::isfinite(at.x()) && std::isfinite(at.y())) {
            shown.push_back(at);
            run << at;
        } else if (series.shape == Form::line) {
            flush();  // a gap
        }
        if (series.shape == Form::segments && run.size() == 2) flush();
        if (series.shape == Form::points) run.clear();
    }
    if (series.shape != Form::segments) flush();
    if (!marks) return;
    painter.setPen(Qt::NoPen);
    painter.setBrush(series.color);
    const double radius = (series.shape == Form::points ? series.width : 3 * series.width) / 2;
    for (const QPointF& at : shown) painter.drawEllipse(at, radius, radius);
}

/// Each bar reaches half way to its neighbours.
void ChartPainter::paintBars(QPainter& painter, const ChartSeries& series) const {
    painter.setPen(QPen(palette_.color(QPalette::Base), 1));
    painter.setBrush(series.color);
    const auto& points = series.points;
    for (std::size_t i = 0; i < points.size(); ++i) {
        const QPointF top = positionOf(points[i]);
        const std::size_t other = i > 0 ? i - 1 : std::min(i + 1, points.size() - 1);
        const double half = std::abs(positionOf(points[other]).x() - top.x()) / 2;
        if (!std::isfinite(top.x()) || !std::isfinite(top.y()) || !std::isfinite(half)) continue;
        painter.drawRect(QRectF(QPointF(top.x() - half, top.y()), QPointF(top.x() + half, area_.bottom())));
    }
}

void ChartPainter::paintMarks(QPainter& painter) const {
    const QFontMetricsF metrics(painter.font());
    double row = area_.top() + 2;
    for (const ChartMark& mark : chart_.marks) {
        const double x = positionOf({mark.x, chart_.y.low}).x();
        if (!(x >= area_.left() - 1 && x <= area_.right() + 1)) continue;
        painter.setPen(QPen(mark.color, 1.5, Qt::DashLine));
        painter.drawLine(QPointF(x, area_.top()), QPointF(x, area_.bottom()));
        const double width = metrics.horizontalAdvance(mark.text);
        const bool leftOf = x + width + 6 > area_.right();
        const QRectF box(leftOf ? x - width - 6 : x + 4, row, width + 2, metrics.height());
        painter.fillRect(box, palette_.color(QPalette::Base));
        painter.setPen(mark.color);
        painter.drawText(box, Qt::AlignCenter, mark.text);
        // Marks close to each other would write over each other's texts.
        row += metrics.height();
    }
}

void ChartPainter::paintNotes(QPainter& painter) const {
    const QFontMetricsF metrics(painter.font());
    QColor ground = palette_.color(QPalette::Base);
    ground.setAlpha(215);
    for (const ChartNote& note : chart_.notes) {
        const QPointF at = positionOf(note.at);
        const double top = std::min(at.y(), area_.bottom() - metrics.height());
        const QRectF box(at.x() + tickGap, top, metrics.horizontalAdvance(note.text) + 4, metrics.height());
        painter.fillRect(box, ground);
        painter.setPen(palette_.color(QPalette::Text));
        painter.drawText(box, Qt::AlignCenter, note.text);
    }
}

/// The corner of the area, below the texts of the marks, in which a box of this size hides the fewest points.
QPointF ChartPainter::legendCorner(const QSizeF& size, double line) const {
    constexpr double gap = 4;
    const double top = area_.top() + gap + static_cast<double>(chart_.marks.size()) * line;
    const double right = area_.right() - size.width() - gap, bottom = area_.bottom() - size.height() - gap;
    QPointF best(right, top);
    qsizetype fewest = std::numeric_limits<qsizetype>::max();
    for (const QPointF corner : {QPointF(right, top), QPointF(area_.left() + gap, top),
                                 QPointF(right, bottom), QPointF(area_.left() + gap, bottom)}) {
        const QRectF box(corner, size);
        qsizetype hidden = 0;
        for (const ChartSeries& series : chart_.series)
            for (std::size_t i = 0; i < series.points.size(); ++i) {
                const QPointF point = positionOf(series.points[i]);
                // Lines hide between their points too.
                const QPointF middle = i > 0 ? (point + positionOf(series.points[i - 1])) / 2 : point;
                hidden += box.contains(point) + box.contains(middle);
            }
        if (hidden >= fewest) continue;
        fewest = hidden;
        best = corner;
    }
    return best;
}

void ChartPainter::paintLegend(QPainter& painter) const {
    const QFontMetricsF metrics(painter.font());
    double widest = 0, row = 0;
    QList<ChartSeries> named;
    for (const ChartSeries& series : chart_.series) {
        if (series.name.isEmpty()) continue;
        const double width = metrics.horizontalAdvance(series.name);
        widest = std::max(widest, width);
        row += swatchWidth + 3 * legendGap + width;
        named << series;
    }
    if (named.isEmpty()) return;
    const double line = metrics.height() + 1;
    // In one row above the plot where it fits, else in a corner of it.
    if (row < area_.width() + legendGap) {
        QPointF at(area_.right() - row + legendGap, area_.top() - line - 2);
        for (const ChartSeries& series : named) {
            paintLegendEntry(painter, at, series);
            at.rx() += swatchWidth + 3 * legendGap + metrics.horizontalAdvance(series.name);
        }
        return;
    }
    QColor ground = palette_.color(QPalette::Base);
    ground.setAlpha(215);
    const QSizeF size(widest + swatchWidth + 3 * legendGap,
                      static_cast<double>(named.size()) * line + legendGap);
    const QRectF box(legendCorner(size, metrics.height()), size);
    painter.fillRect(box, ground);
    QPointF at(box.left() + legendGap, box.top() + legendGap / 2);
    for (const ChartSeries& series : named) {
        paintLegendEntry(painter, at, series);
        at.ry() += line;
    }
}

void ChartPainter::paintLegendEntry(QPainter& painter, const QPointF& at, const ChartSeries& series) const {
    const QFontMetricsF metrics(painter.font());
    const QPointF middle(at.x() + swatchWidth / 2, at.y() + (metrics.height() + 1) / 2);
    using Form = ChartSeries::Shape;
    const double width = series.shape == Form::segments ? std::max(1.0, series.width) : 2;
    painter.setPen(QPen(series.color, width, series.dashed ? Qt::DashLine : Qt::SolidLine, Qt::FlatCap));
    painter.setBrush(series.color);
    if (series.shape != Form::points)
        painter.drawLine(middle - QPointF(swatchWidth / 2, 0), middle + QPointF(swatchWidth / 2, 0));
    if (series.shape == Form::points || series.shape == Form::linePoints) {
        painter.setPen(Qt::NoPen);
        painter.drawEllipse(middle, 3, 3);
    }
    painter.setPen(palette_.color(QPalette::Text));
    painter.drawText(QPointF(at.x() + swatchWidth + legendGap, at.y() + metrics.ascent()), series.name);
}

}  // namespace isoscope
