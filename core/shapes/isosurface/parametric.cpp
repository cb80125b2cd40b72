// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/shapes/isosurface/parametric.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <optional>

#include "core/shapes/isosurface/parametric_cells.h"
#include "core/shapes/isosurface/povray_parametric.h"
#include "core/shapes/rays/centered_ray.h"
#include "core/shapes/rays/hit_list.h"

namespace isoscope {

class Parametric::State : public ShapeState {
  public:
    State(const ParametricCells::Tapes& tapes, std::span<const double> parameters,
          const ParametricSettings& settings)
        : cells(tapes, parameters, settings.low, settings.high), povray(tapes, parameters, settings) {}

    ParametricCells cells;
    PovrayParametric povray;
};

namespace {

/// Hits nearer to one another than this, in units of the container, are one, met from two sides of a border.
constexpr double sameHit = 1e-9;

}  // namespace

/// The search along one ray through the cells.
class Parametric::Search {
  public:
    Search(const Parametric& surface, ParametricCells& cells, const Ray& ray, RayInterval interval,
           bool first, TraceContext& context, HitList& hits)
        : surface_(surface),
          cells_(cells),
          ray_(ray),
          line_(ray, (surface.bounds_.low + surface.bounds_.high) / 2.0),
          first_(first),
          context_(context),
          hits_(hits) {
        center_ = (surface.bounds_.low + surface.bounds_.high) / 2.0;
        size_ = glm::length(surface.bounds_.high - surface.bounds_.low);
        slack_ = 1e-12 * (surface.settings_.high - surface.settings_.low);
        if (!line_.usable) return;
        const RayInterval inside = surface.bounds_.clip(ray);
        near_ = std::max(interval.near, inside.near);
        far_ = std::min(interval.far, inside.far);
        const glm::dvec3& d = line_.direction;
        const glm::dvec3 beside = std::abs(d.x) < 0.6 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0);
        planes_[0] = glm::normalize(glm::cross(d, beside));
        planes_[1] = glm::cross(d, planes_[0]);
        for (std::size_t k = 0; k < 2; ++k) {
            offsets_[k] = glm::dot(planes_[k], center_ + line_.origin);
            sizes_[k] = glm::abs(planes_[k]);
        }
    }

    void run() {
        if (line_.usable && near_ <= far_) visit(cells_.root());
        sortHits(hits_, 0);
    }

  private:
    /// What is known of one cell's equations: matrix, value in the middle, and how far both may be off.
    struct Equations {
        std::array<double, 2> value, byU, byV, spread, spreadU, spreadV;
    };

    double enter(const ParametricCell& cell) const {
        const glm::dvec3 room(1e-12 * size_);
        const RayInterval range = Bounds{cell.box.low - room, cell.box.high + room}.clip(ray_);
        return std::max(range.near, near_) <= std::min(range.far, far_) ? range.near : INFINITY;
    }

    void visit(ParametricCell& cell) {
        if (++count_ > cellLimit || context_.stop.stop_requested()) return;
        const glm::dvec2 side = cell.high - cell.low;
        const glm::dvec2 whole = surface_.settings_.high - surface_.settings_.low;
        const bool tiny = side.x <= narrowest * whole.x && side.y <= narrowest * whole.y;
        if (cell.sloped) {
            const Equations equations = equationsOf(cell);
            if (excluded(equations, cell.reach() + slack_)) return;
            bool settled = false;
            if (const std::optional<glm::dvec2> root = solve(cell, equations, settled)) offerRoot(*root);
            if (settled) return;
            // Where the surface is touched, or shrinks to a point, no cell is small enough to tell.
            const glm::dvec3 extent = cell.box.high - cell.box.low;
            if (tiny || glm::length(extent) <= 1e-12 * size_) return offerRoot(cell.middle());
        } else if (tiny) {
            return;
        }
        std::array<ParametricCell, 2> room;
        std::array<ParametricCell, 2>& halves = cells_.split(cell, room);
        const double enters[2] = {enter(halves[0]), enter(halves[1])};
        const std::size_t nearer = enters[1] < enters[0] ? 1 : 0;
        for (const std::size_t k : {nearer, 1 - nearer})
            if (enters[k] < INFINITY && enters[k] <= far_) visit(halves[k]);
    }

    Equations equationsOf(const ParametricCell& cell) const {
        Equations result;
        for (std::size_t k = 0; k < 2; ++k) {
            result.value[k] = glm::dot(planes_[k], cell.center) - offsets_[k];
            result.byU[k] = glm::dot(planes_[k], cell.slopeU);
            result.byV[k] = glm::dot(planes_[k], cell.slopeV);
            result.spread[k] = 2 * cell.centerError + 1e-14 * (std::abs(offsets_[k]) + size_);
            result.spreadU[k] = glm::dot(sizes_[k], cell.spreadU);
            result.spreadV[k] = glm::dot(sizes_[k], cell.spreadV);
        }
        return result;
    }

    /// Whether one of the planes misses the whole cell.
    static bool excluded(const Equations& e, const glm::dvec2& reach) {
        for (std::size_t k = 0; k < 2; ++k) {
            const double most = (std::abs(e.byU[k]) + e.spreadU[k]) * reach.x +
                                (std::abs(e.byV[k]) + e.spreadV[k]) * reach.y + e.spread[k];
            if (std::abs(e.value[k]) > most) return true;
        }
        return false;
    }

    /// The cell's only root, if it has one. `settled` when it is proven that there is no other one.
    std::optional<glm::dvec2> solve(const ParametricCell& cell, const Equations& e, bool& settled) {
        const double determinant = e.byU[0] * e.byV[1] - e.byV[0] * e.byU[1];
        if (!(std::abs(determinant) > 0)) return {};
        const double y00 = e.byV[1] / determinant, y01 = -e.byV[0] / determinant,
                     y10 = -e.byU[1] / determinant, y11 = e.byU[0] / determinant;
        // Krawczyk's test: all roots lie within `room` of the middle + `step`.
        const glm::dvec2 step(-(y00 * e.value[0] + y01 * e.value[1]), -(y10 * e.value[0] + y11 * e.value[1]));
        const glm::dvec2 reach = cell.reach() + slack_;
        const auto off = [&](double a, double b, const std::array<double, 2>& spread) {
            return std::abs(a) * spread[0] + std::abs(b) * spread[1];
        };
        const double uu = off(y00, y01, e.spreadU), uv = off(y00, y01, e.spreadV),
                     vu = off(y10, y11, e.spreadU), vv = off(y10, y11, e.spreadV);
        if (!std::isfinite(uu + uv + vu + vv)) return {};
        const glm::dvec2 room(uu * reach.x + uv * reach.y + off(y00, y01, e.spread),
                              vu * reach.x + vv * reach.y + off(y10, y11, e.spread));
        if (std::abs(step.x) > reach.x + room.x || std::abs(step.y) > reach.y + room.y) {
            settled = true;
            return {};
        }
        // In units of the cell's sides the derivatives differ from a regular matrix by less than 1, so two
        // points of the cell cannot both be roots.
        if (!(uu + uv * reach.y / reach.x < 1 && vv + vu * reach.x / reach.y < 1)) return {};
        const std::optional<glm::dvec2> root = newton(cell, cell.middle() + step);
        settled = root.has_value();
        return root;
    }

    /// Follows Newton's method while it stays near the cell; the answer lies in the cell but for rounding.
    std::optional<glm::dvec2> newton(const ParametricCell& cell, glm::dvec2 uv) {
        const glm::dvec2 side = cell.high - cell.low,
                         whole = surface_.settings_.high - surface_.settings_.low;
        for (int count = 0; count < 12; ++count) {
            if (!(uv.x >= cell.low.x - side.x && uv.x <= cell.high.x + side.x &&
                  uv.y >= cell.low.y - side.y && uv.y <= cell.high.y + side.y))
                return {};
            const ParametricPoint p = cells_.point(uv);
            const double f = glm::dot(planes_[0], p.at) - offsets_[0],
                         g = glm::dot(planes_[1], p.at) - offsets_[1];
            const double fu = glm::dot(planes_[0], p.byU), fv = glm::dot(planes_[0], p.byV),
                         gu = glm::dot(planes_[1], p.byU), gv = glm::dot(planes_[1], p.byV);
            const double determinant = fu * gv - fv * gu;
            const glm::dvec2 step((f * gv - fv * g) / determinant, (fu * g - f * gu) / determinant);
            if (!std::isfinite(step.x) || !std::isfinite(step.y)) return {};
            uv -= step;
            if (std::abs(step.x) <= 1e-13 * whole.x && std::abs(step.y) <= 1e-13 * whole.y) break;
        }
        const bool inside = uv.x >= cell.low.x - slack_.x && uv.x <= cell.high.x + slack_.x &&
                            uv.y >= cell.low.y - slack_.y && uv.y <= cell.high.y + slack_.y;
        if (!inside) return {};
        return glm::clamp(uv, cell.low, cell.high);
    }

    void offerRoot(const glm::dvec2& uv) {
        const ParametricPoint p = cells_.point(uv);
        const glm::dvec3 arm = p.at - center_;
        const double s = glm::dot(arm - line_.origin, line_.direction);
        const double t = line_.toRay(s);
        // Newton's method, or a cell without extent, must have come to the ray itself.
        if (!(glm::distance(arm, line_.at(s)) <= 1e-9 * size_)) return;
        if (!(near_ <= t && t <= far_) || !surface_.containerHolds(p.at)) return;
        for (const Hit& hit : hits_)
            if (std::abs(hit.t - t) * line_.speed <= sameHit * size_) return;
        if (first_) {
            hits_.clear();
            far_ = t;
        }
        hits_.push_back({t, ray_.at(t), unitNormal(glm::cross(p.byU, p.byV))});
    }

    const Parametric& surface_;
    ParametricCells& cells_;
    Ray ray_;
    CenteredRay line_;
    bool first_;
    TraceContext& context_;
    HitList& hits_;
    glm::dvec3 center_{0};
    double size_ = 1;
    /// Roots so little beside a cell count: pi as a double is smaller than pi, and poles have no holes.
    glm::dvec2 slack_{0};
    double near_ = 0;
    double far_ = -1;
    std::array<glm::dvec3, 2> planes_{}, sizes_{};
    std::array<double, 2> offsets_{};
    int count_ = 0;
};

Parametric::Parametric(ParametricSettings settings) : settings_(std::move(settings)) {
    const glm::dvec2 low = glm::min(settings_.low, settings_.high),
                     high = glm::max(settings_.low, settings_.high);
    settings_.low = low;
    settings_.high = high;
    if (const auto* box = std::get_if<ContainerBox>(&settings_.container)) {
        bounds_ = {glm::min(box->low, box->high), glm::max(box->low, box->high)};
    } else {
        const auto& sphere = std::get<ContainerSphere>(settings_.container);
        const glm::dvec3 reach(std::abs(sphere.radius));
        bounds_ = {sphere.center - reach, sphere.center + reach};
    }
    for (std::size_t k = 0; k < 3; ++k) tapes_[k] = Tape::compile(settings_.functions[k]);
}

bool Parametric::containerHolds(const glm::dvec3& point) const {
    if (!bounds_.contains(point)) return false;
    const auto* sphere = std::get_if<ContainerSphere>(&settings_.container);
    return !sphere || glm::distance(point, sphere->center) <= std::abs(sphere->radius);
}

Parametric::State& Parametric::stateOf(TraceContext& context) const {
    return context.state<State>(
        this, [&] { return std::make_unique<State>(tapes_, context.parameters(), settings_); });
}

void Parametric::trace(const Ray& ray, RayInterval interval, bool first, TraceContext& context,
                       HitList& hits) const {
    ++context.rays;
    ParametricCells& cells = stateOf(context).cells;
    const std::uint64_t before = cells.evaluations();
    Search(*this, cells, ray, interval, first, context, hits).run();
    context.evaluations += cells.evaluations() - before;
}

RayInterval Parametric::containerPart(const Ray& ray) const {
    const auto* sphere = std::get_if<ContainerSphere>(&settings_.container);
    if (!sphere) return bounds_.clip(ray);
    const CenteredRay line(ray, sphere->center);
    const double square = sphere->radius * sphere->radius - glm::dot(line.origin, line.origin);
    if (!line.usable || !(square >= 0)) return {0, -1};
    return {line.toRay(-std::sqrt(square)), line.toRay(std::sqrt(square))};
}

bool Parametric::traceAsPovray(const Ray& ray, RayInterval interval, TraceContext& context,
                               HitList& hits) const {
    const RayInterval inside = containerPart(ray);
    interval = {std::max(interval.near, inside.near), std::min(interval.far, inside.far)};
    if (interval.empty()) return true;
    PovrayParametric& povray = stateOf(context).povray;
    const std::uint64_t before = povray.evaluations();
    const std::optional<Hit> hit = povray.nearest(ray, interval, context.stop);
    context.evaluations += povray.evaluations() - before;
    if (hit) hits.push_back(*hit);
    return hit.has_value();
}

void Parametric::intersect(const Ray& ray, RayInterval interval, TraceContext& context, HitList& hits) const {
    HitList own;
    trace(ray, interval, false, context, own);
    hits.insert(hits.end(), own.begin(), own.end());
}

void Parametric::nearest(std::span<const Ray> rays, TraceContext& context,
                         std::span<NearestHit> nearest) const {
    const bool asPovray =
        context.rootFinder == RootFinder::lipschitz && PovrayParametric::appliesTo(settings_);
    traceOneByOne(rays, context.nearLimit, nearest, [&](const Ray& ray, RayInterval interval, HitList& hits) {
        if (!asPovray || !traceAsPovray(ray, interval, context, hits))
            trace(ray, interval, true, context, hits);
    });
}

}  // namespace isoscope
