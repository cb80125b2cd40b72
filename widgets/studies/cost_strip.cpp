// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/studies/cost_strip.h"

#include <algorithm>
#include <cmath>
#include <QAccessible>
#include <QHelpEvent>
#include <QLocale>
#include <QMouseEvent>
#include <QPainter>
#include <QPainterPath>
#include <QToolTip>

#include "core/shapes/trace_context.h"
#include "core/study/accuracy/povray_time.h"
#include "widgets/look.h"
#include "widgets/numbers/number_text.h"
#include "widgets/numbers/slider_scale.h"

namespace isoscope {

namespace {

constexpr int stripHeight = 34;
constexpr int lossRow = 3;  ///< height of a row of lost pixels
constexpr double near = 6;  ///< pixels within which a click means a measured value
constexpr auto povray = static_cast<std::size_t>(RootFinder::lipschitz);
constexpr auto ours = static_cast<std::size_t>(RootFinder::certified);

/// As in the charts: POV-Ray's in orange, ours in blue.
QColor curveColor(std::size_t finder, Look look) {
    return finder == povray ? lookColor(look, 0xc85c0a, 0xe8832a) : lookColor(look, 0x215eb7, 0x4a94f5);
}

QString sizeText(QSize size) { return CostStrip::tr("%1 × %2").arg(size.width()).arg(size.height()); }

QString pixelsText(quint64 low, quint64 high) {
    const QLocale locale = QLocale::c();
    if (low == high) return locale.toString(low);
    return CostStrip::tr("%1 to %2")
        .arg(locale.toString(std::min(low, high)), locale.toString(std::max(low, high)));
}

QString timeText(const CostPlot& plot, double value, std::size_t finder) {
    return roughTime(plot.secondsAt(value, finder).value_or(0));
}

}  // namespace

QString roughTime(double seconds) {
    const auto rounded = [](double value) { return QString::number(value, 'f', value < 9.95 ? 1 : 0); };
    if (!(seconds > 0) || !std::isfinite(seconds)) return CostStrip::tr("no time");
    if (seconds < 0.095) return CostStrip::tr("%1 s").arg(QString::number(seconds, 'f', 2));
    if (seconds < 99.5) return CostStrip::tr("%1 s").arg(rounded(seconds));
    if (seconds < 99.5 * 60) return CostStrip::tr("%1 min").arg(rounded(seconds / 60));
    return CostStrip::tr("%1 h").arg(rounded(seconds / 3600));
}

CostStrip::CostStrip(QWidget* parent)
    : QWidget(parent), scale_(std::make_unique<SliderScale>(0.1, 1, SliderScale::Kind::logarithmic)) {
    // Over a measured value event() says more.
    setToolTip(tr("What the setting costs in time and loses in pixels over its range; a click sets it."));
    setFocusPolicy(Qt::StrongFocus);
    setMouseTracking(true);
    setCursor(Qt::PointingHandCursor);
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    setWhatsThis(tr(
        "What each value of the slider above costs and loses. Orange is POV-Ray's time for a picture, blue "
        "the time of this program; both rise upwards by factors. Red below them are lost pixels: holes. The "
        "triangle marks the knee: behind it more time changes no pixel. A click sets the value, arrow keys "
        "go from one measured value to the next, Return goes to the knee."));
    told();
}

CostStrip::~CostStrip() = default;

QSize CostStrip::sizeHint() const { return {120, stripHeight}; }
QSize CostStrip::minimumSizeHint() const { return {60, stripHeight}; }

void CostStrip::setScale(const SliderScale& scale, int margin) {
    const bool other = scale.minimum() != scale_->minimum() || scale.maximum() != scale_->maximum();
    if (!other && scale.kind() == scale_->kind() && margin == margin_) return;
    *scale_ = scale;
    margin_ = margin;
    repaintGround();
    if (other && plot_.complete) setOld();
}

void CostStrip::setValue(double value) {
    if (value == value_) return;
    value_ = value;
    told();
}

void CostStrip::setSubject(const QString& name) {
    subject_ = name;
    setAccessibleName(tr("What %1 costs").arg(name));
}

void CostStrip::setPlot(CostPlot plot) {
    const bool noneToForget = !plot.complete || old_ == CostPlot();
    if (plot == plot_ && noneToForget && measurable_) return;
    measurable_ = true;
    plot_ = std::move(plot);
    if (plot_.complete) old_ = {};
    repaintGround();
    told();
}

void CostStrip::setOld() {
    if (plot_ == CostPlot() && measurable_) return;
    measurable_ = true;
    if (plot_.complete) old_ = std::move(plot_);
    plot_ = {};
    repaintGround();
    told();
}

void CostStrip::clear() {
    if (!measurable_) return;
    measurable_ = false;
    plot_ = old_ = {};
    repaintGround();
    told();
}

void CostStrip::told() {
    const QString text = summary();
    if (text != accessibleDescription()) {
        setAccessibleDescription(text);
        QAccessibleEvent changed(this, QAccessible::DescriptionChanged);
        QAccessible::updateAccessibility(&changed);
    }
    update();
    emit summaryChanged();
}

QString CostStrip::summary() const {
    const CostPlot& plot = plot_.complete ? plot_ : CostPlot();
    const auto [low, high] = plot.around(value_);
    if (!low) return {};
    const QString time = tr("POV-Ray %1 ± %2 % at %3")
                             .arg(timeText(plot, value_, povray))
                             .arg(qRound(100 * povrayTimeError))
                             .arg(sizeText(plot.picture));
    if (low->lost[povray] == 0 && high->lost[povray] == 0) return tr("%1; none lost").arg(time);
    return tr("%1; %2 lost").arg(time, pixelsText(low->lost[povray], high->lost[povray]));
}

QString CostStrip::detail(double value) const {
    const CostPlot& plot = shown();
    const auto [low, high] = plot.around(value);
    if (!low) return {};
    const QString name = plot.setting == StudiedSetting::accuracy ? QStringLiteral("accuracy")
                                                                  : QStringLiteral("max_gradient");
    QString text = tr("%1 %2").arg(name, numberText(value));
    if (!plot_.complete)
        text += plot_.marks.empty() ? tr(" (measured before the last change)") : tr(" (still measuring)");
    text += '\n' + tr("At %1: POV-Ray about %2, to %3 %; Isoscope about %4 of processor time")
                       .arg(sizeText(plot.picture), timeText(plot, value, povray))
                       .arg(qRound(100 * povrayTimeError))
                       .arg(timeText(plot, value, ours));
    text += '\n' + tr("Pixels lost: POV-Ray %1, Isoscope %2, of %3 that were traced")
                       .arg(pixelsText(low->lost[povray], high->lost[povray]),
                            pixelsText(low->lost[ours], high->lost[ours]))
                       .arg(QLocale::c().toString(plot.counted));
    if (plot.knee)
        text += '\n' + (plot.setting == StudiedSetting::accuracy
                            ? tr("Knee at %1: finer values cost more and change no pixel of this view")
                            : tr("Knee at %1: larger values cost more and change no pixel of this view"))
                           .arg(numberText(*plot.knee));
    return text;
}

double CostStrip::positionOf(double value) const {
    const double share = static_cast<double>(scale_->step(value)) / std::max(1, scale_->steps());
    return margin_ + share * std::max(1, width() - 1 - 2 * margin_);
}

double CostStrip::valueAt(double x) const {
    const CostPlot& plot = shown();
    double best = 0, distance = near;
    const auto consider = [&](double value) {
        if (std::abs(positionOf(value) - x) >= distance) return;
        distance = std::abs(positionOf(value) - x);
        best = value;
    };
    if (plot.knee) consider(*plot.knee);
    for (const CostPlot::Mark& mark : plot.marks) consider(mark.setting);
    if (best != 0) return best;
    const double share = std::clamp((x - margin_) / std::max(1, width() - 1 - 2 * margin_), 0.0, 1.0);
    const double value = scale_->value(static_cast<int>(std::lround(share * scale_->steps())));
    return std::clamp(QString::number(value, 'g', 2).toDouble(), scale_->minimum(), scale_->maximum());
}

QRectF CostStrip::curveArea() const {
    return QRectF(margin_, 5, std::max(1, width() - 1 - 2 * margin_), height() - 5 - 2 * lossRow - 5);
}

std::array<double, 2> CostStrip::timeRange() const {
    double low = HUGE_VAL, high = 0;
    for (const CostPlot* plot : {&plot_, &old_})
        for (const CostPlot::Mark& mark : plot->marks)
            for (const double seconds : mark.seconds) {
                if (!(seconds > 0)) continue;
                low = std::min(low, seconds);
                high = std::max(high, seconds);
            }
    if (!(high > 0)) return {1, 10};
    // What hardly differs is drawn flat.
    constexpr double leastSpan = 10;
    const double missing = std::sqrt(std::max(1.0, leastSpan * low / high));
    return {low / missing, high * missing};
}

double CostStrip::heightOf(double seconds) const {
    const auto [low, high] = timeRange();
    const QRectF area = curveArea();
    return area.bottom() - std::log(std::max(seconds, low) / low) / std::log(high / low) * area.height();
}

void CostStrip::paintPlot(QPainter& painter, const CostPlot& plot, bool pale) const {
    const Look look = lookOf(palette());
    painter.setOpacity(pale ? 0.35 : 1);
    for (const std::size_t finder : {ours, povray}) {
        QPolygonF curve;
        for (const CostPlot::Mark& mark : plot.marks)
            curve << QPointF(positionOf(mark.setting), heightOf(mark.seconds[finder]));
        if (curve.isEmpty()) continue;
        const QColor color = curveColor(finder, look);
        if (finder == povray && curve.size() > 1) {
            QPolygonF ground = curve;
            ground << QPointF(curve.last().x(), curveArea().bottom() + 1)
                   << QPointF(curve.first().x(), curveArea().bottom() + 1);
            QColor light = color;
            light.setAlpha(look == Look::light ? 36 : 48);
            painter.setPen(Qt::NoPen);
            painter.setBrush(light);
            painter.drawPolygon(ground);
        }
        painter.setBrush(Qt::NoBrush);
        painter.setPen(QPen(color, 1.6, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
        painter.drawPolyline(curve);
        painter.setBrush(color);
        painter.setPen(Qt::NoPen);
        for (const QPointF& point : curve) painter.drawEllipse(point, 1.6, 1.6);
    }
    // Each measured value stands for half of the way to its neighbours.
    painter.setPen(Qt::NoPen);
    for (std::size_t i = 0; i < plot.marks.size(); ++i) {
        const double at = positionOf(plot.marks[i].setting);
        const double left = i > 0 ? (at + positionOf(plot.marks[i - 1].setting)) / 2 : at - 2;
        const double right =
            i + 1 < plot.marks.size() ? (at + positionOf(plot.marks[i + 1].setting)) / 2 : at + 2;
        for (const std::size_t finder : {povray, ours}) {
            const quint64 lost = plot.marks[i].lost[finder];
            if (lost == 0 || plot.counted == 0) continue;
            // A single pixel is seen; all of them are red.
            const double share = static_cast<double>(lost) / static_cast<double>(plot.counted);
            QColor red = lookColor(look, 0xd21f14, 0xff5a4d);
            red.setAlphaF(static_cast<float>(std::clamp(1 + std::log10(share) / 5, 0.35, 1.0)));
            const double top = height() - 1 - 2 * lossRow - 1 + (finder == ours ? lossRow + 1 : 0);
            painter.fillRect(QRectF(left, top, right - left, lossRow), red);
        }
    }
    painter.setOpacity(1);
}

void CostStrip::paintKnee(QPainter& painter, const CostPlot& plot, bool pale) const {
    if (!plot.knee || plot.marks.empty()) return;
    painter.setOpacity(pale ? 0.35 : 1);
    const double at = positionOf(*plot.knee);
    const bool downwards = plot.setting == StudiedSetting::accuracy;
    const double end = positionOf(downwards ? plot.marks.front().setting : plot.marks.back().setting);
    QColor shade = palette().color(QPalette::Text);
    shade.setAlpha(lookOf(palette()) == Look::light ? 22 : 30);
    painter.fillRect(QRectF(std::min(at, end), 1, std::abs(at - end), height() - 2), shade);
    QColor ink = palette().color(QPalette::Text);
    painter.setPen(QPen(ink, 1, Qt::DotLine));
    painter.drawLine(QPointF(at, 6), QPointF(at, height() - 2));
    painter.setPen(Qt::NoPen);
    painter.setBrush(ink);
    painter.drawPolygon(QPolygonF{{at - 4, 1}, {at + 4, 1}, {at, 7}});
    painter.setOpacity(1);
}

void CostStrip::paintPresent(QPainter& painter) const {
    const double at = positionOf(value_);
    QColor ink = palette().color(QPalette::Highlight);
    painter.setPen(QPen(ink, 2));
    painter.drawLine(QPointF(at, 1), QPointF(at, height() - 2));
    const CostPlot& plot = shown();
    painter.setPen(QPen(palette().color(QPalette::Base), 1));
    for (const std::size_t finder : {ours, povray})
        if (const auto seconds = plot.secondsAt(value_, finder)) {
            painter.setBrush(curveColor(finder, lookOf(palette())));
            painter.drawEllipse(QPointF(at, heightOf(*seconds)), 3, 3);
        }
}

void CostStrip::paintGround(QPainter& painter) const {
    painter.setRenderHint(QPainter::Antialiasing);
    const QRectF frame = QRectF(rect()).adjusted(0.5, 0.5, -0.5, -0.5);
    painter.setPen(
        QPen(hasFocus() ? palette().color(QPalette::Highlight) : palette().color(QPalette::Mid), 1));
    painter.setBrush(palette().color(QPalette::Base));
    painter.drawRoundedRect(frame, 3, 3);
    if (plot_.marks.empty() && old_.marks.empty()) {
        painter.setPen(palette().color(QPalette::PlaceholderText));
        const QString text = !measurable_     ? tr("not measured: not in the picture shown")
                             : plot_.complete ? tr("nothing to measure here")
                                              : tr("measuring what it costs…");
        painter.drawText(rect(), Qt::AlignCenter,
                         fontMetrics().elidedText(text, Qt::ElideRight, width() - 8));
        return;
    }
    if (!plot_.complete) {
        paintKnee(painter, old_, true);
        paintPlot(painter, old_, true);
    }
    paintKnee(painter, plot_, false);
    paintPlot(painter, plot_, false);
}

const QPixmap& CostStrip::ground() {
    const double ratio = devicePixelRatioF();
    const QSize pixels = (QSizeF(size()) * ratio).toSize();
    if (ground_.size() == pixels && ground_.devicePixelRatio() == ratio) return ground_;
    ground_ = QPixmap(pixels);
    ground_.setDevicePixelRatio(ratio);
    ground_.fill(Qt::transparent);
    QPainter painter(&ground_);
    painter.setFont(font());
    paintGround(painter);
    return ground_;
}

void CostStrip::repaintGround() {
    ground_ = {};
    update();
}

void CostStrip::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.drawPixmap(0, 0, ground());
    if (!plot_.complete) emit exposed();
    if (plot_.marks.empty() && old_.marks.empty()) return;
    painter.setRenderHint(QPainter::Antialiasing);
    if (hover_ >= 0) {
        painter.setPen(QPen(palette().color(QPalette::PlaceholderText), 1));
        const double at = positionOf(valueAt(hover_));
        painter.drawLine(QPointF(at, 1), QPointF(at, height() - 2));
    }
    paintPresent(painter);
}

bool CostStrip::event(QEvent* event) {
    if (event->type() == QEvent::ToolTip) {
        const auto* help = static_cast<QHelpEvent*>(event);
        const QString text = detail(valueAt(help->pos().x()));
        const QString when = measurable_
                                 ? tr("What each value costs; it is measured as soon as all rests")
                                 : tr("What each value costs; it is measured once the picture shows it");
        QToolTip::showText(help->globalPos(), text.isEmpty() ? when : text, this);
        return true;
    }
    if (event->type() == QEvent::FocusIn || event->type() == QEvent::FocusOut) repaintGround();
    return QWidget::event(event);
}

void CostStrip::changeEvent(QEvent* event) {
    // Colours, type or style.
    repaintGround();
    QWidget::changeEvent(event);
}

void CostStrip::mousePressEvent(QMouseEvent* event) {
    if (event->button() != Qt::LeftButton) return event->ignore();
    if (plot_.marks.empty() && old_.marks.empty()) return;
    emit chosen(valueAt(event->position().x()));
}

void CostStrip::mouseMoveEvent(QMouseEvent* event) {
    hover_ = std::clamp(event->position().x(), 0.0, static_cast<double>(width()));
    if (QToolTip::isVisible()) {
        const QString text = detail(valueAt(hover_));
        if (!text.isEmpty()) QToolTip::showText(event->globalPosition().toPoint(), text, this);
    }
    update();
}

void CostStrip::leaveEvent(QEvent*) {
    hover_ = -1;
    update();
}

void CostStrip::keyPressEvent(QKeyEvent* event) {
    const CostPlot& plot = shown();
    const double fine = 1e-6 * value_;
    std::optional<double> next;
    switch (event->key()) {
        case Qt::Key_Left:
        case Qt::Key_Down:
            for (const CostPlot::Mark& mark : plot.marks)
                if (mark.setting < value_ - fine) next = mark.setting;
            break;
        case Qt::Key_Right:
        case Qt::Key_Up:
            for (const CostPlot::Mark& mark : plot.marks)
                if (!next && mark.setting > value_ + fine) next = mark.setting;
            break;
        case Qt::Key_Return:
        case Qt::Key_Enter: next = plot.knee; break;
        default: return QWidget::keyPressEvent(event);
    }
    if (next) emit chosen(*next);
}

}  // namespace isoscope
