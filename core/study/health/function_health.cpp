// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/health/function_health.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <deque>
#include <glm/geometric.hpp>
#include <limits>
#include <memory>

#include "core/evaluate/interval_evaluator.h"
#include "core/evaluate/interval_gradient_evaluator.h"
#include "core/evaluate/prepared_function.h"
#include "core/evaluate/tape/loop_stop.h"
#include "core/study/health/ailment_probe.h"
#include "core/study/shape/surface_points.h"
#include "core/study/threshold/critical_study.h"

namespace isoscope {

namespace {

constexpr int raysAlong = 28;
constexpr std::size_t mostPoints = 3000;
/// Parts of accuracy that the surface may be off before that is told.
constexpr double toleratedShare = 0.1;
/// Boxes of a finding that are probed, the nearest to the surface first.
constexpr std::size_t probedBoxes = 24;

struct Leaf {
    GradientBox box;
    double distance = 0;
};

/// What the enclosures do not exclude, by Ailment.
std::array<bool, ailmentCount> suspicions(const IntervalGradient& all) {
    std::array<bool, ailmentCount> may{};
    const auto set = [&](Ailment one) { may[static_cast<std::size_t>(one)] = true; };
    if (all.value.empty() || all.value.maybeUndefined) set(Ailment::undefined);
    if (all.value.empty()) return may;
    if (all.hazard == GradientHazard::jump || all.wrap != 0) set(Ailment::jump);
    if (all.hazard == GradientHazard::steepEdge || all.hazard == GradientHazard::pole ||
        all.hazard == GradientHazard::overflow || all.hazard == GradientHazard::unknown)
        set(Ailment::infinite);
    if (all.hazard == GradientHazard::none && (!all.smooth || all.pieced)) set(Ailment::kink);
    return may;
}

/// A box that is looked into.
struct Room {
    GradientBox box;
    std::shared_ptr<const IntervalGradientEvaluator::Excerpt> excerpt;  ///< what matters there; null for all
};

class Search {
  public:
    Search(const Isosurface& surface, std::span<const double> parameters, const HealthSettings& settings,
           const std::stop_token& stop)
        : surface_(surface),
          settings_(settings),
          domain_(surface.settings().container),
          function_(surface.prepared(parameters)),
          intervals_(*function_),
          points_(surfacePoints(surface, parameters, raysAlong, mostPoints, stop)) {}

    bool empty() const { return domain_.empty(); }

    FunctionHealth run(const std::function<void(double)>& progress, const std::stop_token& stop,
                       const std::stop_token& enough) {
        FunctionHealth health;
        health.resolution = std::max(settings_.fineness, 1.0 / raysAlong) * domain_.box().width();
        health.finished = divide(progress, stop, enough);
        if (stop.stop_requested()) return {};
        for (int kind = 0; kind < ailmentCount; ++kind) report(static_cast<Ailment>(kind), health, stop);
        lookForCancellation(health, stop);
        health.known = !stop.stop_requested();
        if (progress) progress(1);
        return health;
    }

  private:
    /// Whether no box is left over.
    bool divide(const std::function<void(double)>& progress, const std::stop_token& stop,
                const std::stop_token& enough) {
        std::deque<Room> queue{{domain_.box(), {}}};
        const double finest = settings_.fineness * domain_.box().width() * (1 + 1e-9);
        while (!queue.empty() && !stop.stop_requested() && !enough.stop_requested()) {
            const auto [box, within] = queue.front();
            queue.pop_front();
            if (domain_.misses(box)) continue;
            const bool spent = intervals_.evaluations() >= settings_.boxLimit;
            const auto may = suspicions(intervals_.evaluate(box.intervals(), within));
            if (std::ranges::none_of(may, [](bool one) { return one; })) continue;
            const glm::dvec3 middle = box.center();
            if (box.width() <= finest || spent) {
                for (std::size_t kind = 0; kind < ailmentCount; ++kind)
                    if (may[kind]) leaves_[kind].push_back({box, distanceOf(middle)});
                if (box.width() > finest) leftOver_ = true;
                continue;
            }
            int axis = 0;
            for (int k = 1; k < 3; ++k)
                if (box.high[k] - box.low[k] > box.high[axis] - box.low[axis]) axis = k;
            GradientBox first = box, second = box;
            first.high[axis] = second.low[axis] = middle[axis];
            const auto excerpt = intervals_.excerpt(within);
            queue.push_back({first, excerpt});
            queue.push_back({second, excerpt});
            if (progress && intervals_.evaluations() % 1024 == 0)
                progress(0.9 * static_cast<double>(intervals_.evaluations()) /
                         static_cast<double>(settings_.boxLimit));
        }
        return !leftOver_ && queue.empty();
    }

    double distanceOf(const glm::dvec3& place) const {
        double least = std::numeric_limits<double>::infinity();
        for (const glm::dvec3& point : points_) {
            const glm::dvec3 way = point - place;
            least = std::min(least, glm::dot(way, way));
        }
        return std::sqrt(least);
    }

    void report(Ailment ailment, FunctionHealth& health, const std::stop_token& stop) {
        const std::vector<Leaf>& leaves = leaves_[static_cast<std::size_t>(ailment)];
        std::vector<GradientBox> boxes;
        for (const Leaf& leaf : leaves) boxes.push_back(leaf.box);
        AilmentProbe probe(function_, domain_);
        std::vector<HealthFinding> found;
        for (std::vector<std::size_t>& group : touchingBoxes(domain_.box(), boxes)) {
            if (stop.stop_requested()) return;
            std::ranges::sort(group, {}, [&](std::size_t i) { return leaves[i].distance; });
            HealthFinding finding{ailment,
                                  domain_.nearest(leaves[group.front()].box.center()),
                                  leaves[group.front()].box,
                                  false,
                                  0,
                                  leaves[group.front()].distance};
            for (const std::size_t i : group) {
                finding.region.low = glm::min(finding.region.low, boxes[i].low);
                finding.region.high = glm::max(finding.region.high, boxes[i].high);
            }
            for (std::size_t i = 0; i < std::min(probedBoxes, group.size()) && !finding.confirmed; ++i)
                if (const auto met = probe.look(ailment, boxes[group[i]])) {
                    finding.confirmed = true;
                    finding.place = met->place;
                    finding.size = met->size;
                    finding.distance = distanceOf(met->place);
                }
            found.push_back(finding);
        }
        std::ranges::stable_sort(
            found, {}, [](const HealthFinding& one) { return std::pair(!one.confirmed, one.distance); });
        if (found.size() > settings_.findingsOfKind) {
            found.resize(settings_.findingsOfKind);
            health.finished = false;
        }
        health.findings.insert(health.findings.end(), found.begin(), found.end());
    }

    /// The rounding errors of the value at points of the surface, as a length along the gradient.
    void lookForCancellation(FunctionHealth& health, const std::stop_token& stop) {
        IntervalEvaluator values(*function_);
        HealthFinding worst;
        worst.ailment = Ailment::cancellation;
        for (const glm::dvec3& point : points_) {
            if (stop.stop_requested()) return;
            const GradientBox at{point, point};
            const IntervalGradient& all = intervals_.evaluate(at.intervals());
            const double steepness = gradient_rules::lengthBelow(all.slope);
            if (!all.bounded() || !(steepness > 0)) continue;
            const double off = values.evaluate(at.intervals()).width() / steepness;
            if (!(off > worst.size) || !std::isfinite(off)) continue;
            worst.size = off;
            worst.place = point;
        }
        if (!(worst.size > toleratedShare * surface_.rootSettings().accuracy)) return;
        worst.region = {worst.place, worst.place};
        worst.confirmed = true;
        const auto place = std::ranges::find(health.findings, Ailment::kink, &HealthFinding::ailment);
        health.findings.insert(place, worst);
    }

    const Isosurface& surface_;
    HealthSettings settings_;
    GradientDomain domain_;
    std::shared_ptr<const PreparedFunction> function_;
    IntervalGradientEvaluator intervals_;
    std::vector<glm::dvec3> points_;
    std::array<std::vector<Leaf>, ailmentCount> leaves_;
    bool leftOver_ = false;
};

}  // namespace

std::string_view name(Ailment ailment) {
    switch (ailment) {
        case Ailment::undefined: return "undefined";
        case Ailment::infinite: return "infinite";
        case Ailment::jump: return "jump";
        case Ailment::cancellation: return "cancellation";
        case Ailment::kink: break;
    }
    return "kink";
}

std::string_view consequence(Ailment ailment) {
    switch (ailment) {
        case Ailment::undefined:
            return "Where there is no value there is no surface: POV-Ray and the exact picture pass over "
                   "such "
                   "places. select() or max() can give them a value.";
        case Ailment::infinite:
            return "No max_gradient is large enough there: POV-Ray's picture may have holes, the exact one "
                   "has none. Keep such places out of the container, or add a small number under the root or "
                   "in the denominator.";
        case Ailment::jump:
            return "A change of sign across a jump is drawn as a wall: by the exact picture always, by "
                   "POV-Ray where a sample falls on either side.";
        case Ailment::cancellation:
            return "Large terms that nearly cancel leave few digits: both pictures show grain there. Write "
                   "the formula about a nearer centre, or factor it.";
        case Ailment::kink: break;
    }
    return "An edge or crease: harmless for both pictures, but normals turn suddenly there.";
}

FunctionHealth functionHealth(const Isosurface& surface, std::span<const double> parameters,
                              const HealthSettings& settings, const std::function<void(double)>& progress,
                              std::stop_token stop, std::stop_token enough) {
    const LoopStop loops(stop);
    if (stop.stop_requested()) return {};
    Search search(surface, parameters, settings, stop);
    return search.empty() ? FunctionHealth{} : search.run(progress, stop, enough);
}

}  // namespace isoscope
