// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/viewport/plane_handle.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <QLineF>
#include <QPainter>

namespace isoscope {

namespace {

constexpr double knobRadius = 6;
constexpr double gripReach = 11;
/// Length of the normal, as a share of the container.
constexpr double normalShare = 0.4;
/// A normal that points at the camera is shorter than this on the screen; up and down then move the plane.
constexpr double shortest = 24;
const QColor tone(0xff, 0xe0, 0x60);

}  // namespace

void PlaneHandle::setShown(bool shown) {
    if (shown == shown_) return;
    shown_ = shown;
    emit changed();
}

void PlaneHandle::setPlane(const SectionPlane& plane, const Container& container, const Transform& toWorld) {
    subject_ = Subject{plane, container, toWorld};
    if (shown_) emit changed();
}

void PlaneHandle::clear() {
    if (!subject_) return;
    subject_.reset();
    grip_ = Grip::none;
    emit changed();
}

double PlaneHandle::reach() const {
    const Bounds bounds = containerBounds(subject_->container);
    const glm::dvec3 size = bounds.high - bounds.low;
    return normalShare * std::max({size.x, size.y, size.z});
}

std::optional<QPointF> PlaneHandle::pixelOf(const glm::dvec3& point, const ViewProjection& view) const {
    return view.pixelOf(subject_->toWorld.point(point));
}

std::optional<QPointF> PlaneHandle::movePixel(const ViewProjection& view) const {
    if (!shown_ || !subject_) return {};
    return pixelOf(subject_->plane.middle(subject_->container), view);
}

std::optional<QPointF> PlaneHandle::turnPixel(const ViewProjection& view) const {
    if (!shown_ || !subject_) return {};
    return pixelOf(subject_->plane.middle(subject_->container) + reach() * subject_->plane.normal(), view);
}

PlaneHandle::Grip PlaneHandle::gripAt(const QPointF& pixel, const ViewProjection& view) const {
    const auto near = [&](const std::optional<QPointF>& knob) {
        return knob && QLineF(*knob, pixel).length() <= gripReach;
    };
    // Where one covers the other, the one that moves is drawn above.
    if (near(movePixel(view))) return Grip::move;
    return near(turnPixel(view)) ? Grip::turn : Grip::none;
}

void PlaneHandle::hover(const QPointF& pixel, const ViewProjection& view) {
    const Grip grip = gripAt(pixel, view);
    if (grip == hovered_) return;
    hovered_ = grip;
    emit changed();
}

void PlaneHandle::press(const QPointF& pixel, const ViewProjection& view) {
    grip_ = gripAt(pixel, view);
    if (grip_ == Grip::none) return;
    pressed_ = pixel;
    pressedPosition_ = subject_->plane.position();
    const glm::dvec3 middle = subject_->plane.middle(subject_->container);
    const glm::dvec3 tip = middle + reach() * subject_->plane.normal();
    const Ray ray = subject_->toWorld.toObject(view.rayAt(pixel));
    turnsInFront_ = glm::dot(tip - middle, ray.direction) <= 0;
    const auto from = pixelOf(middle, view), to = pixelOf(tip, view);
    perUnit_ = from && to ? (*to - *from) / reach() : QPointF();
    if (QLineF({}, perUnit_).length() * reach() < shortest)
        perUnit_ = QPointF(0, turnsInFront_ ? 1 : -1) * (shortest * 4 / reach());
    emit changed();
}

void PlaneHandle::drag(const QPointF& pixel, const ViewProjection& view) {
    if (!subject_) return;
    if (grip_ == Grip::move) dragAlong(pixel, view);
    if (grip_ == Grip::turn) dragAround(pixel, view);
}

void PlaneHandle::release() {
    grip_ = Grip::none;
    emit changed();
}

void PlaneHandle::dragAlong(const QPointF& pixel, const ViewProjection&) {
    const double square = QPointF::dotProduct(perUnit_, perUnit_);
    if (!(square > 0)) return;
    const SectionTravel travel = travelOf(subject_->plane, subject_->container);
    const double by = QPointF::dotProduct(pixel - pressed_, perUnit_) / square;
    emit moved(std::clamp(pressedPosition_ + by, travel.low, travel.high));
}

/// The knob follows the mouse over a sphere around the plane's middle.
void PlaneHandle::dragAround(const QPointF& pixel, const ViewProjection& view) {
    const Ray ray = subject_->toWorld.toObject(view.rayAt(pixel));
    const double length = glm::length(ray.direction);
    if (!(length > 0) || !std::isfinite(length)) return;
    const glm::dvec3 d = ray.direction / length, middle = subject_->plane.middle(subject_->container);
    const double along = glm::dot(middle - ray.origin, d);
    const glm::dvec3 nearest = ray.origin + along * d - middle;
    const double depth = reach() * reach() - glm::dot(nearest, nearest);
    // Outside of the sphere the knob keeps to its rim, as it is seen from here.
    const glm::dvec3 sight = glm::normalize(middle - ray.origin);
    const glm::dvec3 normal = depth > 0 ? nearest + (turnsInFront_ ? -1 : 1) * std::sqrt(depth) * d
                                        : nearest - glm::dot(nearest, sight) * sight;
    const double size = glm::length(normal);
    if (!(size > 0) || !std::isfinite(size)) return;
    emit turned(normal.x / size, normal.y / size, normal.z / size);
}

void PlaneHandle::paint(QPainter& painter, const ViewProjection& view) const {
    if (!shown_ || !subject_) return;
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    paintOutline(painter, view);
    paintKnobs(painter, view);
    painter.restore();
}

void PlaneHandle::paintOutline(QPainter& painter, const ViewProjection& view) const {
    QPolygonF outline;
    for (const glm::dvec2& corner : sectionOutline(subject_->plane, subject_->container))
        if (const auto pixel = pixelOf(subject_->plane.at(corner.x, corner.y), view)) outline << *pixel;
    QColor veil = tone;
    veil.setAlpha(38);
    painter.setBrush(veil);
    // Seen on light and dark pictures.
    painter.setPen(QPen(QColor(0, 0, 0, 140), 3));
    painter.drawPolygon(outline);
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen(tone, 1.5));
    painter.drawPolygon(outline);
}

void PlaneHandle::paintKnobs(QPainter& painter, const ViewProjection& view) const {
    const auto middle = movePixel(view), tip = turnPixel(view);
    if (middle && tip) {
        for (const QPen& pen : {QPen(QColor(0, 0, 0, 140), 4), QPen(tone, 2)}) {
            painter.setPen(pen);
            painter.drawLine(*middle, *tip);
        }
    }
    const auto knob = [&](const QPointF& at, Grip grip) {
        const bool lit = grip == grip_ || (grip_ == Grip::none && grip == hovered_);
        const double radius = lit ? knobRadius + 2 : knobRadius;
        painter.setPen(QPen(QColor(0x20, 0x20, 0x20), 1.5));
        painter.setBrush(lit ? QColor(Qt::white) : tone);
        if (grip == Grip::turn)
            painter.drawEllipse(at, radius, radius);
        else
            painter.drawRect(QRectF(at - QPointF(radius, radius), QSizeF(2 * radius, 2 * radius)));
    };
    if (tip) knob(*tip, Grip::turn);
    if (middle) knob(*middle, Grip::move);
}

}  // namespace isoscope
