// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/roots/lipschitz/lipschitz_lanes.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace isoscope {

namespace {

constexpr std::uint64_t bit(std::size_t lane) { return std::uint64_t{1} << lane; }

}  // namespace

LipschitzLanes::LipschitzLanes(const RootSettings& settings) : settings_(settings) {
    memory_.bound = settings.maxGradient;
    limits_.threshold = settings.threshold;
    limits_.accuracy = settings.accuracy;
}

void LipschitzLanes::place(std::size_t lane, const LineQuery& query) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
        state_.origin[axis][lane] = query.origin[static_cast<int>(axis)];
        state_.direction[axis][lane] = query.direction[static_cast<int>(axis)];
    }
}

bool LipschitzLanes::start(std::size_t lane, const HalvingInterval& interval) {
    state_.start[lane] = interval.start;
    state_.startValue[lane] = state_.lowest[lane] = interval.startValue;
    state_.end[lane] = interval.end;
    state_.endValue[lane] = interval.endValue;
    state_.reach[lane] = memory_.bound * interval.speed * (interval.end - interval.start);
    state_.speed[lane] = interval.speed;
    state_.sign[lane] = settings_.positivePolarity ? -interval.sign : interval.sign;
    pendingCount_[lane] = 0;
    found_ &= ~bit(lane);
    noteNextSlopeAbove();
    if (!examine(lane)) return false;
    halving_ |= bit(lane);
    return true;
}

void LipschitzLanes::move(std::size_t from, std::size_t to) {
    for (HalvingState::Lanes* lanes :
         {&state_.start, &state_.startValue, &state_.end, &state_.endValue, &state_.reach, &state_.wanted,
          &state_.lowest, &state_.sign, &state_.speed})
        (*lanes)[to] = (*lanes)[from];
    for (std::size_t axis = 0; axis < 3; ++axis) {
        state_.origin[axis][to] = state_.origin[axis][from];
        state_.direction[axis][to] = state_.direction[axis][from];
    }
    halving_ = (halving_ & ~bit(to)) | (halving_ >> from & 1) << to;
    found_ = (found_ & ~bit(to)) | (found_ >> from & 1) << to;
    halving_ &= ~bit(from);
    pendingCount_[to] = pendingCount_[from];
    for (std::size_t depth = 0; depth < pendingCount_[to]; ++depth)
        pending_[depth * limit + to] = pending_[depth * limit + from];
}

inline void LipschitzLanes::putAside(std::size_t lane, const Pending& pending) {
    const std::size_t place = pendingCount_[lane]++ * limit + lane;
    if (place >= pending_.size()) pending_.resize(pending_.size() + 16 * limit);
    pending_[place] = pending;
}

/// Returns whether the interval is known to be in need of halving.
inline bool LipschitzLanes::takePending(std::size_t lane) {
    const Pending& pending = pending_[--pendingCount_[lane] * limit + lane];
    // All reads before the writes, which might be to the same place for all that the compiler knows.
    const double start = pending.start, startValue = pending.startValue;
    const double end = pending.end, endValue = pending.endValue, reach = pending.reach;
    state_.start[lane] = start;
    state_.startValue[lane] = startValue;
    state_.end[lane] = end;
    state_.endValue[lane] = endValue;
    state_.reach[lane] = std::abs(reach);
    state_.wanted[lane] = (start + end) / 2;
    return !std::signbit(reach);
}

/// Goes on with an interval that waits; false when there is none, or a root was found.
inline bool LipschitzLanes::next(std::size_t lane) {
    if (pendingCount_[lane] == 0) return false;
    return takePending(lane) || examine(lane);
}

std::uint64_t LipschitzLanes::advance(std::span<const double> values) {
    // The lanes that only asked are carried along: they keep what they want in LipschitzSearch.
    const HalvingStep step = halve(state_, values.data(), values.size(), limits_);
    forEachLane(step.bothHalves & halving_, [&](std::size_t lane) {
        // The middle is now the end of the left half.
        putAside(lane, {state_.end[lane], state_.endValue[lane], state_.asideEnd[lane],
                        state_.asideEndValue[lane], state_.reach[lane]});
    });
    std::uint64_t ended = 0;
    forEachLane(step.neitherHalf & halving_, [&](std::size_t lane) {
        if (!next(lane)) ended |= bit(lane);
    });
    forEachLane(step.special & halving_, [&](std::size_t lane) {
        if (!stepExactly(lane, values[lane])) ended |= bit(lane);
    });
    halving_ &= ~ended;
    return ended;
}

HalvingResult LipschitzLanes::result(std::size_t lane) const {
    return {(found_ & bit(lane)) != 0, state_.end[lane], state_.lowest[lane]};
}

/// Both halves of the lane's interval by the rules themselves; false when the halving is over.
bool LipschitzLanes::stepExactly(std::size_t lane, double value) {
    const double middle = state_.wanted[lane];
    const double here = state_.sign[lane] * (value - settings_.threshold);
    const double reach = state_.reach[lane] / 2;
    putAside(lane, {middle, here, state_.end[lane], state_.endValue[lane], -reach});
    state_.end[lane] = middle;
    state_.endValue[lane] = here;
    state_.reach[lane] = reach;
    return examine(lane);
}

/// Looks at the lane's interval, and at those that wait as long as there is nothing to halve; false when none
/// is left, or a root was found.
bool LipschitzLanes::examine(std::size_t lane) {
    for (;;) {
        const double start = state_.start[lane];
        const double end = state_.end[lane];
        const double endValue = state_.endValue[lane];
        const double width = end - start;
        // Most intervals show nothing new: a division each would cost more than the rest of the step.
        const double change = std::abs(endValue - state_.startValue[lane]);
        if (change > limits_.noteworthy * (width * state_.speed[lane]))
            noteSlope(lane, change / (width * state_.speed[lane]), width);
        state_.lowest[lane] = std::min(state_.lowest[lane], endValue);
        const double middle = (start + end) / 2;
        const bool divisible = width >= settings_.accuracy && start < middle && middle < end;
        if (!divisible && endValue < 0) {
            found_ |= bit(lane);
            return false;
        }
        state_.wanted[lane] = middle;
        // Written so that a NaN ends the interval.
        if (divisible && state_.startValue[lane] + endValue - state_.reach[lane] < 0) return true;
        if (pendingCount_[lane] == 0) return false;
        if (takePending(lane)) return true;
    }
}

void LipschitzLanes::noteSlope(std::size_t lane, double slope, double width) {
    if (!std::isfinite(slope)) return;
    if (slope > memory_.steepest) memory_.steepest = slope;
    if (settings_.evaluate) {
        const double safety = (*settings_.evaluate)[1];
        if (slope * safety > memory_.bound && std::isfinite(slope * safety * safety)) {
            memory_.bound = slope * safety * safety;
            state_.reach[lane] = memory_.bound * state_.speed[lane] * width;
        }
    }
    noteNextSlopeAbove();
}

void LipschitzLanes::noteNextSlopeAbove() {
    limits_.noteworthy = memory_.steepest;
    // A little less, so that rounding never hides a slope from the exact test.
    if (settings_.evaluate)
        limits_.noteworthy =
            std::min(limits_.noteworthy, memory_.bound / (*settings_.evaluate)[1] * (1 - 1e-12));
}

}  // namespace isoscope
