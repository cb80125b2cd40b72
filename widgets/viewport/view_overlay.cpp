// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/viewport/view_overlay.h"

#include <algorithm>
#include <cmath>
#include <QPainter>

#include "core/render/render_image.h"
#include "widgets/either_stop.h"
#include "widgets/timing.h"
#include "widgets/viewport/heat_overlay.h"
#include "widgets/viewport/hole_overlay.h"

namespace isoscope {

namespace {

constexpr int dividerReach = 6;  ///< pixels on either side that take the divider
constexpr double dividerEdge = 0.02;
/// Share of the time that the hole map takes when a picture is drawn too.
constexpr double mapShare = 0.6;

QImage toImage(const Image& linear) {
    QImage image(linear.width, linear.height, QImage::Format_RGB32);
    const auto width = static_cast<std::size_t>(linear.width);
    const std::span pixels(linear.pixels);
    for (int y = 0; y < image.height(); ++y)
        encodePixels(pixels.subspan(static_cast<std::size_t>(y) * width, width),
                     {reinterpret_cast<QRgb*>(image.scanLine(y)), width});
    return image;
}

RootFinder otherThan(RootFinder finder) {
    return finder == RootFinder::lipschitz ? RootFinder::certified : RootFinder::lipschitz;
}

void paintLabel(QPainter& painter, const QString& text, QPoint at, Qt::Alignment side) {
    const QSize size = painter.fontMetrics().boundingRect(text).size() + QSize(14, 6);
    const QRect box(side == Qt::AlignLeft ? at : at - QPoint(size.width(), 0), size);
    painter.setPen(Qt::NoPen);
    painter.setBrush(QColor(0x2b, 0x2e, 0x33, 225));
    painter.drawRoundedRect(box, 4, 4);
    painter.setPen(Qt::white);
    painter.drawText(box, Qt::AlignCenter, text);
}

}  // namespace

ViewOverlay::ViewOverlay(QObject* parent) : QObject(parent) {
    progressTimer_.setInterval(timing::busyMarkDelay);
    connect(&progressTimer_, &QTimer::timeout, this, &ViewOverlay::changed);
}

ViewOverlay::~ViewOverlay() { stop_.request_stop(); }

bool ViewOverlay::needsHoles() const {
    return kind_ == OverlayKind::holes || kind_ == OverlayKind::split || kind_ == OverlayKind::difference;
}

bool ViewOverlay::ready() const {
    if (kind_ == OverlayKind::none) return true;
    if (kind_ == OverlayKind::gradient) return heat_.complete;
    if (kind_ == OverlayKind::compare) return !other_.isNull();
    return holes_.complete && (kind_ != OverlayKind::split || !other_.isNull());
}

bool ViewOverlay::slow() const { return busy_ && since_.elapsed() > timing::progressDelay; }

void ViewOverlay::setKind(OverlayKind kind) {
    if (kind == kind_) return;
    // The other picture is another one.
    if (kind == OverlayKind::compare || kind_ == OverlayKind::compare) other_ = {};
    kind_ = kind;
    if (kind == OverlayKind::none) kept_.reset();
    cease();
    ensure();
}

void ViewOverlay::keep(std::shared_ptr<const Scene> scene) {
    kept_ = std::move(scene);
    if (kind_ != OverlayKind::compare) return;
    other_ = {};
    cease();
    ensure();
}

void ViewOverlay::follow(const RenderRequest& shown) {
    drop();
    shown_ = shown;
    shown_.verdicts.reset();  // that map belongs to the picture
    ensure();
}

void ViewOverlay::replace(const RenderRequest& shown) {
    if (!shown_.scene) return follow(shown);
    shown_ = shown;
    shown_.verdicts.reset();
    ensure();
}

void ViewOverlay::drop() {
    shown_ = {};
    holes_ = {};
    heat_ = {};
    other_ = {};
    image_ = {};
    stopped_ = false;
    cease();
}

void ViewOverlay::stop() {
    stopped_ = true;
    cease();
}

void ViewOverlay::cease() {
    stop_.request_stop();
    ++generation_;
    busy_ = false;
    progressTimer_.stop();
    makeImage();
    emit changed();
}

void ViewOverlay::ensure() {
    if (!shown_.scene || ready() || busy_ || (kind_ == OverlayKind::compare && !kept_)) return;
    stop_ = std::stop_source();
    share_ = std::make_shared<std::atomic<double>>(0);
    busy_ = true;
    since_.start();
    progressTimer_.start();
    const std::uint64_t generation = generation_;
    const bool heat = kind_ == OverlayKind::gradient, picture = hasDivider();
    const std::shared_ptr<const Scene> kept = kind_ == OverlayKind::compare ? kept_ : nullptr;
    Result known{heat ? HoleMap() : holes_, {}, {}};
    worker_.submit([this, generation, heat, picture, kept, known, request = shown_, share = share_,
                    stop = stop_.get_token()](std::stop_token closing) mutable {
        const EitherStop either(stop, closing);
        const std::stop_token token = either.token();
        const double part = picture ? mapShare : 1;
        const ShareReport report = [share, part](double done) { share->store(part * done); };
        Result result = std::move(known);
        if (heat)
            result.heat = gradientHeatMap(request, 0, token, report);
        else if (!kept && !result.holes.complete)
            result.holes = holeMap(request, 0, token, report);
        if (picture) {
            if (kept)
                request.scene = kept;
            else
                request.rootFinder = otherThan(request.rootFinder);
            result.other = toImage(renderImage(request, 0, nullptr, token));
        }
        if (token.stop_requested()) return;
        QMetaObject::invokeMethod(
            this,
            [this, generation, result = std::move(result)]() mutable {
                if (generation == generation_) receive(std::move(result));
            },
            Qt::QueuedConnection);
    });
    emit changed();
}

void ViewOverlay::receive(Result result) {
    if (kind_ == OverlayKind::gradient)
        heat_ = std::move(result.heat);
    else
        holes_ = std::move(result.holes);
    if (!result.other.isNull()) other_ = std::move(result.other);
    busy_ = false;
    progressTimer_.stop();
    makeImage();
    emit changed();
}

void ViewOverlay::makeImage() {
    image_ = {};
    if (!ready()) return;
    switch (kind_) {
        case OverlayKind::holes: image_ = holeImage(holes_, HoleStyle::marks); break;
        case OverlayKind::difference: image_ = holeImage(holes_, HoleStyle::difference); break;
        case OverlayKind::gradient: image_ = heatImage(heat_); break;
        case OverlayKind::none:
        case OverlayKind::compare:
        case OverlayKind::split: break;
    }
}

QString ViewOverlay::summary() const {
    if (kind_ == OverlayKind::none) return {};
    if (kind_ == OverlayKind::compare) return compareSummary();
    if (busy_)
        return kind_ == OverlayKind::gradient ? tr("Measuring the gradient on the surface…")
                                              : tr("Comparing POV-Ray's picture with the exact one…");
    if (!ready() && (stopped_ || shown_.scene)) return tr("Stopped. Redraw the picture to see it.");
    if (!shown_.scene) return tr("Waits for the picture.");
    return kind_ == OverlayKind::gradient ? heatSummary(heat_) : holeSummary(holes_);
}

QString ViewOverlay::compareSummary() const {
    if (!kept_) return tr("Nothing is kept. Choose Compare again to keep the scene as it is.");
    if (busy_) return tr("Drawing the kept scene…");
    if (!ready() && stopped_) return tr("Stopped. Redraw the picture to see it.");
    if (!ready()) return tr("Waits for the picture.");
    return tr("Left of the divider the kept scene, right of it the present one");
}

QRect ViewOverlay::paint(QPainter& painter, const QRect& area) const {
    if (kind_ == OverlayKind::none || !ready()) return area;
    if (hasDivider()) {
        paintSplit(painter, area);
        return area;
    }
    painter.drawImage(area, image_);
    return kind_ == OverlayKind::gradient ? paintHeatScale(painter, area, heat_)
                                          : paintLegend(painter, area, holeLegend(holes_));
}

void ViewOverlay::paintSplit(QPainter& painter, const QRect& area) const {
    const int x = area.left() + static_cast<int>(std::lround(divider_ * area.width()));
    const QRect left(area.topLeft(), QPoint(x - 1, area.bottom())),
        right(QPoint(x, area.top()), area.bottomRight());
    painter.save();
    const bool compares = kind_ == OverlayKind::compare;
    painter.setClipRect(!compares && shown_.rootFinder == RootFinder::lipschitz ? right : left);
    painter.drawImage(area, other_);
    painter.restore();
    painter.setPen(QPen(QColor(0, 0, 0, 160), 3));
    painter.drawLine(x, area.top(), x, area.bottom());
    painter.setPen(QPen(Qt::white, 1));
    painter.drawLine(x, area.top(), x, area.bottom());
    painter.setBrush(Qt::white);
    painter.setPen(QColor(0x40, 0x40, 0x40));
    painter.drawRoundedRect(QRect(x - 4, area.center().y() - 14, 8, 28), 3, 3);
    const int top = area.bottom() - 32;
    paintLabel(painter, compares ? tr("A, kept") : tr("as POV-Ray"), {x - 8, top}, Qt::AlignRight);
    paintLabel(painter, compares ? tr("B, now") : tr("exact"), {x + 8, top}, Qt::AlignLeft);
}

void ViewOverlay::setDivider(double share) {
    divider_ = std::clamp(share, dividerEdge, 1 - dividerEdge);
    emit changed();
}

bool ViewOverlay::dividerAt(double x, int width) const {
    return hasDivider() && ready() && std::abs(x - divider_ * width) <= dividerReach;
}

}  // namespace isoscope
