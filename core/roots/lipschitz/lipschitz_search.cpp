// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/roots/lipschitz/lipschitz_search.h"

#include <cmath>
#include <glm/geometric.hpp>

namespace isoscope {

void LipschitzSearch::begin(const LineQuery& query, const RootSettings& settings, double sufficient,
                            GradientMemory& memory, RootList& roots, SearchTrail& trail) {
    settings_ = &settings;
    memory_ = &memory;
    roots_ = &roots;
    roots.clear();
    trail_ = &trail;
    trail.count = 0;
    trail.missed = false;
    near_ = query.near;
    far_ = query.far;
    phase_ = Phase::done;
    if (!(far_ - near_ >= settings.accuracy) || !std::isfinite(far_)) return;
    speed_ = glm::length(query.direction);
    if (!(speed_ > 0) || !std::isfinite(speed_)) return;
    rootsLeft_ = settings.maxTrace;
    sufficient_ = sufficient;
    farKnown_ = exitWall_ = false;
    sign_ = 1;
    ask(Phase::nearEnd, near_);
}

void LipschitzSearch::supply(double value) {
    const double g = settings_->signedValue(value);
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
        case Phase::exitWall: exitWall_ = g < 0; [[fallthrough]];
        case Phase::farEnd:
            farValue_ = g;
            farKnown_ = true;
            startSearch();
            break;
        case Phase::nextStart:
            nearValue_ = g;
            startSearch();
            break;
        case Phase::halving:
        case Phase::done: break;
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
            roots_->push_back({near_, RootKind::entryWall});
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
    if (settings_->evaluate && memory_->bound > (*settings_->evaluate)[0])
        memory_->bound *= (*settings_->evaluate)[2];
    interval_ = {near_, sign_ * nearValue_, far_, sign_ * farValue_, sign_, speed_};
    trail_->starts[static_cast<std::size_t>(trail_->count++)] = near_;
    phase_ = Phase::halving;
}

void LipschitzSearch::halved(const HalvingResult& result) {
    if (!result.found) {
        trail_->missed = true;
        trail_->lowest = result.lowest;
        return finish();
    }
    roots_->push_back({result.t, RootKind::crossing});
    near_ = result.t + 5 * settings_->accuracy;
    if (enough(result.t) || !(far_ - near_ >= settings_->accuracy)) return finish();
    sign_ = -sign_;
    ask(Phase::nextStart, near_);
}

bool LipschitzSearch::enough(double t) { return --rootsLeft_ == 0 || t >= sufficient_; }

void LipschitzSearch::finish() {
    if (exitWall_) {
        // Before a crossing at the same t: POV-Ray finds the wall first and shows its normal.
        auto place = roots_->end();
        while (place != roots_->begin() && (place - 1)->t >= far_) --place;
        roots_->insert(place, {far_, RootKind::exitWall});
    }
    phase_ = Phase::done;
}

}  // namespace isoscope
