// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/threshold/critical_study.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <limits>
#include <random>

#include "core/evaluate/prepared_function.h"
#include "core/evaluate/tape/loop_stop.h"

namespace isoscope {

namespace {

/// Widths of boxes that are not halved any more, in those of the container. Near a kink eight boxes are left
/// at each level, so that this costs little.
constexpr double smallest = 0x1p-26;
/// How far boxes overlap, in widths of the container.
constexpr double overhang = 0x1p-32;
/// The kind of wider boxes is not guessed.
constexpr double pointLike = 0.01;
/// Boxes between two looks at progress and stop.
constexpr std::uint64_t slice = 500;
constexpr double noValue = std::numeric_limits<double>::quiet_NaN();

bool encloses(const GradientBox& outer, const GradientBox& inner) {
    for (int k = 0; k < 3; ++k)
        if (!(outer.low[k] <= inner.low[k] && inner.high[k] <= outer.high[k])) return false;
    return true;
}

bool overlap(const GradientBox& a, const GradientBox& b) {
    for (int k = 0; k < 3; ++k)
        if (a.high[k] < b.low[k] || b.high[k] < a.low[k]) return false;
    return true;
}

SuspicionReason reasonFor(const IntervalGradient& whole) {
    if (whole.hazard != GradientHazard::none) return SuspicionReason::steep;
    return NewtonTest::covers(whole) ? SuspicionReason::degenerate : SuspicionReason::kink;
}

}  // namespace

CriticalStudy::CriticalStudy(const std::shared_ptr<const PreparedFunction>& function,
                             const Container& container, CriticalStudySettings settings)
    : domain_(container), settings_(settings), intervals_(*function), values_(function), newton_(intervals_) {
    if (domain_.empty())
        share_ = 0;
    else
        queues_[0].push_back({domain_.box(), Interval::unknown()});
}

double CriticalStudy::volumeShare(const GradientBox& box) const {
    double share = 1;
    for (int k = 0; k < 3; ++k) {
        const double all = domain_.box().high[k] - domain_.box().low[k];
        if (all > 0) share *= (box.high[k] - box.low[k]) / all;
    }
    return share;
}

bool CriticalStudy::step(std::uint64_t boxes, std::stop_token stop) {
    const LoopStop loops(stop);
    const std::uint64_t end = std::min(intervals_.evaluations() + boxes, settings_.boxLimit);
    while (progress() < 1 && intervals_.evaluations() < end && !stop.stop_requested()) {
        // Alternately, so that a wall of kinks takes no more than its half.
        std::deque<Region>& queue = queues_[queues_[turn_].empty() ? 1 - turn_ : turn_];
        turn_ = 1 - turn_;
        const Region region = queue.front();
        queue.pop_front();
        const std::array queued{queues_[0].size(), queues_[1].size()};
        const std::size_t known = known_.size(), left = left_.size();
        const bool jumps = jumps_;
        const double share = share_;
        consider(region);
        if (!stop.stop_requested()) continue;
        // What loops said that were stopped does not count.
        for (std::size_t k = 0; k < queued.size(); ++k) queues_[k].resize(queued[k]);
        known_.resize(known);
        left_.resize(left);
        jumps_ = jumps;
        share_ = share;
        queue.push_front(region);
    }
    return progress() < 1;
}

CriticalPoints CriticalStudy::run(const std::function<void(double)>& progress, std::stop_token stop) {
    while (!stop.stop_requested() && step(slice, stop))
        if (progress) progress(this->progress());
    CriticalPoints answer = stop.stop_requested() ? CriticalPoints{} : points(stop);
    return stop.stop_requested() ? CriticalPoints{} : answer;
}

double CriticalStudy::progress() const {
    if (nothingLeft() || known_.size() >= settings_.pointLimit) return 1;
    return std::min(1.0, static_cast<double>(intervals_.evaluations()) /
                             static_cast<double>(std::max<std::uint64_t>(1, settings_.boxLimit)));
}

void CriticalStudy::consider(const Region& region) {
    // A little wider: a kink on a face is seen from both sides.
    GradientBox box = widened(region.box);
    const double share = volumeShare(region.box);
    const auto dismiss = [&] { share_ = std::max(0.0, share_ - share); };
    if (domain_.misses(box) || isKnown(box)) return dismiss();
    const IntervalGradient whole = intervals_.evaluate(box.intervals());
    if (whole.value.empty()) return dismiss();
    for (int k = 0; k < 3; ++k) {
        const SlopeRange& slope = whole.slope[static_cast<std::size_t>(k)];
        if (!(slope.low > 0) && !(slope.high < 0)) continue;
        jumps_ = jumps_ || whole.hazard == GradientHazard::jump || whole.wrap != 0;
        return dismiss();
    }
    if (whole.isConstant() && whole.bounded() && !whole.value.maybeUndefined) {
        left_.push_back({{box, whole.value}, SuspicionReason::flat});
        return dismiss();
    }
    const Interval values = whole.value;
    const SuspicionReason reason = reasonFor(whole);
    if (NewtonTest::covers(whole) && settledByNewton(box, whole)) return dismiss();
    const bool small = box.width() <= smallest * domain_.box().width();
    const glm::dvec3 center = box.center();
    bool divisible = false;
    for (int k = 0; k < 3; ++k) divisible = divisible || (center[k] > box.low[k] && center[k] < box.high[k]);
    if (small || !divisible) {
        left_.push_back({{box, values}, reason});
        return dismiss();
    }
    // The part that was cut off is done with; what was added belongs to the neighbours.
    box = {glm::max(box.low, region.box.low), glm::min(box.high, region.box.high)};
    if (!(box.low.x <= box.high.x && box.low.y <= box.high.y && box.low.z <= box.high.z)) return dismiss();
    share_ = std::max(0.0, share_ - (share - volumeShare(box)));
    halve({box, values}, queues_[reason == SuspicionReason::degenerate ? 1 : 0]);
}

GradientBox CriticalStudy::widened(const GradientBox& box) const {
    const glm::dvec3 more = overhang * (domain_.box().high - domain_.box().low);
    return {glm::max(box.low - more, domain_.box().low), glm::min(box.high + more, domain_.box().high)};
}

/// Whether nothing more has to be done about the box, which may be shrunk.
bool CriticalStudy::settledByNewton(GradientBox& box, const IntervalGradient& whole) {
    const NewtonVerdict verdict = newton_.test(box, whole);
    if (verdict.kind == NewtonVerdict::Kind::none) return true;
    if (verdict.kind == NewtonVerdict::Kind::one) {
        add(box, newton_.narrow(verdict.rest));
        return true;
    }
    // A zero on a face is inside neither half; a box around it is.
    if (const auto found = newton_.lookAround(box, whole)) add(found->alone, found->rest);
    box = verdict.rest;
    return isKnown(box);
}

bool CriticalStudy::isKnown(const GradientBox& box) const {
    return std::any_of(known_.begin(), known_.end(),
                       [&](const Known& known) { return encloses(known.alone, box); });
}

void CriticalStudy::add(const GradientBox& alone, const GradientBox& rest) {
    // A stop may have made what led here wrong.
    if (LoopStop::requested()) return;
    for (Known& known : known_) {
        if (!overlap(known.point.box, rest)) continue;
        // The same point: a larger box around it dismisses more.
        if (volumeShare(alone) > volumeShare(known.alone)) known.alone = alone;
        return;
    }
    Known known{{}, alone, domain_.misses(rest)};
    for (int k = 0; k < 3; ++k)
        known.outside =
            known.outside || rest.high[k] < domain_.box().low[k] || rest.low[k] > domain_.box().high[k];
    CriticalPoint& point = known.point;
    point.box = rest;
    point.place = rest.center();
    point.value = values_.evaluate(point.place.x, point.place.y, point.place.z);
    point.values = intervals_.evaluate(rest.intervals()).value;
    point.kind = newton_.kindIn(rest);
    if (point.kind == CriticalKind::unknown)
        point.reason = SuspicionReason::degenerate;
    else if (!domain_.contains(rest.low) || !domain_.encloses(rest) || !domain_.contains(rest.high))
        point.reason = SuspicionReason::wall;
    known_.push_back(known);
}

void CriticalStudy::halve(const Region& region, std::deque<Region>& queue) {
    const GradientBox& box = region.box;
    int axis = 0;
    for (int k = 1; k < 3; ++k)
        if (box.high[k] - box.low[k] > box.high[axis] - box.low[axis]) axis = k;
    const double middle = 0.5 * box.low[axis] + 0.5 * box.high[axis];
    Region first = region, second = region;
    first.box.high[axis] = second.box.low[axis] = middle;
    queue.push_back(first);
    queue.push_back(second);
}

CriticalPoints CriticalStudy::points(std::stop_token stop) {
    const LoopStop loops(stop);
    CriticalPoints answer;
    answer.boxes = intervals_.evaluations();
    answer.share = nothingLeft() ? 0 : share_;
    answer.jumps = jumps_;
    answer.finished = nothingLeft();
    for (const Known& known : known_)
        if (!known.outside) answer.points.push_back(known.point);
    std::vector<Left> all = left_;
    for (const std::deque<Region>& queue : queues_)
        for (const Region& region : queue) all.push_back({region, SuspicionReason::unfinished});
    std::vector<GradientBox> boxes;
    for (const Left& left : all) boxes.push_back(left.region.box);
    for (const std::vector<std::size_t>& group : touchingBoxes(domain_.box(), boxes)) {
        std::vector<Left> places;
        for (const std::size_t i : group) places.push_back(all[i]);
        answer.points.push_back(suspected(places, stop));
    }
    // Those without a value come last.
    std::stable_sort(answer.points.begin(), answer.points.end(),
                     [](const CriticalPoint& a, const CriticalPoint& b) {
                         return a.value < b.value || (std::isnan(b.value) && !std::isnan(a.value));
                     });
    return answer;
}

CriticalPoint CriticalStudy::suspected(std::span<const Left> places, const std::stop_token& stop) {
    CriticalPoint point;
    point.box = places.front().region.box;
    point.values = places.front().region.values;
    point.reason = SuspicionReason::unfinished;
    point.value = Interval::infinite;
    double widest = 0;
    for (const auto& [region, reason] : places) {
        point.box.low = glm::min(point.box.low, region.box.low);
        point.box.high = glm::max(point.box.high, region.box.high);
        if (reason != SuspicionReason::unfinished) point.reason = reason;
        widest = std::max(widest, region.box.width());
        point.values = {std::min(point.values.low, region.values.low),
                        std::max(point.values.high, region.values.high),
                        point.values.maybeUndefined || region.values.maybeUndefined};
        const bool first = &region == &places.front().region;
        if (stop.stop_requested() && !first) continue;
        const glm::dvec3 center = domain_.nearest(region.box.center());
        const double value = stop.stop_requested() ? noValue : values_.evaluate(center.x, center.y, center.z);
        if (!(value < point.value) && !first) continue;
        point.place = center;
        point.value = value;
    }
    if (!stop.stop_requested() && widest <= pointLike * domain_.box().width())
        point.kind = guess(point, widest, stop);
    // A value that was cut short is none.
    if (stop.stop_requested()) {
        point.value = noValue;
        point.kind = CriticalKind::unknown;
    }
    return point;
}

/// By the extreme values on a small ball around.
CriticalKind CriticalStudy::guess(const CriticalPoint& point, double reach, const std::stop_token& stop) {
    // So large that curvature can be seen over the slopes of the boxes that are left.
    const double all = domain_.box().width();
    const double radius = std::max(8 * reach, std::min(pointLike * all, 2 * std::sqrt(reach * all)));
    const bool above = highestAround(point.place, radius, 1, stop) > point.values.high;
    const bool below = highestAround(point.place, radius, -1, stop) > -point.values.low;
    if (above && below) return CriticalKind::saddle;
    return above ? CriticalKind::minimum : below ? CriticalKind::maximum : CriticalKind::unknown;
}

/// The largest value of `sign` times the function on a ball, as far as a search finds it. Samples alone do
/// not meet the ridges of kinks.
double CriticalStudy::highestAround(const glm::dvec3& center, double radius, double sign,
                                    const std::stop_token& stop) {
    constexpr int samples = 200, steps = 400;
    constexpr double golden = 2.39996322972865332, last = 1e-5;
    const auto valueAt = [&](const glm::dvec3& direction) {
        const glm::dvec3 p = center + radius * direction;
        return sign * values_.evaluate(p.x, p.y, p.z);
    };
    double highest = -Interval::infinite;
    glm::dvec3 best(1, 0, 0);
    const auto offer = [&](const glm::dvec3& direction) {
        const double value = valueAt(direction);
        if (!(value > highest)) return;
        highest = value;
        best = direction;
    };
    for (int i = 0; i < samples && !stop.stop_requested(); ++i) {
        const double y = 1 - (2 * i + 1.0) / samples, ring = std::sqrt(1 - y * y);
        offer({ring * std::cos(golden * i), y, ring * std::sin(golden * i)});
    }
    std::mt19937 random(1);
    std::normal_distribution<double> number;
    for (int i = 0; i < steps && !stop.stop_requested(); ++i) {
        const double way = 0.2 * std::pow(last, static_cast<double>(i) / steps);
        offer(glm::normalize(best + way * glm::dvec3(number(random), number(random), number(random))));
    }
    return highest;
}

}  // namespace isoscope
