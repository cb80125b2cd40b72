// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/viewport/view_overlay.h"

#include <algorithm>
#include <cmath>
#include <QPainter>

#include "core/render/render_image.h"
#include "widgets/either_stop.h"
#include "widgets/timing.h"
#include "widgets/viewport/cost_overlay.h"
#include "widgets/viewport/heat_overlay.h"
#include "widgets/viewport/hole_overlay.h"
#include "widgets/viewport/povray_overlay.h"

namespace isoscope {

namespace {

constexpr int dividerReach = 6;  ///< pixels on either side that take the divider
constexpr double dividerEdge = 0.02;
/// Share of the time that the hole map takes when a picture is drawn too.
constexpr double mapShare = 0.6;
/// The same of POV-Ray's own picture, where that is compared then.
constexpr double povrayShare = 0.7;
/// The same of the first, coarse map of costs.
constexpr double coarseShare = 1.0 / 16;

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

bool ViewOverlay::ready() const {
    if (kind_ == OverlayKind::none) return true;
    if (kind_ == OverlayKind::gradient) return heat_.complete;
    if (kind_ == OverlayKind::cost) return cost_.complete;
    if (needsPovray()) return povray_.complete;
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
    cost_ = {};
    other_ = {};
    povray_ = {};
    povrayImage_ = exactImage_ = {};
    problem_.clear();
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

/// What is computed in the background for one picture.
struct ViewOverlay::Work {
    OverlayKind kind;
    RenderRequest request;
    HoleMap holes;  ///< where they are known already
    std::shared_ptr<const Scene> kept;
    PovrayTask task;
    std::shared_ptr<std::atomic<double>> share;
    std::function<void(Result)> show;  ///< in the window's thread

    ShareReport report(double from, double part) const {
        return [share = share, from, part](double done) { share->store(from + part * done); };
    }

    Result run(const std::stop_token& stop) {
        Result result;
        if (kind == OverlayKind::gradient) {
            result.heat = gradientHeatMap(request, 0, stop, report(0, 1));
            return result;
        }
        if (kind == OverlayKind::cost) {
            Result coarse;
            coarse.coarse = true;
            coarse.cost = costMap(coarseCostRequest(request), 0, stop, report(0, coarseShare));
            if (coarse.cost.complete) show(std::move(coarse));
            result.cost = costMap(costRequest(request), 0, stop, report(coarseShare, 1 - coarseShare));
            return result;
        }
        if (kind == OverlayKind::besidePovray || kind == OverlayKind::povrayDifference) {
            askPovray(stop, result);
            return result;
        }
        result.holes = std::move(holes);
        if (kept) {
            request.scene = kept;
            result.other = toImage(renderImage(request, 0, nullptr, stop));
            return result;
        }
        const bool picture = kind == OverlayKind::split;
        if (!result.holes.complete)
            result.holes = holeMap(request, 0, stop, report(0, picture ? mapShare : 1));
        if (picture) {
            request.rootFinder = otherThan(request.rootFinder);
            result.other = toImage(renderImage(request, 0, nullptr, stop));
        }
        return result;
    }

    void askPovray(const std::stop_token& stop, Result& result) const {
        const PovrayPicture drawn = drawWithPovray(task.order, stop, report(0, povrayShare));
        if (drawn.image.pixels.empty()) {
            result.problem = QString::fromLocal8Bit(drawn.problem);
            return;
        }
        result.povray = compareWithPovray(request, drawn.image, task.leavesOut, 0, stop,
                                          report(povrayShare, 1 - povrayShare));
        if (!result.povray.complete) result.problem = tr("The pictures cannot be compared.");
        result.povrayImage = toImage(drawn.image);
        result.exactImage = toImage(result.povray.exact);
    }
};

void ViewOverlay::ensure() {
    const bool known = ready() && !(kind_ == OverlayKind::cost && costIsCoarse_);
    if (!shown_.scene || known || busy_ || (kind_ == OverlayKind::compare && !kept_)) return;
    PovrayTask task;
    if (needsPovray()) {
        if (!problem_.isEmpty()) return;
        if (povrayTask_) task = povrayTask_(shown_);
        problem_ = povrayTask_ ? task.problem : tr("There is no text that POV-Ray could draw.");
        if (!problem_.isEmpty()) return emit changed();
    }
    stop_ = std::stop_source();
    share_ = std::make_shared<std::atomic<double>>(0);
    busy_ = true;
    since_.start();
    progressTimer_.start();
    const std::uint64_t generation = generation_;
    const std::shared_ptr<const Scene> kept = kind_ == OverlayKind::compare ? kept_ : nullptr;
    const auto show = [this, generation](Result result) {
        QMetaObject::invokeMethod(
            this,
            [this, generation, result = std::move(result)]() mutable {
                if (generation == generation_) receive(std::move(result));
            },
            Qt::QueuedConnection);
    };
    Work work{kind_, shown_, holes_, kept, std::move(task), share_, show};
    worker_.submit([work = std::move(work), stop = stop_.get_token()](std::stop_token closing) mutable {
        const EitherStop either(stop, closing);
        Result result = work.run(either.token());
        if (!either.requested()) work.show(std::move(result));
    });
    emit changed();
}

void ViewOverlay::receive(Result result) {
    if (kind_ == OverlayKind::gradient) {
        heat_ = std::move(result.heat);
    } else if (kind_ == OverlayKind::cost) {
        cost_ = std::move(result.cost);
        costIsCoarse_ = result.coarse;
    } else if (needsPovray()) {
        povray_ = std::move(result.povray);
        povrayImage_ = std::move(result.povrayImage);
        exactImage_ = std::move(result.exactImage);
        problem_ = std::move(result.problem);
    } else
        holes_ = std::move(result.holes);
    if (!result.other.isNull()) other_ = std::move(result.other);
    busy_ = result.coarse;
    if (!busy_) progressTimer_.stop();
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
        case OverlayKind::cost: image_ = toImage(picture(cost_)); break;
        case OverlayKind::povrayDifference: image_ = toImage(picture(povray_)); break;
        case OverlayKind::none:
        case OverlayKind::besidePovray:
        case OverlayKind::compare:
        case OverlayKind::split: break;
    }
}

QString ViewOverlay::summary() const {
    if (kind_ == OverlayKind::none) return {};
    if (needsPovray() && !problem_.isEmpty()) return problem_;
    if (busy_ && needsPovray()) return tr("POV-Ray draws the picture…");
    if (kind_ == OverlayKind::compare) return compareSummary();
    if (busy_) return busySummary();
    if (!ready() && (stopped_ || shown_.scene)) return tr("Stopped. Redraw the picture to see it.");
    if (!shown_.scene) return tr("Waits for the picture.");
    if (needsPovray()) return povraySummary(povray_);
    if (kind_ == OverlayKind::cost) return costSummary(cost_);
    return kind_ == OverlayKind::gradient ? heatSummary(heat_) : holeSummary(holes_);
}

QString ViewOverlay::busySummary() const {
    if (kind_ == OverlayKind::gradient) return tr("Measuring the gradient on the surface…");
    if (kind_ == OverlayKind::cost) return tr("Counting what each pixel takes…");
    return tr("Comparing POV-Ray's picture with the exact one…");
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
    if (needsPovray()) return paintLegend(painter, area, povrayLegend(povray_));
    if (kind_ == OverlayKind::cost) return paintLegend(painter, area, costLegend(cost_));
    return kind_ == OverlayKind::gradient ? paintHeatScale(painter, area, heat_)
                                          : paintLegend(painter, area, holeLegend(holes_));
}

void ViewOverlay::paintSplit(QPainter& painter, const QRect& area) const {
    const int x = area.left() + static_cast<int>(std::lround(divider_ * area.width()));
    const QRect left(area.topLeft(), QPoint(x - 1, area.bottom())),
        right(QPoint(x, area.top()), area.bottomRight());
    const auto draw = [&](const QRect& side, const QImage& image) {
        painter.save();
        painter.setClipRect(side);
        painter.drawImage(area, image);
        painter.restore();
    };
    if (needsPovray()) {
        draw(left, povrayImage_);
        draw(right, exactImage_);
        return paintDivider(painter, area, tr("POV-Ray itself"), tr("exact"));
    }
    if (kind_ == OverlayKind::compare) {
        draw(left, other_);
        return paintDivider(painter, area, tr("A, kept"), tr("B, now"));
    }
    draw(shown_.rootFinder == RootFinder::lipschitz ? right : left, other_);
    paintDivider(painter, area, tr("as POV-Ray"), tr("exact"));
}

void ViewOverlay::paintDivider(QPainter& painter, const QRect& area, const QString& left,
                               const QString& right) const {
    const int x = area.left() + static_cast<int>(std::lround(divider_ * area.width()));
    painter.setPen(QPen(QColor(0, 0, 0, 160), 3));
    painter.drawLine(x, area.top(), x, area.bottom());
    painter.setPen(QPen(Qt::white, 1));
    painter.drawLine(x, area.top(), x, area.bottom());
    painter.setBrush(Qt::white);
    painter.setPen(QColor(0x40, 0x40, 0x40));
    painter.drawRoundedRect(QRect(x - 4, area.center().y() - 14, 8, 28), 3, 3);
    const int top = area.bottom() - 32;
    paintLabel(painter, left, {x - 8, top}, Qt::AlignRight);
    paintLabel(painter, right, {x + 8, top}, Qt::AlignLeft);
}

void ViewOverlay::setDivider(double share) {
    divider_ = std::clamp(share, dividerEdge, 1 - dividerEdge);
    emit changed();
}

bool ViewOverlay::dividerAt(double x, int width) const {
    return hasDivider() && ready() && std::abs(x - divider_ * width) <= dividerReach;
}

}  // namespace isoscope
