// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/range/parameter_range.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>

#include "core/evaluate/prepared_function.h"
#include "core/evaluate/tape/loop_stop.h"
#include "core/function/graph_copy.h"

namespace isoscope {

namespace {

constexpr std::size_t pointCount = 512;
/// Steps of the search for a lower, or higher, value than those of the points.
constexpr int improvements = 48;
/// Widths of boxes that are not halved any more, in those of the container.
constexpr double smallest = 0x1p-12;

void append(ParameterRange& range, const PresencePiece& piece) {
    if (!range.pieces.empty() && range.pieces.back().presence == piece.presence)
        range.pieces.back().high = piece.high;
    else
        range.pieces.push_back(piece);
}

bool excluded(SurfacePresence presence) {
    return presence == SurfacePresence::outside || presence == SurfacePresence::inside;
}

}  // namespace

std::string_view name(SurfacePresence presence) {
    switch (presence) {
        case SurfacePresence::surface: return "surface";
        case SurfacePresence::outside: return "outside";
        case SurfacePresence::inside: return "inside";
        case SurfacePresence::unknown: break;
    }
    return "unknown";
}

std::optional<std::pair<double, double>> ParameterRange::shown() const {
    std::optional<std::pair<double, double>> all;
    for (const PresencePiece& piece : pieces) {
        if (excluded(piece.presence)) continue;
        if (!all) all = {piece.low, piece.high};
        all->second = piece.high;
    }
    return all;
}

double ParameterRange::provenShare() const {
    const auto whole = shown();
    if (!whole) return 0;
    if (!(whole->second > whole->first)) return at(whole->first) == SurfacePresence::surface ? 1 : 0;
    double proven = 0;
    for (const PresencePiece& piece : pieces)
        if (piece.presence == SurfacePresence::surface) proven += piece.high - piece.low;
    return std::clamp(proven / (whole->second - whole->first), 0.0, 1.0);
}

SurfacePresence ParameterRange::at(double value) const {
    for (const PresencePiece& piece : pieces)
        if (piece.low <= value && value <= piece.high) return piece.presence;
    return SurfacePresence::unknown;
}

ParameterRange united(std::span<const ParameterRange> ranges) {
    if (ranges.size() == 1) return ranges.front();
    ParameterRange all;
    std::vector<double> ends;
    for (const ParameterRange& range : ranges) {
        all.boxes += range.boxes;
        for (const PresencePiece& piece : range.pieces) ends.insert(ends.end(), {piece.low, piece.high});
    }
    std::ranges::sort(ends);
    ends.erase(std::unique(ends.begin(), ends.end()), ends.end());
    for (std::size_t i = 1; i < ends.size(); ++i) {
        SurfacePresence presence = SurfacePresence::outside;
        const auto rank = [](SurfacePresence one) {
            return one == SurfacePresence::surface   ? 3
                   : one == SurfacePresence::unknown ? 2
                   : one == SurfacePresence::inside  ? 1
                                                     : 0;
        };
        for (const ParameterRange& range : ranges) {
            const SurfacePresence one = range.at(0.5 * ends[i - 1] + 0.5 * ends[i]);
            if (rank(one) > rank(presence)) presence = one;
        }
        append(all, {ends[i - 1], ends[i], presence});
    }
    return all;
}

RangeStudy::RangeStudy(std::shared_ptr<const Isosurface> surface, std::span<const double> parameters,
                       int slot, RangeSettings settings)
    : surface_(std::move(surface)),
      parameters_(parameters.begin(), parameters.end()),
      slot_(slot),
      settings_(settings),
      domain_(surface_->settings().container) {
    if (domain_.empty()) return;
    points_ = spreadPoints(domain_, pointCount);
    if (slot_ == threshold) {
        intervals_.emplace(*surface_->prepared(parameters_));
        return;
    }
    if (static_cast<std::size_t>(slot_) >= parameters_.size()) return;
    const Function free = withFreeParameter(surface_->settings().function, slot_);
    if (free.valid()) intervals_.emplace(Tape::compile(free), std::span<const double>(parameters_));
}

ParameterRange RangeStudy::run(double low, double high, std::stop_token stop) {
    ParameterRange range;
    if (!std::isfinite(low) || !std::isfinite(high) || !(low <= high)) return range;
    const LoopStop loops(stop);
    boxes_ = 0;
    look(low, high, settings_.resolution * (high - low), range, stop);
    range.boxes = boxes_;
    return range;
}

ParameterRange RangeStudy::run(std::span<const double> values, std::stop_token stop) {
    ParameterRange range;
    const LoopStop loops(stop);
    boxes_ = 0;
    for (const double value : values) append(range, {value, value, presenceOver(value, value, stop)});
    range.boxes = boxes_;
    return range;
}

void RangeStudy::look(double low, double high, double finest, ParameterRange& range,
                      const std::stop_token& stop) {
    const SurfacePresence presence = presenceOver(low, high, stop);
    const double middle = 0.5 * low + 0.5 * high;
    if (presence != SurfacePresence::unknown || high - low <= finest || !(middle > low && middle < high) ||
        boxes_ >= settings_.boxLimit || stop.stop_requested() || !intervals_)
        return append(range, {low, high, presence});
    look(low, middle, finest, range, stop);
    look(middle, high, finest, range, stop);
}

SurfacePresence RangeStudy::presenceOver(double low, double high, const std::stop_token& stop) {
    if (!intervals_ || points_.x.empty() || stop.stop_requested()) return SurfacePresence::unknown;
    sample(0.5 * low + 0.5 * high);
    if (lowest_.value >= 0) improve(lowest_, -1);
    if (highest_.value <= 0) improve(highest_, 1);
    if (stop.stop_requested()) return SurfacePresence::unknown;
    if (lowest_.value < 0 && highest_.value > 0) {
        if (signsDiffer(low, high)) return SurfacePresence::surface;
        improve(lowest_, -1);
        improve(highest_, 1);
        return signsDiffer(low, high) ? SurfacePresence::surface : SurfacePresence::unknown;
    }
    const int sign = lowest_.value > 0 ? 1 : highest_.value < 0 ? -1 : 0;
    if (sign == 0 || !keepsSign(sign, low, high, stop)) return SurfacePresence::unknown;
    const bool isInside = (sign < 0) != surface_->settings().positivePolarity;
    return isInside ? SurfacePresence::inside : SurfacePresence::outside;
}

/// Whether the lowest and the highest place lie on different sides for the whole piece.
bool RangeStudy::signsDiffer(double low, double high) {
    const auto at = [&](const glm::dvec3& p) {
        return enclosure({Interval::point(p.x), Interval::point(p.y), Interval::point(p.z)}, low, high);
    };
    const Interval below = at(lowest_.place), above = at(highest_.place);
    return !below.maybeUndefined && !above.maybeUndefined && below.high < 0 && above.low > 0 &&
           !LoopStop::requested();
}

/// Sets lowest_ and highest_ to those of the points, for one value of the parameter.
void RangeStudy::sample(double value) {
    level_ = slot_ == threshold ? value : surface_->settings().threshold;
    std::vector<double> table = parameters_;
    if (slot_ != threshold) table[static_cast<std::size_t>(slot_)] = value;
    values_.emplace(surface_->prepared(parameters_)->with(table));
    std::vector<double> all(points_.x.size());
    values_->evaluate(points_.x, points_.y, points_.z, all);
    lowest_ = {Interval::infinite, domain_.box().center()};
    highest_ = {-Interval::infinite, domain_.box().center()};
    for (std::size_t i = 0; i < all.size(); ++i) {
        const glm::dvec3 place(points_.x[i], points_.y[i], points_.z[i]);
        if (all[i] - level_ < lowest_.value) lowest_ = {all[i] - level_, place};
        if (all[i] - level_ > highest_.value) highest_ = {all[i] - level_, place};
    }
}

double RangeStudy::signedValue(const glm::dvec3& place) {
    return values_->evaluate(place.x, place.y, place.z) - level_;
}

/// Looks along the axes for a larger value of `sign` times the function, with ever shorter steps.
void RangeStudy::improve(Extreme& extreme, double sign) {
    glm::dvec3 step = 0.125 * (domain_.box().high - domain_.box().low);
    for (int i = 0; i < improvements; ++i) {
        const Extreme before = extreme;
        for (int k = 0; k < 3; ++k)
            for (const double way : {-1.0, 1.0}) {
                glm::dvec3 place = extreme.place;
                place[k] += way * step[k];
                place = domain_.nearest(glm::clamp(place, domain_.box().low, domain_.box().high));
                const double value = signedValue(place);
                if (sign * value > sign * extreme.value) extreme = {value, place};
            }
        if (extreme.value == before.value) step *= 0.5;
    }
}

Interval RangeStudy::enclosure(const std::array<Interval, 3>& place, double low, double high) {
    ++boxes_;
    const Interval varied{low, high, false};
    if (slot_ == threshold) return intervals_->evaluate(place) - varied;
    const std::array<Interval, 4> arguments{place[0], place[1], place[2], varied};
    return intervals_->evaluate(arguments) - Interval::point(surface_->settings().threshold);
}

/// Whether the function less the threshold has this sign in the whole container, for the whole piece.
bool RangeStudy::keepsSign(int sign, double low, double high, const std::stop_token& stop) {
    const std::uint64_t end = boxes_ + settings_.boxesOfPiece;
    std::vector<GradientBox> boxes{domain_.box()};
    const double finest = smallest * domain_.box().width();
    while (!boxes.empty()) {
        if (boxes_ >= end || stop.stop_requested()) return false;
        const GradientBox box = boxes.back();
        boxes.pop_back();
        if (domain_.misses(box)) continue;
        const Interval values = enclosure(box.intervals(), low, high);
        if (LoopStop::requested()) return false;
        // Where it is undefined it has no root.
        if (values.empty() || (sign > 0 ? values.low > 0 : values.high < 0)) continue;
        if (box.width() <= finest) return false;
        int axis = 0;
        for (int k = 1; k < 3; ++k)
            if (box.high[k] - box.low[k] > box.high[axis] - box.low[axis]) axis = k;
        const double middle = 0.5 * box.low[axis] + 0.5 * box.high[axis];
        if (!(middle > box.low[axis] && middle < box.high[axis])) return false;
        GradientBox first = box, second = box;
        first.high[axis] = second.low[axis] = middle;
        boxes.push_back(first);
        boxes.push_back(second);
    }
    return true;
}

}  // namespace isoscope
