// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/viewport/viewport.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <QMouseEvent>
#include <QPainter>

#include "widgets/timing.h"
#include "widgets/viewport/cut_marks.h"
#include "widgets/viewport/picture_message.h"
#include "widgets/viewport/verdict_overlay.h"

namespace isoscope {

namespace {

constexpr double degreesPerPixel = 0.4;
constexpr double degreesPerKey = 5;
constexpr double panPerKey = 0.05;
constexpr double zoomPerStep = 1.15;
constexpr double wheelStep = 120;  ///< Qt's unit of one notch
/// A moving picture should be complete within this time. Then it comes in one pass: coarse ones would only
/// delay it.
constexpr double smoothSeconds = 0.06;
constexpr double dividerPerKey = 0.02;
constexpr int dimming = 64;  ///< of 255, over a picture that no longer fits the text

}  // namespace

Camera fittedCamera(const Camera& camera, int width, int height) {
    Camera fitted = camera;
    const double own = glm::length(camera.right) / glm::length(camera.up);
    const double wanted = static_cast<double>(width) / std::max(1, height);
    if (!(own > 0) || !std::isfinite(own) || !(wanted > 0)) return fitted;
    if (wanted > own)
        fitted.right *= wanted / own;
    else
        fitted.up *= own / wanted;
    return fitted;
}

Viewport::Viewport(QWidget* parent)
    : QWidget(parent), renderer_(0, [this] {
          QMetaObject::invokeMethod(this, &Viewport::drainIfBusy, Qt::QueuedConnection);
      }) {
    setAttribute(Qt::WA_OpaquePaintEvent);
    setFocusPolicy(Qt::StrongFocus);
    setMinimumSize(160, 120);
    setAccessibleName(tr("Picture of the scene"));
    setAccessibleDescription(
        tr("Arrow keys turn the view, Shift and arrow keys shift it, plus and minus zoom, Home resets; Alt "
           "and arrow keys move the divider of a split view"));
    setToolTip(
        tr("Drag to turn, right-drag or Shift-drag to shift, wheel to zoom, double-click to reset, "
           "Ctrl-drag to take the picture elsewhere"));
    setMouseTracking(true);
    connect(&overlay_, &ViewOverlay::changed, this, [this] { update(); });
    connect(&planeHandle_, &PlaneHandle::changed, this, [this] { update(); });
    connect(&placeMarks_, &PlaceMarks::changed, this, [this] { update(); });
    connect(&guides_, &SceneGuides::changed, this, [this] { update(); });
    connect(&probeMark_, &ProbeMark::changed, this, [this] { update(probeMark_.stale(projection())); });
    softenTimer_.setSingleShot(true);
    softenTimer_.setInterval(timing::softenPause);
    connect(&softenTimer_, &QTimer::timeout, this, &Viewport::soften);
    drainTimer_.setTimerType(Qt::PreciseTimer);
    drainTimer_.setInterval(timing::drainInterval);
    connect(&drainTimer_, &QTimer::timeout, this, &Viewport::drain);
    settleTimer_.setSingleShot(true);
    settleTimer_.setInterval(timing::settlePause);
    connect(&settleTimer_, &QTimer::timeout, this, [this] {
        if (preliminary_) request(1);
    });
    resizeTimer_.setSingleShot(true);
    resizeTimer_.setInterval(timing::resizePause);
    connect(&resizeTimer_, &QTimer::timeout, this, [this] { request(1); });
}

Viewport::~Viewport() = default;

void Viewport::setScene(std::shared_ptr<const Scene> scene, bool sameLook) {
    scene_ = std::move(scene);
    guides_.setScene(scene_.get());
    const bool sameView = !scene_ || scene_->camera == view_.home();
    if (!sameView) {
        view_.setHome(scene_->camera);
        emit viewChanged();
    }
    if (sameLook && sameView && !finished_ && !preliminary_)
        confirm_ = true;
    else if (sameLook && finished_)
        request(1, PictureBuffer::Reveal::whenComplete);
    else
        requestMoving(1, budget_.decide().leftOut);
    update();
}

void Viewport::clear() {
    renderer_.stop();
    overlay_.drop();
    scene_.reset();
    guides_.setScene(nullptr);
    buffer_.clear();
    forgetMarks();
    verdicts_.reset();
    softenTimer_.stop();
    softening_ = soft_ = false;
    told_ = {};
    view_ = OrbitView();
    budget_.forget();
    job_ = 0;
    confirm_ = false;
    renderer_.takeTiles();  // of a picture that is not wanted any more
    drainTimer_.stop();
    finished_ = false;
    busySince_.invalidate();
    update();
    emit viewChanged();
    emit progressed({});
}

void Viewport::adoptView() {
    view_.setHome(view_.camera());
    emit viewChanged();
}

void Viewport::showCamera(const Camera& camera, Drawing drawing) {
    if (camera == view_.camera()) return;
    view_.show(camera);
    if (drawing == Drawing::whole) request(1);
    if (drawing == Drawing::moving) requestMoving(1, budget_.decide().leftOut);
    emit viewChanged();
}

void Viewport::setAntialias(bool on, double mostSeconds) {
    softSeconds_ = mostSeconds;
    const bool was = std::exchange(antialias_, on);
    if (was && !on)
        restart();
    else if (on && finished_ && !soft_ && softenable(told_))
        softenTimer_.start(0);
}

void Viewport::setMovingSeconds(double seconds) {
    budget_.setSeconds(seconds);
    emit movingSecondsChanged(seconds);
}

void Viewport::setLeftOut(const StageSet& leftOut) {
    if (leftOut == std::exchange(leftOut_, leftOut)) return;
    budget_.forget();
    restart();
}

void Viewport::setRootFinder(RootFinder finder) {
    if (std::exchange(rootFinder_, finder) != finder) restart();
}

void Viewport::setVerdictsShown(bool shown) {
    verdictsShown_ = shown;
    update();
}

void Viewport::setCutsShown(bool shown) {
    cutsShown_ = shown;
    update();
}

void Viewport::setPicking(bool on) {
    picking_ = on;
    showCursor(lastPosition_);
}

void Viewport::setPicked(std::optional<QPointF> place) {
    picked_ = place;
    update();
}

void Viewport::setNotice(const QString& notice, Dimmed dimmed) {
    notice_ = notice;
    dimmed_ = dimmed;
    update();
}

void Viewport::resetView() {
    if (!view_.moved()) return;
    view_.reset();
    request(1);
    emit viewChanged();
}

void Viewport::showView(const OrbitView::State& view) {
    if (view == view_.state()) return;
    view_.setState(view);
    request(1);
    emit viewChanged();
}

void Viewport::stop() {
    settleTimer_.stop();
    softenTimer_.stop();
    if (softening_) drainTimer_.stop();
    softening_ = false;
    resizeTimer_.stop();
    confirm_ = false;
    renderer_.stop();
    overlay_.stop();
}

void Viewport::restart() { request(1); }

ViewProjection Viewport::projection() const {
    return {fittedCamera(view_.camera(), width(), height()), size()};
}

QSize Viewport::deviceSize() const { return (QSizeF(size()) * devicePixelRatioF()).toSize(); }

void Viewport::request(int finestBlock, PictureBuffer::Reveal reveal, const StageSet& leftOut) {
    const QSize size = deviceSize();
    if (!scene_ || size.isEmpty() || !isVisible()) return;
    softenTimer_.stop();
    // Its first pass is not waited for.
    if (std::exchange(softening_, false)) renderer_.stop();
    RenderRequest order;
    order.scene = scene_;
    order.camera = fittedCamera(view_.camera(), size.width(), size.height());
    order.width = size.width();
    order.height = size.height();
    preliminary_ = finestBlock > 1 || leftOut != StageSet();
    // Smooth edges come later, in a picture of their own; but what looks the same must not lose them
    // meanwhile.
    order.antialias = antialias_ && soft_ && reveal == PictureBuffer::Reveal::whenComplete;
    order.leftOut = leftOut_ | leftOut;
    order.rootFinder = rootFinder_;
    verdicts_ = rootFinder_ == RootFinder::certified ? std::make_shared<VerdictMap>(order.width, order.height)
                                                     : nullptr;
    order.verdicts = verdicts_;
    forgetMarks();
    confirm_ = false;
    sameLook_ = reveal == PictureBuffer::Reveal::whenComplete;
    if (!sameLook_) overlay_.drop();
    shown_ = order;
    // How long the first picture of a document takes is anybody's guess.
    job_ = renderer_.request(std::move(order), finestBlock, job_ == 0 ? 0 : smoothSeconds);
    buffer_.expect(job_, size, reveal);
    if (!busySince_.isValid()) busySince_.start();
    finished_ = false;
    if (!preliminary_) settleTimer_.stop();
    drainTimer_.start();
    toldSince_.start();
}

void Viewport::forgetMarks() {
    verdictImage_ = {};
    cutImage_ = {};
    cutsKnown_ = false;
}

bool Viewport::softenable(const RenderProgress& picture) const {
    return picture.seconds <= softSeconds_ && picture.pass == picture.passCount;
}

/// Draws the finished picture again, with smooth edges.
void Viewport::soften() {
    if (!scene_ || !finished_ || preliminary_ || soft_ || overlay_.comparesPictures() || !shown_.scene)
        return;
    RenderRequest order = shown_;
    order.antialias = true;
    order.verdicts.reset();  // they are known
    // Nothing coarse is shown of it.
    const QSize size(order.width, order.height);
    job_ = renderer_.request(std::move(order), 1, anyTime);
    buffer_.expect(job_, size, PictureBuffer::Reveal::whenComplete);
    softening_ = true;
    drainTimer_.start();
}

void Viewport::drainSoftened(const RenderProgress& progress, bool changed) {
    if (!progress.finished || progress.job != job_) return;
    drainTimer_.stop();
    softening_ = false;
    soft_ = progress.pass == progress.passCount && buffer_.complete(job_);
    if (soft_ || changed) update();
}

void Viewport::requestMoving(int finestBlock, const StageSet& leftOut) {
    request(finestBlock, PictureBuffer::Reveal::firstPass, leftOut);
    if (preliminary_) settleTimer_.start();
}

void Viewport::viewMovedByUser() {
    touched_ = true;
    const EffectBudget::Decision decision = budget_.decide();
    const int block = decision.seconds < smoothSeconds ? 1 : decision.seconds / 4 < smoothSeconds ? 2 : 4;
    requestMoving(block, decision.leftOut);
    emit viewChanged();
}

void Viewport::drainIfBusy() {
    // Otherwise the timer was faster, or the picture was given up.
    if (drainTimer_.isActive()) drain();
}

void Viewport::drain() {
    const RenderProgress progress = renderer_.progress();
    const bool changed = buffer_.add(renderer_.takeTiles());
    if (softening_) return drainSoftened(progress, changed);
    const bool ended = progress.finished && progress.job == job_;
    const bool revealed = ended && buffer_.complete(job_);
    if (changed || revealed || ended || busyMarkShown()) update();
    if (ended) {
        drainTimer_.stop();
        if (!preliminary_ && !shown_.antialias && progress.pass == progress.passCount)
            budget_.note(progress.seconds, progress.statistics);
        // A preliminary picture is followed by the whole one as soon as all rests.
        finished_ = !preliminary_ || !settleTimer_.isActive();
        told_ = progress;
        soft_ = shown_.antialias && revealed;
        if (finished_) busySince_.invalidate();
    }
    // Whoever shows progress takes a millisecond for it, from the picture.
    if (ended || toldSince_.elapsed() >= timing::progressInterval) {
        toldSince_.start();
        emit progressed(progress);
    }
    if (!ended || !finished_ || job_ == 0) return;
    if (!preliminary_ && progress.pass == progress.passCount && !confirm_)
        sameLook_ ? overlay_.replace(shown_) : overlay_.follow(shown_);
    emit pictureFinished();
    if (antialias_ && !soft_ && !confirm_ && !preliminary_ && softenable(progress)) softenTimer_.start();
    if (confirm_) request(1, PictureBuffer::Reveal::whenComplete);
}

bool Viewport::busyMarkShown() const {
    return !finished_ && busySince_.isValid() && busySince_.elapsed() > timing::busyMarkDelay;
}

bool Viewport::event(QEvent* event) {
    if (event->type() == QEvent::ToolTip && touched_) return true;
    if (event->type() == QEvent::Show) resizeTimer_.start(0);
    return QWidget::event(event);
}

void Viewport::paintEvent(QPaintEvent* event) {
    // What has come meanwhile belongs to this painting already: at start the window is painted for longer
    // than a first pass takes.
    if (drainTimer_.isActive() && !softening_ && event->rect() == rect()) buffer_.add(renderer_.takeTiles());
    QPainter painter(this);
    const QImage& picture = buffer_.picture();
    if (picture.isNull()) {
        painter.fillRect(rect(), palette().base());
    } else if (picture.size() == deviceSize()) {
        QImage sharp = picture;  // shares the pixels
        sharp.setDevicePixelRatio(devicePixelRatioF());
        painter.drawImage(QPoint(0, 0), sharp);
    } else {
        painter.drawImage(rect(), picture);
    }
    paintOverlays(painter, paintMarks(painter));
}

QRect Viewport::paintMarks(QPainter& painter) {
    QRect free = overlay_.paint(painter, rect());
    paintCuts(painter);
    free = paintVerdicts(painter, free);
    guides_.paint(painter, projection(), rect());
    planeHandle_.paint(painter, projection());
    if (!buffer_.picture().isNull()) placeMarks_.paint(painter, rect(), projection());
    paintPicked(painter);
    return free;
}

QImage Viewport::pictureWithMarks() {
    QImage picture = buffer_.picture();
    if (picture.isNull()) return picture;
    picture.detach();
    picture.setDevicePixelRatio(static_cast<double>(picture.width()) / std::max(1, width()));
    QPainter painter(&picture);
    painter.setFont(font());
    paintMarks(painter);
    painter.end();
    picture.setDevicePixelRatio(1);
    return picture;
}

void Viewport::paintCuts(QPainter& painter) {
    if (!cutsShown_ || !verdicts_ || !finished_ || preliminary_ || overlay_.kind() != OverlayKind::none)
        return;
    if (!std::exchange(cutsKnown_, true)) cutImage_ = cutImage(*verdicts_, devicePixelRatioF());
    if (!cutImage_.isNull()) painter.drawImage(rect(), cutImage_);
}

QRect Viewport::paintVerdicts(QPainter& painter, const QRect& area) {
    if (!verdictsShown_ || !verdicts_ || !finished_ || preliminary_) return area;
    if (verdictImage_.isNull()) verdictImage_ = verdictImage(*verdicts_);
    painter.drawImage(rect(), verdictImage_);
    return paintLegend(painter, area, verdictLegend(told_.statistics.verdicts));
}

void Viewport::paintPicked(QPainter& painter) const {
    if (!picked_) return;
    constexpr double inner = 4, outer = 12;
    const QPointF at(picked_->x() * width(), picked_->y() * height());
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setBrush(Qt::NoBrush);
    // Seen on light and dark pictures.
    for (const QPen& pen : {QPen(QColor(0, 0, 0, 170), 4), QPen(Qt::white, 1.5)}) {
        painter.setPen(pen);
        painter.drawEllipse(at, inner, inner);
        for (const QPointF way : {QPointF(1, 0), QPointF(-1, 0), QPointF(0, 1), QPointF(0, -1)})
            painter.drawLine(at + inner * way, at + outer * way);
    }
}

void Viewport::paintOverlays(QPainter& painter, const QRect& free) {
    probeMark_.paint(painter, projection());
    painter.setRenderHint(QPainter::Antialiasing);
    if (scene_ && scene_->objects.empty() && notice_.isEmpty()) {
        paintMessage(painter, rect(), Qt::AlignCenter,
                     tr("Nothing to see yet: the text has no object.\nType a formula, such as x*x + y*y + "
                        "z*z - 1, or insert a function, to begin."));
    }
    if (!notice_.isEmpty()) {
        if (dimmed_ == Dimmed::yes) painter.fillRect(rect(), QColor(0, 0, 0, dimming));
        paintMessage(painter, free, Qt::AlignLeft | Qt::AlignBottom, notice_);
    }
    if (busyMarkShown()) {
        constexpr double size = 18, margin = 10, degreesPerMillisecond = 0.36;
        const QRectF circle(width() - size - margin, margin, size, size);
        painter.setBrush(Qt::NoBrush);
        painter.setPen(QPen(QColor(0, 0, 0, 120), 4));
        painter.drawEllipse(circle);
        painter.setPen(QPen(palette().highlight(), 2.5, Qt::SolidLine, Qt::RoundCap));
        const int start =
            -static_cast<int>(static_cast<double>(busySince_.elapsed()) * degreesPerMillisecond) % 360;
        painter.drawArc(circle, start * 16, 100 * 16);
    }
    if (hasFocus()) {
        painter.setBrush(Qt::NoBrush);
        painter.setPen(QPen(palette().highlight(), 1));
        painter.drawRect(QRectF(rect()).adjusted(0.5, 0.5, -0.5, -0.5));
    }
}

void Viewport::resizeEvent(QResizeEvent*) {
    // The old picture is stretched meanwhile; a new one for every step of a resize would never be finished.
    resizeTimer_.start(job_ == 0 ? 0 : timing::resizePause);
}

void Viewport::showCursor(const QPointF& position) {
    if (drag_ == Drag::orbit)
        setCursor(Qt::ClosedHandCursor);
    else if (drag_ == Drag::pan)
        setCursor(Qt::SizeAllCursor);
    else if (drag_ == Drag::plane || planeHandle_.gripAt(position, projection()) != PlaneHandle::Grip::none)
        setCursor(Qt::PointingHandCursor);
    else if (drag_ == Drag::divider || overlay_.dividerAt(position.x(), width()))
        setCursor(Qt::SplitHCursor);
    else if (picking_)
        setCursor(Qt::CrossCursor);
    else
        unsetCursor();
}

Viewport::Drag Viewport::dragFor(const QMouseEvent& press) {
    if (press.button() != Qt::LeftButton || press.modifiers().testFlag(Qt::ShiftModifier)) return Drag::pan;
    if (press.modifiers().testFlag(Qt::ControlModifier)) return Drag::away;
    planeHandle_.press(press.position(), projection());
    if (planeHandle_.held() != PlaneHandle::Grip::none) return Drag::plane;
    return overlay_.dividerAt(press.position().x(), width()) ? Drag::divider : Drag::orbit;
}

void Viewport::mousePressEvent(QMouseEvent* event) {
    if (!clicks_.press(*event)) return;
    emit dragFinished();  // what moved before, by the wheel, is complete
    lastPosition_ = event->position();
    drag_ = dragFor(*event);
    showCursor(lastPosition_);
}

void Viewport::mouseMoveEvent(QMouseEvent* event) {
    if (clicks_.lost(*event)) {
        clicks_.cancel();
        endDrag(ClickDetector::Outcome::drag, event->position());
    }
    if (drag_ != Drag::none && !clicks_.move(*event)) return;
    if (drag_ == Drag::away) {
        clicks_.cancel();
        endDrag(ClickDetector::Outcome::drag, event->position());
        if (!buffer_.picture().isNull()) emit pictureTaken();
        return;
    }
    const QPointF moved = event->position() - lastPosition_;
    lastPosition_ = event->position();
    if (drag_ == Drag::none) {
        planeHandle_.hover(lastPosition_, projection());
        return showCursor(lastPosition_);
    }
    if (drag_ == Drag::plane) return planeHandle_.drag(lastPosition_, projection());
    if (drag_ == Drag::divider) return overlay_.setDivider(lastPosition_.x() / std::max(1, width()));
    if (moved.isNull() || !scene_) return;
    if (drag_ == Drag::orbit)
        view_.orbit(moved.x() * degreesPerPixel, -moved.y() * degreesPerPixel);
    else
        panByPixels(moved);
    viewMovedByUser();
}

void Viewport::mouseReleaseEvent(QMouseEvent* event) {
    if (const auto outcome = clicks_.release(*event)) endDrag(*outcome, event->position());
}

void Viewport::endDrag(ClickDetector::Outcome outcome, const QPointF& position) {
    const Drag ended = std::exchange(drag_, Drag::none);
    if (ended == Drag::plane) planeHandle_.release();
    showCursor(position);
    emit dragFinished();
    const bool onPicture = ended == Drag::orbit || ended == Drag::away;
    if (onPicture && outcome != ClickDetector::Outcome::drag) {
        if (picking_ && scene_)
            emit picked({position.x() / std::max(1, width()), position.y() / std::max(1, height())});
        else if (!picking_ && outcome == ClickDetector::Outcome::doubleClick)
            resetView();
    }
    if (preliminary_) request(1);
}

void Viewport::mouseDoubleClickEvent(QMouseEvent* event) { mousePressEvent(event); }

void Viewport::panByPixels(const QPointF& pixels) {
    // The view's own camera may be narrower or lower than the fitted one that fills the widget.
    const Camera& own = view_.camera();
    const Camera fitted = fittedCamera(own, width(), height());
    const double widths =
        pixels.x() / std::max(1, width()) * glm::length(fitted.right) / glm::length(own.right);
    const double heights = -pixels.y() / std::max(1, height()) * glm::length(fitted.up) / glm::length(own.up);
    view_.pan(widths, heights);
}

void Viewport::zoomAt(const QPointF& position, double factor) {
    // What is under the cursor at the pivot's distance stays there.
    const QPointF fromCenter = position - QPointF(width() / 2.0, height() / 2.0);
    view_.zoom(factor);
    panByPixels(fromCenter * (1 - factor));
    viewMovedByUser();
}

void Viewport::wheelEvent(QWheelEvent* event) {
    event->accept();
    if (scene_ && event->angleDelta().y() != 0)
        zoomAt(event->position(), std::pow(zoomPerStep, event->angleDelta().y() / wheelStep));
}

void Viewport::keyPressEvent(QKeyEvent* event) {
    const bool shifted = event->modifiers().testFlag(Qt::ShiftModifier);
    const auto move = [&](double right, double up) {
        if (shifted)
            view_.pan(right * panPerKey, up * panPerKey);
        else
            view_.orbit(right * degreesPerKey, up * degreesPerKey);
        viewMovedByUser();
    };
    const int side = event->key() == Qt::Key_Right ? 1 : event->key() == Qt::Key_Left ? -1 : 0;
    if (event->modifiers() == Qt::AltModifier && side != 0 && overlay_.hasDivider())
        return overlay_.setDivider(overlay_.divider() + side * dividerPerKey);
    if (event->modifiers() & (Qt::ControlModifier | Qt::AltModifier | Qt::MetaModifier)) {
        QWidget::keyPressEvent(event);
        return;
    }
    switch (event->key()) {
        case Qt::Key_Left: move(-1, 0); break;
        case Qt::Key_Right: move(1, 0); break;
        case Qt::Key_Up: move(0, 1); break;
        case Qt::Key_Down: move(0, -1); break;
        case Qt::Key_Plus:
        case Qt::Key_Equal: zoomAt(rect().center(), zoomPerStep); break;
        case Qt::Key_Minus: zoomAt(rect().center(), 1 / zoomPerStep); break;
        case Qt::Key_Home: resetView(); break;
        case Qt::Key_Escape: stop(); break;
        default: QWidget::keyPressEvent(event);
    }
}

}  // namespace isoscope
