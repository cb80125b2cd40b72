// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/roots/lipschitz_search.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

namespace isoscope {

void LipschitzSearch::begin(const LineQuery& query, const RootSettings& settings, double sufficient,
                            GradientMemory& memory) {
    settings_ = &settings;
    memory_ = &memory;
    rootsLeft_ = settings.maxTrace;
    sufficient_ = sufficient;
    trail_ = {};
    speed_ = glm::length(query.direction);
    near_ = query.near;
    far_ = query.far;
    farKnown_ = exitWall_ = exhausted_ = false;
    sign_ = 1;
    evaluations_ = 0;
    pending_.clear();
    roots_.clear();
    if (far_ - near_ >= settings.accuracy && speed_ > 0 && std::isfinite(far_) && std::isfinite(speed_))
        ask(Phase::nearEnd, near_);
    else
        phase_ = Phase::done;
}

void LipschitzSearch::supply(double value) {
    const double g = settings_->signedValue(value);
    if (++evaluations_ > evaluationLimit) {
        exhausted_ = true;
        finish();
        return;
    }
    switch (phase_) {
        case Phase::nearEnd:
            nearValue_ = g;
            atNearEnd();
            break;
        case Phase::movedStart:
            near_ = wanted_;
            nearValue_ = g;
            if (g < 0) sign_ = -1;
            if (!(far_ - near_ >= settings_->accuracy))
                finish();
            else if (settings_->open)
                startSearch();
            else
                ask(Phase::exitWall, far_);
            break;
        case Phase::exitWall:
            exitWall_ = g < 0;
            [[fallthrough]];
        case Phase::farEnd:
            farValue_ = g;
            farKnown_ = true;
            startSearch();
            break;
        case Phase::nextStart:
            nearValue_ = g;
            startSearch();
            break;
        case Phase::middle: {
            pending_.push_back({end_, endValue_, reach_ / 2});
            end_ = wanted_;
            endValue_ = sign_ * g;
            reach_ /= 2;
            subdivide();
            break;
        }
        case Phase::done:
            break;
    }
}

void LipschitzSearch::ask(Phase phase, double t) {
    phase_ = phase;
    wanted_ = t;
}

void LipschitzSearch::atNearEnd() {
    const double accuracy = settings_->accuracy;
    const double margin = 4 * memory_->bound * accuracy;
    if (settings_->open) {
        // An origin on the surface must not meet the surface again at once.
        if (near_ < accuracy && std::abs(nearValue_) < margin)
            moveStart();
        else
            startSearch();
    } else if (near_ > accuracy) {
        if (nearValue_ < 0) {
            roots_.push_back({near_, RootKind::entryWall});
            sign_ = -1;
            if (enough(near_)) return finish();
        }
        startSearch();
    } else if (nearValue_ < margin) {
        moveStart();
    } else {
        ask(Phase::exitWall, far_);
    }
}

void LipschitzSearch::moveStart() { ask(Phase::movedStart, 5 * settings_->accuracy); }

void LipschitzSearch::startSearch() {
    if (!farKnown_) return ask(Phase::farEnd, far_);
    if (settings_->open && sign_ * nearValue_ < 0) sign_ = -sign_;
    start_ = near_;
    startValue_ = sign_ * nearValue_;
    end_ = far_;
    endValue_ = sign_ * farValue_;
    if (settings_->evaluate && memory_->bound > (*settings_->evaluate)[0])
        memory_->bound *= (*settings_->evaluate)[2];
    reach_ = memory_->bound * speed_ * (end_ - start_);
    pending_.clear();
    trail_.starts[static_cast<std::size_t>(trail_.count++)] = start_;
    trail_.lowest = startValue_;
    noteNextSlopeAbove();
    subdivide();
}

void LipschitzSearch::subdivide() {
    for (;;) {
        const double width = end_ - start_;
        // Most intervals show nothing new: a division each would cost more than the rest of the step.
        const double change = std::abs(endValue_ - startValue_);
        if (change > noteworthy_ * (width * speed_)) noteSlope(change / (width * speed_), width);
        trail_.lowest = std::min(trail_.lowest, endValue_);
        const double middle = (start_ + end_) / 2;
        const bool divisible = width >= settings_->accuracy && start_ < middle && middle < end_;
        if (!divisible && endValue_ < 0) return found(end_);
        // Written so that a NaN ends the interval.
        if (divisible && startValue_ + endValue_ - reach_ < 0) return ask(Phase::middle, middle);
        if (!nextInterval()) {
            trail_.missed = true;
            return finish();
        }
    }
}

bool LipschitzSearch::nextInterval() {
    if (pending_.empty()) return false;
    start_ = end_;
    startValue_ = endValue_;
    end_ = pending_.back().end;
    endValue_ = pending_.back().endValue;
    reach_ = pending_.back().reach;
    pending_.pop_back();
    return true;
}

void LipschitzSearch::noteSlope(double slope, double width) {
    if (!std::isfinite(slope)) return;
    if (slope > memory_->steepest) memory_->steepest = slope;
    if (settings_->evaluate) {
        const double safety = (*settings_->evaluate)[1];
        if (slope * safety > memory_->bound && std::isfinite(slope * safety * safety)) {
            memory_->bound = slope * safety * safety;
            reach_ = memory_->bound * speed_ * width;
        }
    }
    noteNextSlopeAbove();
}

void LipschitzSearch::noteNextSlopeAbove() {
    noteworthy_ = memory_->steepest;
    // A little less, so that rounding never hides a slope from the exact test.
    if (settings_->evaluate)
        noteworthy_ = std::min(noteworthy_, memory_->bound / (*settings_->evaluate)[1] * (1 - 1e-12));
}

void LipschitzSearch::found(double t) {
    roots_.push_back({t, RootKind::crossing});
    near_ = t + 5 * settings_->accuracy;
    if (enough(t) || !(far_ - near_ >= settings_->accuracy)) return finish();
    sign_ = -sign_;
    ask(Phase::nextStart, near_);
}

bool LipschitzSearch::enough(double t) { return --rootsLeft_ == 0 || t >= sufficient_; }

void LipschitzSearch::finish() {
    if (exitWall_) {
        // Before a crossing at the same t: POV-Ray finds the wall first and shows its normal.
        auto place = roots_.end();
        while (place != roots_.begin() && (place - 1)->t >= far_) --place;
        roots_.insert(place, {far_, RootKind::exitWall});
    }
    phase_ = Phase::done;
}

}  // namespace isoscope
