// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/linked_probe.h"

#include <cmath>
#include <utility>

#include "widgets/either_stop.h"
#include "widgets/look.h"

namespace isoscope {

namespace {

QString numberOf(double value) {
    if (std::isnan(value)) return LinkedProbe::tr("undefined");
    if (std::isinf(value)) return LinkedProbe::tr("infinite");
    return QString::number(std::abs(value) < 1e-12 ? 0 : value, 'g', 5);
}

}  // namespace

LinkedProbe::LinkedProbe(QObject* parent) : QObject(parent) {}

LinkedProbe::~LinkedProbe() { stop_.request_stop(); }

void LinkedProbe::setScene(std::shared_ptr<const Scene> scene) {
    if (scene == scene_) return;
    scene_ = std::move(scene);
    if (!scene_) return forget();
    if (order_) look();
}

void LinkedProbe::setSight(Sight sight) {
    sight_ = std::move(sight);
    if (order_) look();
}

void LinkedProbe::probe(const QObject* source, std::size_t isosurface, const glm::dvec3& place) {
    take(source, {isosurface, place, {}});
}

void LinkedProbe::probeRay(const QObject* source, const Ray& ray) { take(source, {0, {}, ray}); }

void LinkedProbe::take(const QObject* source, const Order& order) {
    source_ = source;
    order_ = order;
    look();
}

void LinkedProbe::release(const QObject* source) {
    if (source_ && source == source_) forget();
}

void LinkedProbe::forget() {
    stop_.request_stop();
    ++generation_;
    pending_ = 0;
    order_.reset();
    source_ = nullptr;
    if (!std::exchange(point_, std::nullopt)) return;
    emit changed();
}

void LinkedProbe::look() {
    if (!scene_ || !order_) return;
    stop_.request_stop();
    stop_ = std::stop_source();
    pending_ = 1;
    worker_.submit([this, scene = scene_, order = *order_, sight = sight_, generation = ++generation_,
                    stop = stop_.get_token()](std::stop_token closing) {
        const EitherStop either(stop, closing);
        const std::stop_token token = either.token();
        if (!probe_ || probe_->scene() != scene) probe_ = std::make_unique<PointProbe>(scene);
        const std::optional<ProbedPoint> point = order.ray ? probe_->seenAlong(*order.ray, token)
                                                           : probe_->at(order.isosurface, order.place, token);
        const auto ray = point && sight ? sight(point->inScene) : std::nullopt;
        const bool hidden = point && (!ray || probe_->hides(*ray, point->inScene, token));
        if (either.requested()) return;
        QMetaObject::invokeMethod(
            this,
            [this, generation, point, hidden] {
                if (generation == generation_) receive(point, hidden);
            },
            Qt::QueuedConnection);
    });
}

void LinkedProbe::receive(const std::optional<ProbedPoint>& point, bool hidden) {
    pending_ = 0;
    const bool nothing = !point && !point_;
    point_ = point;
    hidden_ = hidden;
    if (!nothing) emit changed();
}

QString LinkedProbe::text() const {
    if (!point_) return {};
    const glm::dvec3& p = point_->place;
    return tr("x %1, y %2, z %3: %4").arg(numberOf(p.x), numberOf(p.y), numberOf(p.z), probeValues(*point_));
}

QColor probeColor(const QPalette& palette) { return lookColor(lookOf(palette), 0x9c1fa8, 0xe87bf5); }

QString probeValues(const ProbedPoint& point) {
    if (std::isnan(point.value)) return LinkedProbe::tr("f is undefined");
    // What root finders leave of a zero is none.
    const double value = std::abs(point.value) < 1e-8 * point.slope ? 0 : point.value;
    const QString text = LinkedProbe::tr("f %1, |∇f| %2").arg(numberOf(value), numberOf(point.slope));
    const double distance = point.distance();
    constexpr double noticeable = 1e-6;  // root finders leave less
    return std::abs(distance) > noticeable ? LinkedProbe::tr("%1, distance %2").arg(text, numberOf(distance))
                                           : text;
}

}  // namespace isoscope
