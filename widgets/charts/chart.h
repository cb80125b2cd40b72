// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QColor>
#include <QList>
#include <QPointF>
#include <QString>
#include <vector>

#include "widgets/charts/chart_axis.h"

namespace isoscope {

/// One set of points of a chart. What lies outside of the axes, or is not finite, is left out.
struct ChartSeries {
    /// How the points are drawn.
    enum class Shape {
        line,        ///< from point to point, in order
        linePoints,  ///< the same with a mark at each point
        points,      ///< marks alone
        segments,    ///< from each even point to the next odd one
        bars,        ///< a bar on each point
    };
    QString name;  ///< for the legend; empty ones are not in it
    QColor color;
    Shape shape = Shape::line;
    std::vector<QPointF> points;  ///< values, not logarithms
    double width = 2;             ///< of lines, in pixels; of marks in points
    bool dashed = false;
};

/// A vertical line with a text at its upper end.
struct ChartMark {
    double x = 0;
    QString text;
    QColor color;
};

/// A text beside a point, at its right.
struct ChartNote {
    QPointF at;
    QString text;
};

/// What a ChartView shows: two axes, and over them series, vertical marks and notes.
struct Chart {
    ChartAxis x, y;
    QList<ChartSeries> series;
    QList<ChartMark> marks;
    QList<ChartNote> notes;
    bool legend = true;
    QString title;  ///< of files that the chart is saved in
    QString empty;  ///< shown in the place of a chart without series
};

}  // namespace isoscope
