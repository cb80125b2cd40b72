// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/roots/certified/general_search.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <utility>

namespace isoscope {

namespace {

constexpr double unit = std::numeric_limits<double>::epsilon();

/// Which part of a line is looked at first; one that begins close to a surface is hardly clear as far as half
/// of it (found by trial).
constexpr double earlyParts = 2, lateParts = 16;

/// -1 for a value inside, else 1: the threshold itself is outside.
int sideOf(double value) { return value < 0 ? -1 : 1; }

/// The distance along the line below which points cannot be told apart: 32 units of t, and a few of the
/// coordinates.
double graininess(const LineQuery& query, double perLength) {
    const double reach = std::max(std::abs(query.near), std::abs(query.far));
    double coordinates = 0;
    for (int k = 0; k < 3; ++k)
        coordinates = std::max(coordinates, std::abs(query.origin[k]) + reach * std::abs(query.direction[k]));
    return std::max(32 * unit * reach, 4 * unit * coordinates * perLength);
}

}  // namespace

const char* name(Verdict verdict) {
    switch (verdict) {
        case Verdict::certifiedHit: return "certified-hit";
        case Verdict::certifiedMiss: return "certified-miss";
        case Verdict::gap: return "gap";
        case Verdict::budgetExceeded: return "budget-exceeded";
        case Verdict::notCertified: return "not-certified";
    }
    return "";
}

namespace {

/// Moves the lane's piece on by `length`; the end is reached exactly, whatever the sum of the pieces is
/// rounded to. Returns whether it is reached.
bool advance(const GeneralSearch::Lane& lane, double length) {
    const double far = lane[&MarchLanes::far], rest = far - lane.start();
    const bool through = length >= rest || rest - length < lane[&MarchLanes::resolution] / 64;
    lane.start() = through ? far : lane.start() + length;
    return through;
}

void setLength(const GeneralSearch::Lane& lane, double length) {
    lane.length() =
        std::min(std::max(length, lane[&MarchLanes::resolution]), lane[&MarchLanes::far] - lane.start());
}

}  // namespace

std::optional<BracketedRoot> locateSignChange(int sign, double low, double high, LineFunction& line) {
    const double firstLow = std::abs(line.value(low)), firstHigh = std::abs(line.value(high));
    double valueLow = firstLow, valueHigh = firstHigh;
    const double width = high - low;
    const auto poleAt = [&](double t) { return BracketedRoot{{t, RootKind::pole}, low, high, false}; };
    for (int round = 0; round < 1100; ++round) {
        const double middle = low + (high - low) / 2;
        if (!(low < middle && middle < high)) break;
        const double value = line.value(middle);
        if (std::isnan(value)) return {};
        if (std::isinf(value)) return poleAt(middle);
        if (sideOf(value) == sign) {
            low = middle;
            valueLow = std::abs(value);
        } else {
            high = middle;
            valueHigh = std::abs(value);
        }
    }
    const double before = firstLow + firstHigh, after = valueLow + valueHigh;
    if (std::isnan(after)) return {};
    if (std::isinf(after) || (valueLow > firstLow && valueHigh > firstHigh && after > 4 * before))
        return poleAt(high);
    // Values that stay what they were while the bracket shrinks.
    const bool jumps = after > 0.5 * before && before > 0 && high - low < 0.25 * width;
    const RootKind kind = jumps ? RootKind::jump : RootKind::crossing;
    return BracketedRoot{{high, kind}, low, high, false};
}

void GeneralSearch::begin(const LineQuery& query, const RootSettings& settings, double sufficient,
                          bool certain, const Lane& lane, std::uint32_t budget, bool samples) {
    samples_ = samples;
    sufficient_ = sufficient;
    // With a finite one, the first root beyond it ends the search.
    countsFrom_ = std::isfinite(sufficient) ? sufficient : query.countsFrom;
    certain_ = certain;
    gap_ = exhausted_ = blurred_ = false;
    openFrom_ = notOpen;
    endTried_ = false;
    rootsLeft_ = settings.maxTrace;
    roots_.clear();
    // Where the line begins on a surface, as shadow rays do, no sign is certain for a long time; what roots
    // there are before `sufficient` does not count.
    const bool late = std::isfinite(sufficient) && sufficient > query.near && sufficient < query.far;
    near_ = late ? sufficient : query.near;
    far_ = query.far;
    entering_ = !late && query.near > 0;
    closed_ = !settings.open;
    const double speed = glm::length(query.direction);
    done_ = !(query.near < query.far) || !std::isfinite(query.far) || !std::isfinite(speed) || speed == 0;
    if (done_) return;
    const double perLength = 1 / speed;
    const double tolerance = settings.accuracy * perLength;
    const double resolution = std::max(0.003 * tolerance, graininess(query, perLength));
    lane[&MarchLanes::far] = query.far;
    lane[&MarchLanes::resolution] = resolution;
    lane[&MarchLanes::tolerance] = std::max(tolerance, resolution);
    lane[&MarchLanes::sign] = 0;
    lane[&MarchLanes::signPlace] = lane.start() = near_;
    // Inside right behind its wall, a line may not be so at the wall: firstSign().
    lane[&MarchLanes::watched] = entering_ ? MarchLanes::insideSign : MarchLanes::noSign;
    lane[&MarchLanes::unresolvedError] = 0;
    lane[&MarchLanes::evaluations] = 0;
    lane[&MarchLanes::budget] = budget;
    lane[&MarchLanes::jump] = query.far;
    lane[&MarchLanes::resumed] = 0;
    setLength(lane, (far_ - near_) / (late ? lateParts : earlyParts));
}

void GeneralSearch::goTo(const CertainStart& start, const Lane& lane) {
    if (done_ || start.sign == 0 || !(start.start > near_)) return;
    lane.start() = lane[&MarchLanes::signPlace] = start.start;
    lane[&MarchLanes::sign] = start.sign;
    entering_ = false;
    // A single line can take longer steps than the bundle that came so far.
    setLength(lane, 1.25 * start.length);
}

void GeneralSearch::limitTo(double end, const Lane& lane) {
    double& limit = lane[&MarchLanes::far];
    const bool waited = waits(lane);
    limit = std::min(end, far_);
    if (waited || lane.start() + lane.length() > limit) setLength(lane, limit - lane.start());
}

bool GeneralSearch::skipTo(double end, const Lane& lane) {
    if (lane.start() < end) lane.start() = lane[&MarchLanes::signPlace] = std::min(end, far_);
    done_ = lane.start() >= far_;
    return done_;
}

void GeneralSearch::handle(MarchEvent event, const Lane& lane, LineFunction& line) {
    switch (event) {
        case MarchEvent::none:
        case MarchEvent::bracket: return;
        case MarchEvent::reachedEnd:
            if (lane[&MarchLanes::far] < far_) return;
            return finishAtEnd(lane, line);
        case MarchEvent::exhausted: return sampleRest(lane, line);
        case MarchEvent::crossing: crossing(lane); break;
        case MarchEvent::jump: jump(lane, line); break;
        case MarchEvent::newSign: newSign(lane[&MarchLanes::newSign] > 0 ? 1 : -1, lane, line); break;
        case MarchEvent::unresolved: stepOver(lane); break;
        case MarchEvent::undefined: skipUndefined(lane); break;
    }
    if (done_) return;
    if (lane.start() >= far_) return finishAtEnd(lane, line);
    if (lane[&MarchLanes::evaluations] >= lane[&MarchLanes::budget]) return sampleRest(lane, line);
    const bool mayBeginInWall = entering_ && lane[&MarchLanes::sign] == 0;
    lane[&MarchLanes::watched] = blurred_         ? MarchLanes::anySign
                                 : mayBeginInWall ? MarchLanes::insideSign
                                                  : MarchLanes::noSign;
}

void GeneralSearch::crossing(const Lane& lane) {
    const double low = lane[&MarchLanes::low], high = lane[&MarchLanes::high];
    const double slope = lane[&MarchLanes::slope];
    const double steepness = 2 * slope * lane[&MarchLanes::sign] / lane.length();
    // Between the ends of the piece the slope changes by four times the error, if it changes evenly.
    const double change = 4 * lane[&MarchLanes::error] / std::abs(slope);
    const double leftover = 0.5 * (high - low) * change / lane[&MarchLanes::tolerance];
    record({{(low + high) / 2, RootKind::crossing}, low, high, true, steepness, leftover});
    if (done_) return;
    advance(lane, lane.length());
    lane[&MarchLanes::sign] *= -1;
    lane[&MarchLanes::signPlace] = lane.start();
    setLength(lane, lengthBehind(lane));
}

void GeneralSearch::jump(const Lane& lane, LineFunction& line) {
    const double low = lane[&MarchLanes::low], high = lane[&MarchLanes::high];
    const int sign = lane[&MarchLanes::sign] > 0 ? 1 : -1;
    if (std::isfinite(sufficient_))
        record({{high, RootKind::jump}, low, high, false});
    else
        settleFlip(sign, low, high, line);
    if (done_) return;
    lane.start() = lane[&MarchLanes::signPlace] = high;
    lane[&MarchLanes::sign] = -sign;
    setLength(lane, lengthBehind(lane));
}

/// The sign at the start of the piece is certain now; the piece is looked at again.
void GeneralSearch::newSign(int sign, const Lane& lane, LineFunction& line) {
    double& known = lane[&MarchLanes::sign];
    const double t = lane.start();
    if (blurred_) sample(t, blurSamples, lane, line);
    if (!done_ && known == 0) firstSign(sign, t, lane, line);
    if (done_) return;
    if (known == -sign && !settleNarrowFlip(-sign, lane, line))
        settleFlip(-sign, lane[&MarchLanes::signPlace], t, line);
    known = sign;
    lane[&MarchLanes::signPlace] = t;
    lane[&MarchLanes::unresolvedError] = 0;
}

/// The surface is in the stretch that was passed over since the last certain sign, and the stretch is no
/// wider than the accuracy: whatever the function does there, that is no gap. Through infinity there is no
/// surface.
bool GeneralSearch::settleNarrowFlip(int sign, const Lane& lane, LineFunction& line) {
    const double low = lane[&MarchLanes::signPlace], high = lane.start();
    if (openFrom_ != low || !(high - low <= lane[&MarchLanes::tolerance])) return false;
    // A finite function changes its sign here, at its jump if that is known, else where the polish finds it.
    // It may also do so through infinity, where there is no surface.
    const double jump = std::exchange(lane[&MarchLanes::jump], far_);
    const bool placed = low <= jump && jump <= high;
    const double t = placed ? jump : low + (high - low) / 2;
    const RootKind kind = placed ? RootKind::jump : RootKind::crossing;
    const std::optional<BracketedRoot> root = unbounded_ || !std::isfinite(sufficient_)
                                                  ? signChange(sign, low, high, line)
                                                  : BracketedRoot{{t, kind}, low, high, !placed};
    if (!root) return true;
    openFrom_ = notOpen;
    record(*root);
    return true;
}

/// The stretch that was passed over is a gap, unless it turns out to hold the surface.
void GeneralSearch::closeStretch() {
    gap_ = gap_ || openFrom_ != notOpen;
    openFrom_ = notOpen;
}

double GeneralSearch::lengthBehind(const Lane& lane) const {
    const double length = std::max(2 * lane.length(), lane[&MarchLanes::resumed]);
    lane[&MarchLanes::resumed] = 0;
    return length;
}

/// What lies within a small part of the resolution of the place where a line enters or leaves its container
/// is the wall's: the value at the wall itself decides. Returns whether the lane has another piece by that.
bool GeneralSearch::passWall(const Lane& lane) {
    const double wall = lane[&MarchLanes::resolution] / 64;
    const double t = lane.start(), rest = far_ - t, behind = lane.length();
    if (entering_ && t == near_ && rest > 2 * wall) {
        advance(lane, wall);
        setLength(lane, behind);
        return true;
    }
    if (lane[&MarchLanes::sign] == 0 || lane.length() < rest) return false;
    if (rest > 2 * wall)
        lane.length() = rest - wall;
    else
        lane.start() = far_;
    return rest <= 2 * wall || !std::exchange(endTried_, true);
}

void GeneralSearch::stepOver(const Lane& lane) {
    if (passWall(lane)) return;
    const double length = lane.length();
    if (openFrom_ != lane[&MarchLanes::signPlace]) {
        closeStretch();
        openFrom_ = lane[&MarchLanes::signPlace];
        unbounded_ = false;
    }
    unbounded_ = unbounded_ || !std::isfinite(lane[&MarchLanes::error]);
    // Without a sign before there is none to change.
    if (lane[&MarchLanes::sign] == 0) gap_ = true;
    if (length <= lane[&MarchLanes::resolution])
        lane[&MarchLanes::unresolvedError] = lane[&MarchLanes::error];
    blurred_ = blurred_ || length > lane[&MarchLanes::tolerance];
    const double behind = lengthBehind(lane);
    advance(lane, length);
    setLength(lane, behind);
}

/// No value all along: whatever the sign was, it is forgotten.
void GeneralSearch::skipUndefined(const Lane& lane) {
    const double length = lane.length();
    lane[&MarchLanes::sign] = 0;
    entering_ = false;
    advance(lane, length);
    setLength(lane, 2 * length);
}

/// A line that comes from outside is inside at the first place t with a sign. Where it was not inside at the
/// wall, by its value there, the surface is in the wall, as that of a jump at the very place is, or behind
/// it; an open surface may also begin inside.
void GeneralSearch::firstSign(int sign, double t, const Lane& lane, LineFunction& line) {
    const bool enters = entering_ && sign < 0 && line.value(near_) >= 0;
    entering_ = false;
    if (!enters) return;
    if (t - near_ <= lane[&MarchLanes::tolerance])
        record({{near_, RootKind::crossing}, near_, t, false});
    else if (closed_)
        settleFlip(1, near_, t, line);
}

/// Looks for changes of sign between the last certain sign and `end` by point values.
void GeneralSearch::sample(double end, int count, const Lane& lane, LineFunction& line) {
    blurred_ = false;
    double& known = lane[&MarchLanes::sign];
    double& place = lane[&MarchLanes::signPlace];
    const double from = place;
    for (int k = 0; k <= count && !done_; ++k) {
        const double t = k == count ? end : from + (end - from) * k / count;
        const double value = line.value(t);
        if (std::isnan(value)) continue;
        const int sign = sideOf(value);
        if (known == -sign)
            settleFlip(-sign, place, t, line);
        else if (known == 0)
            firstSign(sign, t, lane, line);
        known = sign;
        place = t;
    }
}

void GeneralSearch::sampleRest(const Lane& lane, LineFunction& line) {
    exhausted_ = true;
    if (samples_) sample(far_, restSamples, lane, line);
    done_ = true;
}

void GeneralSearch::finishAtEnd(const Lane& lane, LineFunction& line) {
    if (blurred_) {
        sample(far_, blurSamples, lane, line);
    } else if (lane[&MarchLanes::sign] != 0 && lane[&MarchLanes::signPlace] < far_) {
        const int known = lane[&MarchLanes::sign] > 0 ? 1 : -1;
        if (known * line.value(far_) < 0) settleFlip(known, lane[&MarchLanes::signPlace], far_, line);
    }
    done_ = true;
}

/// locateSignChange(), without poles that are not asked for.
std::optional<BracketedRoot> GeneralSearch::signChange(int sign, double low, double high,
                                                       LineFunction& line) const {
    const auto found = locateSignChange(sign, low, high, line);
    return found && found->root.kind == RootKind::pole && !listsPoles_ ? std::nullopt : found;
}

void GeneralSearch::settleFlip(int sign, double low, double high, LineFunction& line) {
    if (const auto root = signChange(sign, low, high, line)) record(*root);
}

void GeneralSearch::record(const BracketedRoot& root) {
    roots_.push_back(root);
    if (root.root.t >= countsFrom_ && (--rootsLeft_ == 0 || root.root.t >= sufficient_)) done_ = true;
}

Verdict GeneralSearch::verdict() const {
    if (!certain_) return Verdict::notCertified;
    if (exhausted_) return Verdict::budgetExceeded;
    if (gap_ || openFrom_ != notOpen) return Verdict::gap;
    const auto isPole = [](const BracketedRoot& found) { return found.root.kind == RootKind::pole; };
    return std::all_of(roots_.begin(), roots_.end(), isPole) ? Verdict::certifiedMiss : Verdict::certifiedHit;
}

}  // namespace isoscope
