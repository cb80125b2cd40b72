// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/roots/certified_search.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>

namespace isoscope {

namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();
constexpr double unit = std::numeric_limits<double>::epsilon();

int signOf(double a) { return a > 0 ? 1 : a < 0 ? -1 : 0; }

/// The distance along the line below which points cannot be told apart: 32 units of t, and a few of the
/// coordinates.
double graininess(const LineQuery& query, double speed) {
    const double reach = std::max(std::abs(query.near), std::abs(query.far));
    double coordinates = 0;
    for (int k = 0; k < 3; ++k)
        coordinates = std::max(coordinates, std::abs(query.origin[k]) + reach * std::abs(query.direction[k]));
    return std::max(32 * unit * reach, 4 * unit * coordinates / speed);
}

}  // namespace

const char* name(Verdict verdict) {
    switch (verdict) {
        case Verdict::certifiedHit:
            return "certified-hit";
        case Verdict::certifiedMiss:
            return "certified-miss";
        case Verdict::gap:
            return "gap";
        case Verdict::budgetExceeded:
            return "budget-exceeded";
        case Verdict::notCertified:
            return "not-certified";
    }
    return "";
}

void CertifiedSearch::begin(const LineQuery& query, const RootSettings& settings, double sufficient,
                            bool certain, std::uint32_t budget) {
    settings_ = &settings;
    sufficient_ = sufficient;
    certain_ = certain;
    budget_ = budget;
    evaluations_ = 0;
    gap_ = exhausted_ = reachedEnd_ = false;
    rootsLeft_ = settings.maxTrace;
    roots_.clear();
    sign_ = 0;
    noise_ = 0;
    blurred_ = false;
    far_ = query.far;
    t_ = signPlace_ = near_ = query.near;
    entering_ = query.near > 0;
    const double speed = glm::length(query.direction);
    done_ = !(query.near < query.far) || !std::isfinite(query.far) || !std::isfinite(speed) || speed == 0;
    if (done_) return;
    tolerance_ = settings.accuracy / speed;
    resolution_ = std::max(0.01 * tolerance_, graininess(query, speed));
    h_ = (far_ - t_) / 2;
}

void CertifiedSearch::supply(const AffineForm& form, LineFunction& line) {
    ++evaluations_;
    const double e = form.e + 2 * unit * std::abs(form.a);
    const double polarity = settings_->positivePolarity ? -1 : 1;
    const double a = polarity * (form.a - settings_->threshold), b = polarity * form.b;
    const bool known = std::abs(e) < infinite;
    if (form.e == -infinite) {
        // Undefined all along: whatever the sign was, it is forgotten.
        sign_ = 0;
        entering_ = false;
        advance(h_);
        h_ *= 2;
    } else if (known && std::abs(a - b) * (1 - 4 * unit) > e) {
        noteSign(signOf(a - b), t_, line);
        if (!done_) signKnown(a * sign_, b * sign_, e, line);
    } else {
        signOpen(a * sign_, b * sign_, e, known);
    }
    if (done_) return;
    if (reachedEnd_) return finishAtEnd(line);
    if (evaluations_ >= budget_) return sampleRest(line);
    h_ = std::min(std::max(h_, resolution_), far_ - t_);
}

/// The function is positive at the start of the piece (its sign is taken out).
void CertifiedSearch::signKnown(double a, double b, double e, LineFunction&) {
    if (a + b - e > 0) {
        advance(h_);
        signPlace_ = t_;
        h_ *= 2;
        return;
    }
    // The lower bound meets 0 at s = (a - e) / -b; up to there no root is possible.
    const double free = std::clamp(((a - e) / -b + 1) / 2 - 4 * unit, 0.0, 1.0) * h_;
    if (a + b + e < 0) {
        const double last = std::clamp(((a + e) / -b + 1) / 2 + 4 * unit, 0.0, 1.0) * h_;
        const double width = last - free;
        if (width <= std::max(tolerance_, resolution_)) return certainCrossing(t_ + free, t_ + last);
        advance(free);
        signPlace_ = t_;
        h_ = width < 0.6 * h_ ? width : width / 2;
        return;
    }
    if (h_ <= resolution_) {
        signPlace_ = t_ + free;
        return stepOver(e);
    }
    advance(free);
    signPlace_ = t_;
    h_ = std::max(free, (h_ - free) / 2);
}

/// The sign at the start of the piece is not certain; the numbers are relative to the last certain one.
void CertifiedSearch::signOpen(double a, double b, double e, bool known) {
    if (known && sign_ != 0 && signPlace_ == t_ && a + b + e < 0) {
        // The sign was certain just before, and is the opposite at the end.
        const double last = std::clamp(((a + e) / -b + 1) / 2 + 4 * unit, 0.0, 1.0) * h_;
        if (last <= std::max(tolerance_, resolution_)) return certainCrossing(t_, t_ + last);
    }
    if (h_ <= resolution_ || (known && isNoise(a, b, e))) return stepOver(e);
    h_ *= !known || e > 16 * std::abs(a) ? 0.2 : 0.45;
}

void CertifiedSearch::certainCrossing(double low, double high) {
    record({{(low + high) / 2, RootKind::crossing}, low, high, true});
    if (done_) return;
    advance(h_);
    sign_ = -sign_;
    signPlace_ = t_;
    h_ *= 2;
}

void CertifiedSearch::advance(double length) {
    // The end is reached exactly, whatever the sum of the pieces is rounded to.
    if (length >= far_ - t_ || far_ - t_ - length < resolution_ / 64) {
        t_ = far_;
        reachedEnd_ = true;
    } else {
        t_ += length;
    }
}

/// Whether every piece inside this one would stay unresolved too: its values are within an error that does
/// not shrink with the length any more.
bool CertifiedSearch::isNoise(double a, double b, double e) const {
    return noise_ > 0 && std::abs(a) + std::abs(b) <= e && e <= 2 * noise_;
}

void CertifiedSearch::stepOver(double e) {
    gap_ = true;
    if (h_ <= resolution_) noise_ = e;
    blurred_ = blurred_ || h_ > std::max(tolerance_, resolution_);
    advance(h_);
    h_ *= 2;
}

void CertifiedSearch::noteSign(int sign, double t, LineFunction& line) {
    if (blurred_) sample(t, blurSamples, line);
    if (!done_ && surfaceInWall(sign, t, line)) record({{near_, RootKind::crossing}, near_, t, false});
    entering_ = false;
    if (done_) return;
    if (sign_ != 0 && sign != sign_) settleFlip(signPlace_, t, line);
    sign_ = sign;
    signPlace_ = t;
    noise_ = 0;
}

/// Whether the function is 0 at the wall, but for rounding, and the solid begins right behind it.
bool CertifiedSearch::surfaceInWall(int sign, double t, LineFunction& line) {
    const bool behindWall = near_ < t && t - near_ <= std::max(tolerance_, resolution_);
    return entering_ && sign_ == 0 && sign < 0 && behindWall && line.value(near_) >= 0;
}

void CertifiedSearch::settleFlip(double low, double high, LineFunction& line) {
    const double firstLow = std::abs(line.value(low)), firstHigh = std::abs(line.value(high));
    double valueLow = firstLow, valueHigh = firstHigh;
    bool undefined = false;
    for (int round = 0; round < 1100 && !undefined; ++round) {
        const double middle = low + (high - low) / 2;
        if (!(low < middle && middle < high)) break;
        const double value = line.value(middle);
        if (value == 0) return record({{middle, RootKind::crossing}, low, high, false});
        undefined = !std::isfinite(value);
        if (signOf(value) == sign_) {
            low = middle;
            valueLow = std::abs(value);
        } else {
            high = middle;
            valueHigh = std::abs(value);
        }
    }
    const double before = firstLow + firstHigh, after = valueLow + valueHigh;
    // Through infinity, or through a place without a value: not a surface.
    if (undefined || !std::isfinite(after) ||
        (valueLow > firstLow && valueHigh > firstHigh && after > 4 * before))
        return;
    const RootKind kind = after > 0.5 * before && before > 0 ? RootKind::jump : RootKind::crossing;
    record({{high, kind}, low, high, false});
}

/// Looks for changes of sign between the last certain sign and `end` by point values.
void CertifiedSearch::sample(double end, int count, LineFunction& line) {
    blurred_ = false;
    const double from = signPlace_;
    for (int k = 0; k <= count && !done_; ++k) {
        const double t = k == count ? end : from + (end - from) * k / count;
        const double value = line.value(t);
        const int sign = signOf(value);
        if (sign_ != 0 && sign == 0 && !std::isnan(value)) {
            record({{t, RootKind::gap}, signPlace_, t, false});
            sign_ = 0;
        } else if (sign != 0) {
            if (sign_ == -sign) settleFlip(signPlace_, t, line);
            sign_ = sign;
            signPlace_ = t;
        }
    }
}

void CertifiedSearch::sampleRest(LineFunction& line) {
    exhausted_ = true;
    sample(far_, restSamples, line);
    done_ = true;
}

void CertifiedSearch::finishAtEnd(LineFunction& line) {
    if (blurred_) {
        sample(far_, blurSamples, line);
    } else if (sign_ != 0 && signPlace_ < far_) {
        const int sign = signOf(line.value(far_));
        if (sign == -sign_) settleFlip(signPlace_, far_, line);
    }
    done_ = true;
}

void CertifiedSearch::record(const BracketedRoot& root) {
    roots_.push_back(root);
    // Roots before what is asked for do not count: with a finite `sufficient` the first one beyond it ends
    // the search.
    const bool counts = std::isinf(sufficient_) || root.root.t >= sufficient_;
    if (counts && (--rootsLeft_ == 0 || root.root.t >= sufficient_)) done_ = true;
}

Verdict CertifiedSearch::verdict() const {
    if (!certain_) return Verdict::notCertified;
    if (exhausted_) return Verdict::budgetExceeded;
    if (gap_) return Verdict::gap;
    return roots_.empty() ? Verdict::certifiedMiss : Verdict::certifiedHit;
}

}  // namespace isoscope
