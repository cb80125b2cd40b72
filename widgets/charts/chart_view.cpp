// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/charts/chart_view.h"

#include <vtkAxis.h>
#include <vtkBrush.h>
#include <vtkChartXY.h>
#include <vtkContextActor.h>
#include <vtkContextScene.h>
#include <vtkDoubleArray.h>
#include <vtkFloatArray.h>
#include <vtkGenericOpenGLRenderWindow.h>
#include <vtkNew.h>
#include <vtkPen.h>
#include <vtkPlotBar.h>
#include <vtkPlotLine.h>
#include <vtkPlotPoints.h>
#include <vtkRenderer.h>
#include <vtkStringArray.h>
#include <vtkTable.h>
#include <vtkTextProperty.h>
#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <QEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QWheelEvent>

#include "widgets/charts/chart_painter.h"
#include "widgets/linked_probe.h"

namespace isoscope {

namespace {

constexpr int labelSize = 11;
constexpr double zoomPerStep = 1.25;
constexpr double wheelStep = 120;
// In pixels.
constexpr double tickSpacingX = 52;
constexpr double tickSpacingY = 30;
constexpr int upperBorder = 20;  ///< above and right of the plot; the legend stands there
constexpr double probeSteps = 100, fineProbeSteps = 1000;  ///< of keys, along the axis
constexpr double gridShare = 0.14;                         ///< of the text's colour in the grid's

void setColor(vtkPen* pen, const QColor& c) {
    pen->SetColor(static_cast<unsigned char>(c.red()), static_cast<unsigned char>(c.green()),
                  static_cast<unsigned char>(c.blue()), static_cast<unsigned char>(c.alpha()));
}

}  // namespace

struct ChartView::Pipeline {
    vtkNew<vtkRenderer> renderer;
    vtkNew<vtkContextActor> actor;
    vtkNew<vtkChartXY> chart;
};

ChartView::ChartView(QWidget* parent) : VtkPanel(parent), pipeline_(std::make_unique<Pipeline>()) {
    Pipeline& p = *pipeline_;
    p.chart->SetInteractive(false);
    p.chart->SetRenderEmpty(true);
    p.actor->GetScene()->AddItem(p.chart);
    p.actor->GetScene()->SetRenderer(p.renderer);
    p.renderer->AddActor(p.actor);
    renderWindow()->AddRenderer(p.renderer);
    rebuild();
}

ChartView::~ChartView() { renderWindow()->RemoveRenderer(pipeline_->renderer); }

void ChartView::setChart(Chart chart) {
    // Panels without anything to show follow every step of a slider too.
    if (chart.series.isEmpty() && chart_.series.isEmpty() && chart.empty == chart_.empty) return;
    chart_ = std::move(chart);
    rebuild();
}

void ChartView::rebuild() {
    Pipeline& p = *pipeline_;
    const QColor ground = palette().color(QPalette::Base);
    p.renderer->SetBackground(ground.redF(), ground.greenF(), ground.blueF());
    p.chart->ClearPlots();
    const bool any = !chart_.series.isEmpty() && chart_.x.usable() && chart_.y.usable();
    p.chart->SetVisible(any);
    p.chart->SetHiddenAxisBorder(static_cast<int>(upperBorder * devicePixelRatioF()));
    if (any) {
        setUpAxis(vtkAxis::BOTTOM, chart_.x, std::max(2, static_cast<int>(width() / tickSpacingX)));
        setUpAxis(vtkAxis::LEFT, chart_.y, std::max(2, static_cast<int>(height() / tickSpacingY)));
        for (const ChartSeries& series : chart_.series) addSeries(series);
    }
    refresh();
}

void ChartView::setUpAxis(int index, const ChartAxis& axis, int mostTicks) {
    vtkAxis* drawn = pipeline_->chart->GetAxis(index);
    const QColor ground = palette().color(QPalette::Base), ink = palette().color(QPalette::Text);
    const auto ratio = static_cast<float>(devicePixelRatioF());
    for (vtkTextProperty* text : {drawn->GetLabelProperties(), drawn->GetTitleProperties()}) {
        useApplicationFont(text);
        text->SetColor(ink.redF(), ink.greenF(), ink.blueF());
        text->SetFontSize(labelSize);
        text->BoldOff();
        text->ItalicOff();
    }
    setColor(drawn->GetPen(), mixedColor(ground, ink, 0.45));
    drawn->GetPen()->SetWidth(ratio);
    setColor(drawn->GetGridPen(), mixedColor(ground, ink, gridShare));
    drawn->GetGridPen()->SetWidth(ratio);
    drawn->SetTitle(axis.title.toUtf8().toStdString());
    drawn->SetBehavior(vtkAxis::FIXED);
    drawn->SetRange(axis.placeLow(), axis.placeHigh());
    vtkNew<vtkDoubleArray> places;
    vtkNew<vtkStringArray> labels;
    for (const ChartTick& tick : chartTicks(axis, mostTicks)) {
        places->InsertNextValue(tick.place);
        labels->InsertNextValue(tick.label.toUtf8().toStdString());
    }
    drawn->SetCustomTickPositions(places, labels);
}

void ChartView::addSeries(const ChartSeries& series) {
    vtkNew<vtkDoubleArray> x, y;
    x->SetName("x");
    y->SetName("y");
    for (const QPointF& point : series.points) {
        const double px = chart_.x.place(point.x()), py = chart_.y.place(point.y());
        const bool drawable = std::isfinite(px) && std::isfinite(py);
        // A gap in a line; its other shapes have no use for the point.
        if (!drawable && series.shape != ChartSeries::Shape::line) continue;
        x->InsertNextValue(drawable ? px : std::nan(""));
        y->InsertNextValue(drawable ? py : std::nan(""));
    }
    using Form = ChartSeries::Shape;
    const bool marked = series.shape == Form::linePoints || series.shape == Form::points;
    const vtkIdType count = x->GetNumberOfTuples();
    // VTK complains about lines of one point.
    if (count < (marked || series.shape == Form::bars ? 1 : 2)) return;
    vtkNew<vtkTable> table;
    table->AddColumn(x);
    table->AddColumn(y);
    const int kind = series.shape == Form::bars                   ? vtkChart::BAR
                     : series.shape == Form::points || count == 1 ? vtkChart::POINTS
                                                                  : vtkChart::LINE;
    vtkPlot* plot = pipeline_->chart->AddPlot(kind);
    plot->SetInputData(table, 0, 1);
    setColor(plot->GetPen(), series.color);
    const double ratio = devicePixelRatioF();  // VTK's line widths are in device pixels
    plot->SetWidth(static_cast<float>(series.width * ratio));
    if (series.dashed) plot->GetPen()->SetLineType(vtkPen::DASH_LINE);
    if (auto* line = vtkPlotLine::SafeDownCast(plot)) line->SetPolyLine(series.shape != Form::segments);
    if (auto* points = vtkPlotPoints::SafeDownCast(plot)) {
        points->SetMarkerStyle(marked ? vtkPlotPoints::CIRCLE : vtkPlotPoints::NONE);
        const double size = series.shape == Form::points ? series.width : 3 * series.width;
        points->SetMarkerSize(static_cast<float>(size * ratio));
    }
    if (auto* bars = vtkPlotBar::SafeDownCast(plot)) {
        bars->SetColor(series.color.redF(), series.color.greenF(), series.color.blueF());
        setColor(bars->GetPen(), palette().color(QPalette::Base));
        bars->SetWidth(static_cast<float>(ratio));
    }
}

QRectF ChartView::plotArea() const {
    vtkAxis* across = pipeline_->chart->GetAxis(vtkAxis::BOTTOM);
    vtkAxis* up = pipeline_->chart->GetAxis(vtkAxis::LEFT);
    const double ratio = devicePixelRatioF();
    const double left = across->GetPoint1()[0] / ratio, right = across->GetPoint2()[0] / ratio;
    const double bottom = up->GetPoint1()[1] / ratio, top = up->GetPoint2()[1] / ratio;
    return {QPointF(left, height() - top), QPointF(right, height() - bottom)};
}

QPointF ChartView::positionOf(const QPointF& values) const {
    return ChartPainter(chart_, plotArea(), palette()).positionOf(values);
}

std::optional<QPointF> ChartView::valueAt(const QPointF& position) const {
    const QRectF area = plotArea();
    if (chart_.series.isEmpty() || !area.contains(position)) return {};
    const auto value = [](const ChartAxis& axis, double share) {
        return axis.value(axis.placeLow() + share * (axis.placeHigh() - axis.placeLow()));
    };
    return QPointF(value(chart_.x, (position.x() - area.left()) / area.width()),
                   value(chart_.y, (area.bottom() - position.y()) / area.height()));
}

void ChartView::paintEvent(QPaintEvent* event) {
    VtkPanel::paintEvent(event);
    if (frame().isNull()) return;
    QPainter painter(this);
    if (chart_.series.isEmpty()) {
        painter.setPen(palette().color(QPalette::PlaceholderText));
        painter.drawText(rect().adjusted(16, 8, -16, -8), Qt::AlignCenter | Qt::TextWordWrap, chart_.empty);
        return;
    }
    QFont small = font();
    small.setPointSizeF(std::max(7.0, small.pointSizeF() * 0.85));
    painter.setFont(small);
    painter.setRenderHint(QPainter::Antialiasing);
    const QRectF area = plotArea();
    const ChartPainter parts(chart_, area, palette());
    parts.paintNotes(painter);
    parts.paintMarks(painter);
    if (chart_.legend) parts.paintLegend(painter);
    paintCursorLine(painter, area);
}

void ChartView::paintCursorLine(QPainter& painter, const QRectF& area) const {
    if (probing_ && hasFocus()) {
        painter.setBrush(Qt::NoBrush);
        painter.setPen(QPen(palette().highlight(), 1));
        painter.drawRect(QRectF(rect()).adjusted(0.5, 0.5, -0.5, -0.5));
    }
    if (!cursorLine_ || !(*cursorLine_ >= chart_.x.low && *cursorLine_ <= chart_.x.high)) return;
    const double x = positionOf({*cursorLine_, chart_.y.low}).x();
    painter.setPen(QPen(probeColor(palette()), 1.5));
    painter.drawLine(QPointF(x, area.top()), QPointF(x, area.bottom()));
}

void ChartView::setCursorLine(std::optional<double> x) {
    if (x == cursorLine_) return;
    cursorLine_ = x;
    update();
}

void ChartView::setProbing(bool on) {
    probing_ = on;
    setFocusPolicy(on ? Qt::StrongFocus : Qt::NoFocus);
}

void ChartView::keyPressEvent(QKeyEvent* event) {
    const int side = event->key() == Qt::Key_Right ? 1 : event->key() == Qt::Key_Left ? -1 : 0;
    const bool toEnd = event->key() == Qt::Key_Home || event->key() == Qt::Key_End;
    if (!probing_ || chart_.series.isEmpty() ||
        (event->modifiers() & ~Qt::ShiftModifier & ~Qt::KeypadModifier))
        return VtkPanel::keyPressEvent(event);
    if (event->key() == Qt::Key_Escape && cursorLine_) return emit hoverEnded();
    if (side == 0 && !toEnd) return VtkPanel::keyPressEvent(event);
    const double low = chart_.x.low, high = chart_.x.high;
    const double step = (high - low) / (event->modifiers() & Qt::ShiftModifier ? fineProbeSteps : probeSteps);
    const double next = toEnd         ? (event->key() == Qt::Key_Home ? low : high)
                        : cursorLine_ ? *cursorLine_ + side * step
                                      : (low + high) / 2;
    emit hovered({std::clamp(next, low, high), 0});
}

void ChartView::focusOutEvent(QFocusEvent* event) {
    VtkPanel::focusOutEvent(event);
    if (probing_ && !underMouse()) emit hoverEnded();
}

void ChartView::changeEvent(QEvent* event) {
    if (event->type() == QEvent::PaletteChange && pipeline_) rebuild();
    VtkPanel::changeEvent(event);
}

void ChartView::resizeEvent(QResizeEvent* event) {
    VtkPanel::resizeEvent(event);
    rebuild();  // there is room for more ticks, or less
}

void ChartView::mousePressEvent(QMouseEvent* event) {
    if (event->button() != Qt::LeftButton || !clicks_.press(*event)) return;
    dragged_ = event->position();
    if (!draggable_ || !valueAt(event->position())) return;
    dragging_ = true;
    drag(event->position());
}

void ChartView::drag(const QPointF& position) {
    const QRectF area = plotArea();
    const QPointF inside(std::clamp(position.x(), area.left(), area.right()),
                         std::clamp(position.y(), area.top(), area.bottom()));
    if (const auto value = valueAt(inside)) emit dragged(*value);
}

void ChartView::mouseMoveEvent(QMouseEvent* event) {
    const auto value = valueAt(event->position());
    if (value)
        emit hovered(*value);
    else
        emit hoverEnded();
    if (clicks_.lost(*event)) {
        clicks_.cancel();
        if (std::exchange(dragging_, false)) emit dragEnded();
    }
    const bool moved = clicks_.move(*event);
    if (moved && dragging_) return drag(event->position());
    if (!moved || !zoomable_) return;
    const double perPixel = (chart_.x.high - chart_.x.low) / std::max(1.0, plotArea().width());
    const double by = (dragged_.x() - event->position().x()) * perPixel;
    dragged_ = event->position();
    emit rangeRequested(chart_.x.low + by, chart_.x.high + by);
}

void ChartView::mouseReleaseEvent(QMouseEvent* event) {
    const auto outcome = clicks_.release(*event);
    if (outcome && std::exchange(dragging_, false)) return emit dragEnded();
    if (!outcome || outcome == ClickDetector::Outcome::drag || draggable_) return;
    if (zoomable_ && outcome == ClickDetector::Outcome::doubleClick) return emit wholeRangeRequested();
    if (const auto value = valueAt(clicks_.pressed())) emit clicked(*value);
}

void ChartView::mouseDoubleClickEvent(QMouseEvent* event) { mousePressEvent(event); }

void ChartView::wheelEvent(QWheelEvent* event) {
    event->accept();
    const auto at = valueAt(event->position());
    if (!zoomable_ || !at) return;
    const double factor = std::pow(zoomPerStep, -event->angleDelta().y() / wheelStep);
    emit rangeRequested(at->x() + (chart_.x.low - at->x()) * factor,
                        at->x() + (chart_.x.high - at->x()) * factor);
}

void ChartView::enterEvent(QEnterEvent*) {}

void ChartView::leaveEvent(QEvent*) { emit hoverEnded(); }

}  // namespace isoscope
