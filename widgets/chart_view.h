// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <optional>
#include <QColor>
#include <QList>
#include <QPointF>

#include "widgets/chart_axis.h"
#include "widgets/vtk_panel.h"

namespace isoscope {

/// One set of points of a chart. What lies outside of the axes, or is not finite, is left out.
struct ChartSeries {
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

struct Chart {
    ChartAxis x, y;
    QList<ChartSeries> series;
    QList<ChartMark> marks;
    bool legend = true;
    QString empty;  ///< shown in the place of a chart without series
};

/// A chart of VTK (vtkChartXY) with linear or logarithmic axes in the colours of the program. Logarithms are
/// taken before VTK sees the points, whose own logarithmic axes show nothing in their first frame.
class ChartView : public VtkPanel {
    Q_OBJECT
  public:
    explicit ChartView(QWidget* parent = nullptr);
    ~ChartView() override;

    void setChart(Chart chart);
    const Chart& chart() const { return chart_; }

    /// The values at a place of the widget; nothing outside of the axes.
    std::optional<QPointF> valueAt(const QPointF& position) const;
    /// Where values lie in the widget; valid after a frame was drawn.
    QPointF positionOf(const QPointF& values) const;

    /// The wheel zooms along x, a drag shifts: rangeRequested() tells the owner, who gives another chart.
    void setZoomable(bool on) { zoomable_ = on; }

  signals:
    /// The mouse was clicked at these values.
    void clicked(QPointF values);
    void hovered(QPointF values);
    void hoverEnded();
    void rangeRequested(double low, double high);
    void wholeRangeRequested();

  protected:
    void paintEvent(QPaintEvent* event) override;
    void changeEvent(QEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void mouseDoubleClickEvent(QMouseEvent* event) override;
    void wheelEvent(QWheelEvent* event) override;
    void enterEvent(QEnterEvent* event) override;
    void leaveEvent(QEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;

  private:
    struct Pipeline;

    void rebuild();
    void addSeries(const ChartSeries& series);
    void setUpAxis(int index, const ChartAxis& axis, int mostTicks);
    /// The rectangle between the axes, in pixels of the widget.
    QRectF plotArea() const;
    void paintMarks(QPainter& painter, const QRectF& area) const;
    QPointF legendCorner(const QRectF& area, const QSizeF& size) const;
    void paintLegend(QPainter& painter, const QRectF& area) const;
    void paintLegendEntry(QPainter& painter, const QPointF& at, const ChartSeries& series) const;

    std::unique_ptr<Pipeline> pipeline_;
    Chart chart_;
    QPointF pressed_, dragged_;
    bool dragging_ = false;
    bool zoomable_ = false;
};

}  // namespace isoscope
