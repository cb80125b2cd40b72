// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <optional>
#include <QPointF>

#include "widgets/charts/chart.h"
#include "widgets/click_detector.h"
#include "widgets/section/vtk_panel.h"

namespace isoscope {

/// A chart of VTK (vtkChartXY) with linear or logarithmic axes in the colours of the program. Logarithms are
/// taken before VTK sees the points, whose own logarithmic axes show nothing in their first frame.
class ChartView : public VtkPanel {
    Q_OBJECT
  public:
    explicit ChartView(QWidget* parent = nullptr);
    ~ChartView() override;

    /// The chart that is shown; what is set replaces the one before and is drawn with the next frame.
    void setChart(Chart chart);
    const Chart& chart() const { return chart_; }

    /// The values at a place of the widget; nothing outside of the axes.
    std::optional<QPointF> valueAt(const QPointF& position) const;
    /// Where values lie in the widget; valid after a frame was drawn.
    QPointF positionOf(const QPointF& values) const;

    /// A line across the chart over what VTK has drawn, at a value of the horizontal axis, which moving it
    /// does not draw again; nothing for none. It stays with another chart.
    void setCursorLine(std::optional<double> x);
    const std::optional<double>& cursorLine() const { return cursorLine_; }
    /// The chart takes the focus, and arrow keys emit hovered() for values beside the line, with Shift nearer
    /// ones, Home and End for the ends of the axis, Escape hoverEnded().
    void setProbing(bool on);

    /// The wheel zooms along x, a drag shifts: rangeRequested() tells the owner, who gives another chart.
    void setZoomable(bool on) { zoomable_ = on; }
    /// The chart is a slider along x: presses and drags emit dragged(), and no click.
    void setDraggable(bool on) { draggable_ = on; }
    bool isDragged() const { return dragging_; }

  signals:
    /// The mouse was clicked at these values.
    void clicked(QPointF values);
    /// The mouse is held at these values, or nearest to them where it has left the axes ...
    void dragged(QPointF values);
    /// ... and is let go.
    void dragEnded();
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
    void keyPressEvent(QKeyEvent* event) override;
    void focusOutEvent(QFocusEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;

  private:
    struct Pipeline;

    void rebuild();
    void drag(const QPointF& position);
    void paintCursorLine(QPainter& painter, const QRectF& area) const;
    void addSeries(const ChartSeries& series);
    void setUpAxis(int index, const ChartAxis& axis, int mostTicks);
    /// The rectangle between the axes, in pixels of the widget.
    QRectF plotArea() const;

    std::unique_ptr<Pipeline> pipeline_;
    Chart chart_;
    ClickDetector clicks_;
    QPointF dragged_;  ///< the mouse, as far as the range has followed it
    bool zoomable_ = false;
    std::optional<double> cursorLine_;
    bool probing_ = false;
    bool draggable_ = false;
    bool dragging_ = false;
};

}  // namespace isoscope
