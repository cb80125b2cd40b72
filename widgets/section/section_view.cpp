// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/section/section_view.h"

#include <vtkActor.h>
#include <vtkCamera.h>
#include <vtkCellArray.h>
#include <vtkFloatArray.h>
#include <vtkFlyingEdges2D.h>
#include <vtkGenericOpenGLRenderWindow.h>
#include <vtkGenericRenderWindowInteractor.h>
#include <vtkImageData.h>
#include <vtkImageProperty.h>
#include <vtkImageSlice.h>
#include <vtkImageSliceMapper.h>
#include <vtkInteractorStyleImage.h>
#include <vtkLookupTable.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>
#include <vtkScalarBarActor.h>
#include <vtkTextProperty.h>
#include <vtkUnsignedCharArray.h>
#include <algorithm>
#include <cmath>
#include <QEvent>
#include <QMouseEvent>
#include <QPainter>

#include "widgets/section/section_colors.h"
#include "widgets/viewport/heat_overlay.h"

namespace isoscope {

namespace {

constexpr float lineHeight = 0.001f;  ///< lines float this far above the image so that it does not hide them
constexpr double thresholdLine = 2;
constexpr double outlineLine = 1;
constexpr double linesOpacity = 0.45;
constexpr int lineSteps = 10;  ///< lines on either side of the threshold
/// Ends of the gradient's scale, as shares of max_gradient.
constexpr double lowestScaleTop = 1.5, highestScaleTop = 4;
constexpr int fontSize = 11;
// In pixels.
constexpr double barWidth = 84;  ///< of the colour bar with its numbers
constexpr double leftMargin = 44;
constexpr double rightMargin = 20;
constexpr double bottomMargin = 20;
constexpr double edge = 8;
constexpr double tickLength = 4;
constexpr double widestSpacing = 56, closestSpacing = 24;  ///< of labels

/// Moves with the left button: there are no windows and levels to set here.
class SectionStyle : public vtkInteractorStyleImage {
  public:
    static SectionStyle* New();

    void OnLeftButtonDown() override {
        const int* position = GetInteractor()->GetEventPosition();
        FindPokedRenderer(position[0], position[1]);
        if (CurrentRenderer) StartPan();
    }
    void OnLeftButtonUp() override {
        if (State == VTKIS_PAN) EndPan();
    }
    void OnChar() override {}

    // Behind the last member: the macro ends with a function, and a semicolon behind it were one too many.
    vtkTypeMacro(SectionStyle, vtkInteractorStyleImage)
};
vtkStandardNewMacro(SectionStyle);

SectionColors::Rgb heatRgb(double share) {
    const QColor color = heatColor(share);
    return {static_cast<std::uint8_t>(color.red()), static_cast<std::uint8_t>(color.green()),
            static_cast<std::uint8_t>(color.blue())};
}

/// Multiples of `step` in [from, to] that also lie in [low, high]. Few, whatever the numbers: a view can be
/// zoomed until a step no longer changes a coordinate.
std::vector<double> ticks(double low, double high, double from, double to, double step) {
    constexpr int most = 100;
    std::vector<double> places;
    const double first = std::ceil(from / step);
    for (int i = 0; i < most && std::isfinite(first); ++i) {
        const double place = (first + i) * step;
        if (place > to || place > high + step * 1e-6) break;
        if (place >= low - step * 1e-6) places.push_back(place);
    }
    return places;
}

QColor toColor(const SectionColors::Rgb& c) { return {c[0], c[1], c[2]}; }

void setColor(vtkTextProperty* property, const SectionColors::Rgb& c) {
    property->SetColor(c[0] / 255.0, c[1] / 255.0, c[2] / 255.0);
}

}  // namespace

struct SectionView::Pipeline {
    explicit Pipeline(const QPalette& palette) : colors(palette) {}

    SectionColors colors;
    vtkNew<vtkRenderer> renderer;
    vtkNew<vtkRenderer> barRenderer;
    vtkNew<SectionStyle> style;
    vtkNew<vtkImageData> image;
    vtkNew<vtkImageSliceMapper> imageMapper;
    vtkNew<vtkImageSlice> slice;
    vtkNew<vtkImageData> heights;
    vtkNew<vtkFlyingEdges2D> contour;
    vtkNew<vtkPolyDataMapper> contourMapper;
    vtkNew<vtkActor> contourActor;
    vtkNew<vtkImageData> lineHeights;
    vtkNew<vtkFlyingEdges2D> lines;
    vtkNew<vtkPolyDataMapper> linesMapper;
    vtkNew<vtkActor> linesActor;
    vtkNew<vtkPolyData> outline;
    vtkNew<vtkPolyDataMapper> outlineMapper;
    vtkNew<vtkActor> outlineActor;
    vtkNew<vtkLookupTable> lookup;
    vtkNew<vtkScalarBarActor> bar;
};

SectionView::SectionView(QWidget* parent) : VtkPanel(parent) {
    setAccessibleName(tr("Cross-section of the function"));
    setFocusPolicy(Qt::StrongFocus);
}

/// Not before there is a field: it would keep the first picture of the program waiting.
void SectionView::makePipeline() {
    pipeline_ = std::make_unique<Pipeline>(palette());
    Pipeline& p = *pipeline_;
    p.imageMapper->SetInputData(p.image);
    p.slice->SetMapper(p.imageMapper);
    p.slice->GetProperty()->SetInterpolationTypeToLinear();
    p.contour->SetInputData(p.heights);
    p.contour->SetValue(0, 0);
    p.contour->ComputeScalarsOff();
    p.contourMapper->SetInputConnection(p.contour->GetOutputPort());
    p.contourMapper->ScalarVisibilityOff();
    p.contourActor->SetMapper(p.contourMapper);
    p.contourActor->GetProperty()->LightingOff();
    p.lines->SetInputData(p.lineHeights);
    p.lines->ComputeScalarsOff();
    p.linesMapper->SetInputConnection(p.lines->GetOutputPort());
    p.linesMapper->ScalarVisibilityOff();
    p.linesActor->SetMapper(p.linesMapper);
    p.linesActor->GetProperty()->LightingOff();
    p.outlineMapper->SetInputData(p.outline);
    p.outlineActor->SetMapper(p.outlineMapper);
    p.outlineActor->GetProperty()->LightingOff();

    p.lookup->SetNumberOfTableValues(SectionColors::steps);
    p.bar->SetLookupTable(p.lookup);
    p.bar->SetNumberOfLabels(5);
    p.bar->SetLabelFormat("%.3g");
    p.bar->UnconstrainedFontSizeOn();
    p.bar->SetPosition(0.05, 0.06);
    p.bar->SetPosition2(0.9, 0.88);
    p.bar->SetBarRatio(0.22);

    p.renderer->GetActiveCamera()->ParallelProjectionOn();
    for (vtkProp* prop :
         std::initializer_list<vtkProp*>{p.slice, p.linesActor, p.contourActor, p.outlineActor})
        p.renderer->AddViewProp(prop);
    placeBar();
    p.barRenderer->InteractiveOff();
    p.barRenderer->AddViewProp(p.bar);
    renderWindow()->AddRenderer(p.renderer);
    renderWindow()->AddRenderer(p.barRenderer);
    p.style->SetCurrentRenderer(p.renderer);
    interactor()->SetInteractorStyle(p.style);
    applyColors();
}

SectionView::~SectionView() {
    if (!pipeline_) return;
    interactor()->SetInteractorStyle(nullptr);
    renderWindow()->RemoveRenderer(pipeline_->renderer);
    renderWindow()->RemoveRenderer(pipeline_->barRenderer);
}

void SectionView::applyColors() {
    Pipeline& p = *pipeline_;
    p.colors = SectionColors(palette());
    const auto& c = p.colors;
    for (vtkRenderer* renderer : {p.renderer.Get(), p.barRenderer.Get()})
        renderer->SetBackground(c.background[0] / 255.0, c.background[1] / 255.0, c.background[2] / 255.0);
    p.linesActor->GetProperty()->SetColor(c.text[0] / 255.0, c.text[1] / 255.0, c.text[2] / 255.0);
    p.linesActor->GetProperty()->SetOpacity(linesOpacity);
    p.contourActor->GetProperty()->SetColor(c.line[0] / 255.0, c.line[1] / 255.0, c.line[2] / 255.0);
    p.outlineActor->GetProperty()->SetColor(c.outline[0] / 255.0, c.outline[1] / 255.0, c.outline[2] / 255.0);
    vtkTextProperty* labels = p.bar->GetLabelTextProperty();
    useApplicationFont(labels);
    setColor(labels, c.text);
    labels->ItalicOff();
    labels->BoldOff();
    labels->ShadowOff();
    labels->SetFontSize(fontSize);
    updateScale();
    if (!field_.empty()) updateImage();
    refresh();
}

void SectionView::setLinesShown(bool shown) {
    linesShown_ = shown;
    if (pipeline_) pipeline_->linesActor->SetVisibility(shown && !field_.empty());
    if (shown && !field_.empty()) updateLines();
    refresh();
}

void SectionView::setBand(double band) {
    if (band == band_ || !(band >= 0)) return;
    band_ = band;
    if (field_.empty()) return;
    updateImage();
    if (linesShown_) updateLines();
    updateScale();
    refresh();
}

/// What has the full colour.
double SectionView::reach() const {
    if (band_ > 0) return band_;
    switch (field_.quantity) {
        case SectionQuantity::value: return field_.extent;
        case SectionQuantity::gradient: return field_.maxGradient;
        case SectionQuantity::distance: return field_.distanceExtent;
    }
    return 1;
}

/// The colour bar: from inside to outside, or from flat to steep with the colours of the overlay.
void SectionView::updateScale() {
    Pipeline& p = *pipeline_;
    const bool gradient = field_.quantity == SectionQuantity::gradient;
    const double top = std::clamp(field_.steepest / reach(), lowestScaleTop, highestScaleTop);
    for (int i = 0; i < SectionColors::steps; ++i) {
        const double share = static_cast<double>(i) / (SectionColors::steps - 1);
        const auto rgb = gradient ? heatRgb(top * share) : p.colors.color(2 * share - 1);
        p.lookup->SetTableValue(i, rgb[0] / 255.0, rgb[1] / 255.0, rgb[2] / 255.0);
    }
    if (gradient)
        p.lookup->SetTableRange(0, top * reach());
    else
        p.lookup->SetTableRange(-reach(), reach());
}

void SectionView::show(SectionField field) {
    const bool sameRectangle = field.left == field_.left && field.right == field_.right &&
                               field.bottom == field_.bottom && field.top == field_.top;
    // A free plane that is being turned would else lose the user's view with each step.
    const bool sameView = !field_.empty() && field.plane.axis() == field_.plane.axis() &&
                          (sameRectangle || (field.plane.isFree() && viewTouched_));
    field_ = std::move(field);
    const bool any = !field_.empty();
    if (!any && !pipeline_) return;
    if (!pipeline_) makePipeline();
    Pipeline& p = *pipeline_;
    for (vtkProp* prop : std::initializer_list<vtkProp*>{p.slice, p.contourActor, p.outlineActor, p.bar})
        prop->SetVisibility(any);
    p.linesActor->SetVisibility(any && linesShown_);
    if (any) {
        const double ratio = devicePixelRatioF();  // VTK's line widths are in device pixels
        p.contourActor->GetProperty()->SetLineWidth(static_cast<float>(thresholdLine * ratio));
        p.outlineActor->GetProperty()->SetLineWidth(static_cast<float>(outlineLine * ratio));
        updateImage();
        updateContour();
        if (linesShown_) updateLines();
        updateOutline();
        updateScale();
        p.linesActor->GetProperty()->SetLineWidth(static_cast<float>(outlineLine * ratio));
        if (!sameView) resetView();
    }
    refresh();
}

void SectionView::updateImage() {
    Pipeline& p = *pipeline_;
    const double dx = (field_.right - field_.left) / (field_.columns - 1);
    const double dy = (field_.top - field_.bottom) / (field_.rows - 1);
    p.image->SetDimensions(field_.columns, field_.rows, 1);
    p.image->SetOrigin(field_.left, field_.bottom, 0);
    p.image->SetSpacing(dx, dy, 1);
    vtkNew<vtkUnsignedCharArray> colors;
    colors->SetNumberOfComponents(3);
    colors->SetNumberOfTuples(static_cast<vtkIdType>(field_.values.size()));
    const bool gradient = field_.quantity == SectionQuantity::gradient;
    const std::vector<float>& heights = field_.heights();
    const double full = reach();
    const auto columns = static_cast<std::size_t>(field_.columns);
    unsigned char* out = colors->GetPointer(0);
    for (std::size_t i = 0; i < field_.values.size(); ++i, out += 3) {
        const int column = static_cast<int>(i % columns), row = static_cast<int>(i / columns);
        auto rgb = std::isnan(heights[i]) ? p.colors.undefined(column, row)
                   : gradient             ? heatRgb(heights[i] / full)
                                          : p.colors.color(heights[i] / full);
        if (!field_.contained[i]) rgb = p.colors.faded(rgb);
        std::copy(rgb.begin(), rgb.end(), out);
    }
    p.image->GetPointData()->SetScalars(colors);
    p.image->Modified();
}

void SectionView::updateContour() {
    Pipeline& p = *pipeline_;
    p.heights->SetDimensions(field_.columns, field_.rows, 1);
    p.heights->SetOrigin(field_.left, field_.bottom, lineHeight);
    p.heights->SetSpacing(p.image->GetSpacing());
    vtkNew<vtkFloatArray> values;
    values->SetNumberOfTuples(static_cast<vtkIdType>(field_.values.size()));
    // Undefined counts as outside, as in the root finder; infinities would spoil the interpolation.
    const float far = static_cast<float>(field_.extent * 100);
    for (std::size_t i = 0; i < field_.values.size(); ++i) {
        const float value = field_.values[i];
        values->SetValue(static_cast<vtkIdType>(i), std::isnan(value) ? far : std::clamp(value, -far, far));
    }
    p.heights->GetPointData()->SetScalars(values);
    p.heights->Modified();
}

void SectionView::updateLines() {
    Pipeline& p = *pipeline_;
    const bool gradient = field_.quantity == SectionQuantity::gradient;
    const std::vector<float>& heights = field_.heights();
    const double step = gradient ? reach() / 4 : roundedUp(reach() / 5);
    const float far = static_cast<float>(step * 100);
    p.lineHeights->SetDimensions(field_.columns, field_.rows, 1);
    p.lineHeights->SetOrigin(field_.left, field_.bottom, lineHeight);
    p.lineHeights->SetSpacing(p.image->GetSpacing());
    vtkNew<vtkFloatArray> values;
    values->SetNumberOfTuples(static_cast<vtkIdType>(heights.size()));
    for (std::size_t i = 0; i < heights.size(); ++i)
        values->SetValue(static_cast<vtkIdType>(i),
                         std::isnan(heights[i]) ? far : std::clamp(heights[i], -far, far));
    p.lineHeights->GetPointData()->SetScalars(values);
    p.lineHeights->Modified();
    p.lines->SetNumberOfContours(0);
    int line = 0;
    for (int k = gradient ? 1 : -lineSteps; k <= lineSteps; ++k)
        if (k != 0) p.lines->SetValue(line++, k * step);  // the surface itself has a line of its own
}

void SectionView::updateOutline() {
    vtkNew<vtkPoints> points;
    vtkNew<vtkCellArray> lines;
    for (const glm::dvec2& corner : sectionOutline(field_.plane, field_.container))
        points->InsertNextPoint(corner.x, corner.y, 2 * lineHeight);
    const vtkIdType count = points->GetNumberOfPoints();
    if (count > 0) {
        lines->InsertNextCell(static_cast<int>(count) + 1);
        for (vtkIdType i = 0; i <= count; ++i) lines->InsertCellPoint(i % count);
    }
    pipeline_->outline->SetPoints(points);
    pipeline_->outline->SetLines(lines);
    pipeline_->outline->Modified();
}

void SectionView::resetView() {
    if (field_.empty()) return;
    viewTouched_ = false;
    const double width = field_.right - field_.left, height = field_.top - field_.bottom;
    // Room for the numbers at the left and below, in pixels.
    const double usableWidth = std::max(20.0, planeWidth() - leftMargin - rightMargin);
    const double usableHeight = std::max(20.0, this->height() - bottomMargin - edge);
    const double perPixel = std::max(width / usableWidth, height / usableHeight);
    const double x = (field_.left + field_.right) / 2 - perPixel * (leftMargin - rightMargin) / 2;
    const double y = (field_.bottom + field_.top) / 2 - perPixel * (bottomMargin - edge) / 2;
    const double distance = std::max(width, height);
    vtkCamera* camera = pipeline_->renderer->GetActiveCamera();
    camera->SetFocalPoint(x, y, 0);
    camera->SetPosition(x, y, distance);
    camera->SetViewUp(0, 1, 0);
    camera->SetParallelScale(perPixel * this->height() / 2);
    camera->SetClippingRange(distance * 0.5, distance * 2);
    refresh();
}

void SectionView::placeBar() {
    if (!pipeline_) return;
    const double share = planeWidth() / std::max(1, width());
    pipeline_->renderer->SetViewport(0, 0, share, 1);
    pipeline_->barRenderer->SetViewport(share, 0, 1, 1);
}

double SectionView::tickStep(double extent, double pixels) {
    const double perPixel = extent / pixels;
    const double step = roundedUp(perPixel * std::clamp(pixels / 3, closestSpacing, widestSpacing));
    return 2 * step <= extent ? step : roundedUp(perPixel * closestSpacing);
}

double SectionView::squareIn(const QSize& size) {
    return std::min(size.width() - barWidth - leftMargin - rightMargin, size.height() - bottomMargin - edge);
}

double SectionView::planeWidth() const { return std::max(width() - barWidth, width() / 2.0); }

QPointF SectionView::toPlane(const QPointF& pixel) const {
    vtkCamera* camera = pipeline_->renderer->GetActiveCamera();
    const double perPixel = camera->GetParallelScale() * 2 / std::max(1, height());
    return {camera->GetFocalPoint()[0] + (pixel.x() - planeWidth() / 2) * perPixel,
            camera->GetFocalPoint()[1] - (pixel.y() - height() / 2.0) * perPixel};
}

QPointF SectionView::toPixel(const QPointF& place) const {
    vtkCamera* camera = pipeline_->renderer->GetActiveCamera();
    const double perPixel = camera->GetParallelScale() * 2 / std::max(1, height());
    return {(place.x() - camera->GetFocalPoint()[0]) / perPixel + planeWidth() / 2,
            (camera->GetFocalPoint()[1] - place.y()) / perPixel + height() / 2.0};
}

SectionLineTool::Maps SectionView::lineMaps() const {
    return {[this](const QPointF& place) { return toPixel(place); },
            [this](const QPointF& pixel) { return toPlane(pixel); },
            QRectF(QPointF(field_.left, field_.bottom), QPointF(field_.right, field_.top))};
}

void SectionView::setLineTool(bool on) {
    lineTool_.setOn(on);
    showCursor({});
    update();
}

void SectionView::setLine(std::optional<SectionLine> line) {
    lineTool_.setLine(line);
    update();
}

void SectionView::markLine(std::optional<double> share) {
    lineMark_ = share;
    update();
}

void SectionView::showCursor(const QPointF& pixel) {
    if (!lineTool_.on() || field_.empty() || pixel.x() > planeWidth()) return unsetCursor();
    switch (lineTool_.gripAt(pixel, lineMaps())) {
        case SectionLineTool::Grip::none: return setCursor(Qt::CrossCursor);
        case SectionLineTool::Grip::whole: return setCursor(Qt::SizeAllCursor);
        default: setCursor(Qt::PointingHandCursor);
    }
}

void SectionView::paintEvent(QPaintEvent* event) {
    VtkPanel::paintEvent(event);
    if (field_.empty() || frame().isNull()) return;
    drawScales();
    if (QPainter painter(this); true) {
        painter.setClipRect(QRectF(0, 0, planeWidth(), height()));
        lineTool_.paint(painter, lineMaps(), lineMark_);
    }
    drawMark();
    drawProbe();
    if (hover_) drawCrosshair();
    if (hasFocus()) drawFocus();
}

void SectionView::drawCrosshair() {
    QPainter painter(this);
    QColor color = toColor(pipeline_->colors.text);
    color.setAlpha(130);
    painter.setPen(QPen(color, 1));
    painter.drawLine(QPointF(0, hover_->y()), QPointF(planeWidth(), hover_->y()));
    painter.drawLine(QPointF(hover_->x(), 0), QPointF(hover_->x(), height()));
}

/// Numbers along the left and the lower side, by Qt: VTK's own scales have neither round numbers nor a
/// readable size.
void SectionView::drawScales() {
    QPainter painter(this);
    QFont small = font();
    small.setPointSizeF(std::max(7.0, small.pointSizeF() * 0.85));
    painter.setFont(small);
    const double line = QFontMetricsF(small).height();
    const QPointF low = toPlane({0, static_cast<double>(height())}), high = toPlane({planeWidth(), 0});
    const double perPixel = (high.x() - low.x()) / std::max(1.0, planeWidth());
    const double shorter = std::min(field_.right - field_.left, field_.top - field_.bottom);
    const double step = tickStep(shorter, shorter / perPixel);
    const auto toX = [&](double x) { return (x - low.x()) / perPixel; };
    const auto toY = [&](double y) { return height() - (y - low.y()) / perPixel; };
    const auto tickText = [step](double value) {
        return QString::number(std::abs(value) < step / 2 ? 0 : value, 'g', 5);
    };
    // The scales keep to the container, and to the panel where the container reaches beyond it.
    const double side = std::max(leftMargin, toX(field_.left)) - tickLength;
    const double base = std::min(height() - bottomMargin, toY(field_.bottom)) + tickLength;
    const SectionAxisNames names = axisNames(field_.plane);
    const QColor ink = toColor(pipeline_->colors.text), tickInk = toColor(pipeline_->colors.outline);

    painter.setClipRect(QRectF(0, 0, planeWidth(), height()));
    const double right = std::min(toX(field_.right), planeWidth() - 4),
                 top = std::max(toY(field_.top), line / 2);
    for (const double x : ticks(field_.left, field_.right, std::max(low.x(), field_.left), high.x(), step)) {
        painter.setPen(tickInk);
        painter.drawLine(QPointF(toX(x), base - tickLength), QPointF(toX(x), base));
        painter.setPen(ink);
        painter.drawText(QRectF(toX(x) - 40, base, 80, line), Qt::AlignHCenter, tickText(x));
    }
    double widest = 0;
    for (const double y :
         ticks(field_.bottom, field_.top, std::max(low.y(), field_.bottom), high.y(), step)) {
        painter.setPen(tickInk);
        painter.drawLine(QPointF(side, toY(y)), QPointF(side + tickLength, toY(y)));
        painter.setPen(ink);
        painter.drawText(QRectF(side - 82, toY(y) - line / 2, 80, line), Qt::AlignRight, tickText(y));
        widest = std::max(widest, painter.fontMetrics().horizontalAdvance(tickText(y)) + 4.0);
    }
    QFont bold = small;
    bold.setBold(true);
    painter.setFont(bold);
    painter.drawText(QRectF(right + 6, base - line, 16, line), Qt::AlignLeft, names.horizontal);
    painter.drawText(QRectF(side - widest - 42, top - line / 2, 40, line), Qt::AlignRight, names.vertical);
}

void SectionView::changeEvent(QEvent* event) {
    if (event->type() == QEvent::PaletteChange && pipeline_) applyColors();
    VtkPanel::changeEvent(event);
}

void SectionView::mousePressEvent(QMouseEvent* event) {
    if (!clicks_.press(*event)) return;
    const bool draws = lineTool_.on() && event->button() == Qt::LeftButton && !field_.empty() &&
                       !event->modifiers().testFlag(Qt::ShiftModifier);
    if (!draws) return VtkPanel::mousePressEvent(event);
    lineTool_.press(event->position(), lineMaps());
    update();
}

void SectionView::mouseReleaseEvent(QMouseEvent* event) {
    const auto outcome = clicks_.release(*event);
    if (!outcome) return;
    if (lineTool_.dragging()) {
        lineTool_.release();
        showCursor(event->position());
    } else {
        VtkPanel::mouseReleaseEvent(event);
    }
    if (outcome == ClickDetector::Outcome::doubleClick && event->button() == Qt::LeftButton) resetView();
}

void SectionView::mouseMoveEvent(QMouseEvent* event) {
    hover_ = event->position();
    clicks_.move(*event);
    if (lineTool_.dragging()) {
        if (lineTool_.drag(event->position(), lineMaps())) emit lineChanged();
    } else {
        VtkPanel::mouseMoveEvent(event);
        if (event->buttons() != Qt::NoButton) viewTouched_ = true;
        showCursor(event->position());
    }
    tellHover();
    update();
}

void SectionView::mouseDoubleClickEvent(QMouseEvent* event) { mousePressEvent(event); }

void SectionView::leaveEvent(QEvent* event) {
    VtkPanel::leaveEvent(event);
    endHover();
}

void SectionView::resizeEvent(QResizeEvent* event) {
    placeBar();
    if (!viewTouched_) resetView();
    VtkPanel::resizeEvent(event);
}

}  // namespace isoscope
