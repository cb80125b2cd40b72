// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <QColor>
#include <QObject>
#include <stop_token>

#include "core/study/view/point_probe.h"
#include "widgets/latest_worker.h"

class QPalette;

namespace isoscope {

/// The point that all views of a scene share: one of them tells where mouse or keys are, the others show that
/// point. What the function is there is computed in the background, newest point first; it follows the scene
/// for as long as the point is held. Belongs to the thread of the window.
class LinkedProbe : public QObject {
    Q_OBJECT
  public:
    explicit LinkedProbe(QObject* parent = nullptr);
    ~LinkedProbe() override;

    /// Null forgets the point.
    void setScene(std::shared_ptr<const Scene> scene);
    /// The ray of the picture through a point of the world, by which the point may be hidden; nothing where
    /// the picture does not show it. Called in another thread.
    using Sight = std::function<std::optional<Ray>(const glm::dvec3&)>;
    /// Tells the present view: after every change of it. Without one no point is seen.
    void setSight(Sight sight);

    /// `source`, never dereferenced, probes this place, in the coordinates of that isosurface's function ...
    void probe(const QObject* source, std::size_t isosurface, const glm::dvec3& place);
    /// ... or what this ray of the world meets first.
    void probeRay(const QObject* source, const Ray& ray);
    /// Forgets the point if it is that of `source`.
    void release(const QObject* source);

    /// The latest point that is known; nothing while none is probed.
    const std::optional<ProbedPoint>& point() const { return point_; }
    /// Whose point it is; null for none.
    const QObject* source() const { return source_; }
    /// Something in the picture lies in front of the point, or the picture does not show it.
    bool hidden() const { return hidden_; }
    /// What was asked for last is known.
    bool upToDate() const { return pending_ == 0; }
    /// Coordinates and probeValues() for the status line; empty without a point.
    QString text() const;

  signals:
    /// Another point, none any more, or the same of a scene or view that has changed.
    void changed();

  private:
    struct Order {
        std::size_t isosurface = 0;
        glm::dvec3 place{0};
        std::optional<Ray> ray;  ///< instead of the place
    };

    void take(const QObject* source, const Order& order);
    void look();
    void receive(const std::optional<ProbedPoint>& point, bool hidden);
    void forget();

    std::shared_ptr<const Scene> scene_;
    Sight sight_;
    std::optional<Order> order_;
    const QObject* source_ = nullptr;
    std::optional<ProbedPoint> point_;
    bool hidden_ = false;
    std::unique_ptr<PointProbe> probe_;  ///< of the latest scene; the worker's alone
    std::stop_source stop_;
    std::uint64_t generation_ = 0;
    int pending_ = 0;
    LatestWorker worker_;  // last: its tasks refer to the object
};

/// What marks the probed point in charts and sections, on grounds of this palette.
QColor probeColor(const QPalette& palette);
/// "f 0.25, |∇f| 3.2, distance 0.08", without a distance on the surface, or that f is undefined there.
QString probeValues(const ProbedPoint& point);

}  // namespace isoscope
