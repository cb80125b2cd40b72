// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QPalette>
#include <QRectF>

#include "widgets/charts/chart.h"

class QPainter;

namespace isoscope {

/// Draws a chart, or the parts of it that VTK leaves to us, with a QPainter; `area` is the rectangle between
/// the axes.
class ChartPainter {
  public:
    /// `chart` outlives the painter.
    ChartPainter(const Chart& chart, const QRectF& area, const QPalette& palette)
        : chart_(chart), area_(area), palette_(palette) {}

    /// A whole chart with room for axes, their texts and the title, in the font of `painter`.
    static void paint(QPainter& painter, const QRectF& whole, const Chart& chart, const QPalette& palette);

    /// Where values lie.
    QPointF positionOf(const QPointF& values) const;
    void paintMarks(QPainter& painter) const;
    void paintNotes(QPainter& painter) const;
    void paintLegend(QPainter& painter) const;

  private:
    void paintAxes(QPainter& painter) const;
    void paintSeries(QPainter& painter, const ChartSeries& series) const;
    void paintBars(QPainter& painter, const ChartSeries& series) const;
    QPointF legendCorner(const QSizeF& size, double line) const;
    void paintLegendEntry(QPainter& painter, const QPointF& at, const ChartSeries& series) const;

    const Chart& chart_;
    QRectF area_;
    QPalette palette_;
};

/// The colour of a chart's frame and grid: `share` of the text's in the ground's.
QColor mixedColor(const QColor& ground, const QColor& ink, double share);

}  // namespace isoscope
