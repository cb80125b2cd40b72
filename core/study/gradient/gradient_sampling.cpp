// SPDX-License-Identifier: GPL-3.0-or-later
// The part of GradientStudy that looks at points: first guesses, and singularities.
#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "core/evaluate/tape/loop_stop.h"
#include "core/study/gradient/gradient_study.h"

namespace isoscope {

namespace {

/// The `index`-th number of the van der Corput sequence.
double evenlySpread(unsigned index, unsigned base) {
    double value = 0, digit = 1;
    for (; index > 0; index /= base) {
        digit /= base;
        value += digit * (index % base);
    }
    return value;
}

std::vector<glm::dvec3> directions() {
    std::vector<glm::dvec3> all;
    for (int x = -1; x <= 1; ++x)
        for (int y = -1; y <= 1; ++y)
            for (int z = -1; z <= 1; ++z)
                if (x != 0 || y != 0 || z != 0)
                    all.push_back(glm::normalize(glm::dvec3(x + 0.01, y - 0.02, z + 0.03)));
    return all;
}

}  // namespace

/// False when a stop came before the end.
bool GradientStudy::samplePoints() {
    constexpr unsigned count = 4096, batch = 256;
    constexpr std::size_t climbers = 6;
    summits_.clear();
    std::vector<double> x(count), y(count), z(count);
    const glm::dvec3 low = domain_.box().low, extent = domain_.box().high - low;
    for (unsigned i = 0; i < count; ++i) {
        const glm::dvec3 place =
            low + extent * glm::dvec3(evenlySpread(i + 1, 2), evenlySpread(i + 1, 3), evenlySpread(i + 1, 5));
        const glm::dvec3 p = domain_.nearest(place);
        x[i] = p.x, y[i] = p.y, z[i] = p.z;
    }
    std::vector<ValueAndGradient> found(count);
    for (unsigned i = 0; i < count; i += batch) {
        const auto part = [&](auto& all) { return std::span(all).subspan(i, batch); };
        examiner().gradients().evaluate(part(x), part(y), part(z), part(found));
        if (LoopStop::requested()) return false;
    }
    std::vector<std::pair<double, unsigned>> steepest;
    for (unsigned i = 0; i < count; ++i) {
        if (leftOut_.holds(glm::dvec3(x[i], y[i], z[i]))) continue;
        const double length = slopeOf(found[i]);
        if (std::isfinite(found[i].value) && std::isfinite(length)) steepest.push_back({length, i});
    }
    const std::size_t kept = std::min(climbers, steepest.size());
    std::partial_sort(steepest.begin(), steepest.begin() + static_cast<std::ptrdiff_t>(kept), steepest.end(),
                      [](const auto& a, const auto& b) { return a.first > b.first; });
    for (std::size_t k = 0; k < kept; ++k) {
        sampled_ = std::max(sampled_, steepest[k].first);
        const unsigned i = steepest[k].second;
        climb({x[i], y[i], z[i]});
        if (LoopStop::requested()) return false;
    }
    return true;
}

void GradientStudy::climb(glm::dvec3 from) {
    const double size = domain_.box().width();
    double best = steepnessAt(from);
    // Along a ridge the climb could go on for long; the rest is left to the boxes.
    constexpr int roundLimit = 200;
    double reach = size / 16;
    for (int round = 0; round < roundLimit && reach > size * 1e-9 && !LoopStop::requested(); ++round) {
        bool moved = false;
        for (int k = 0; k < 3; ++k)
            for (const double sign : {-1.0, 1.0}) {
                glm::dvec3 next = from;
                next[k] += sign * reach;
                next = domain_.nearest(next);
                const double length = steepnessAt(next);
                if (!(length > best)) continue;
                best = length;
                from = next;
                moved = true;
            }
        if (!moved) reach /= 2;
    }
    summits_.push_back(from);
    offerPoint(from);
}

double GradientStudy::steepestAround(const glm::dvec3& place, double distance) {
    static const std::vector<glm::dvec3> all = directions();
    // Of a flat domain all but those along it lead out.
    const glm::dvec3 extent = domain_.box().high - domain_.box().low;
    const glm::dvec3 along(extent.x > 0 ? 1 : 0, extent.y > 0 ? 1 : 0, extent.z > 0 ? 1 : 0);
    double steepest = 0;
    for (const glm::dvec3& direction : all) {
        const glm::dvec3 p = place + distance * glm::normalize(direction * along);
        if (!domain_.contains(p)) continue;
        const double length = steepnessAt(p);
        if (length > steepest &&
            (isConfirmed(p, length, distance / 8) || isConfirmed(p, length, distance / 64)))
            steepest = length;
    }
    return steepest;
}

/// Whether values near `p` rise about as the gradient there says. Close to where a formula ends its gradient
/// may be made of rounding errors: (1 + sin u)^0.77 has slopes of thousands where its values hardly change.
bool GradientStudy::isConfirmed(const glm::dvec3& p, double length, double reach) {
    const auto g = examiner().gradients().evaluate(p.x, p.y, p.z).gradient;
    const glm::dvec3 step = reach / length * glm::dvec3(g[0], g[1], g[2]);
    const glm::dvec3 a = p - step, b = p + step;
    const double fa = examiner().valueAt(a), fb = examiner().valueAt(b);
    // At the end of what is defined, or of what doubles hold, there is nothing to compare.
    if (!std::isfinite(fa) || !std::isfinite(fb)) return true;
    const double rounding = 1e-14 * (1 + std::abs(fa) + std::abs(fb));
    return std::abs(fa - fb) + rounding >= length * 2 * reach / 4;
}

/// The climbs go where it is steepest, and so into corners that halving would reach late.
void GradientStudy::lookForSingularities() {
    const double tiny = domain_.box().width() * 0x1p-34;
    for (const glm::dvec3& place : summits_) {
        if (bracket_.state != GradientState::running) return;
        const GradientBox box{place - tiny, place + tiny};
        const GradientHazard hazard = examiner().intervals().evaluate(box.intervals()).hazard;
        if (hazard > GradientHazard::jump) isSingular({box, 0, 0, hazard});
    }
}

/// Whether slopes keep growing towards the region, from a thousandth of the container to a 10^10th.
bool GradientStudy::isSingular(const Region& region) {
    const glm::dvec3 place = domain_.nearest(region.box.center());
    const double size = domain_.box().width();
    const auto steepest = [&](int first, int last) {
        double most = 0;
        for (int k = first; k <= last; ++k)
            most = std::max(most, steepestAround(place, size * std::ldexp(1.0, -k)));
        return most;
    };
    const double far = steepest(8, 14), middle = steepest(17, 23), near = steepest(26, 32);
    const bool grows = near >= 1.3 * middle && middle >= 1.3 * far && near > 0;
    const bool overflows = region.hazard == GradientHazard::overflow && near >= 1e50;
    if ((!grows && !overflows) || LoopStop::requested()) return false;
    setSingular(region.hazard, place);
    return true;
}

/// Looks into one box that may hold a jump; false when there is none left to look into. One in 16 is
/// followed down to a point, where a small jump would be seen; all are divided, so that those without one are
/// done with.
bool GradientStudy::checkSeam() {
    if (seams_.empty() || seamsLeft_ <= 0) return false;
    const Region region = seams_.front();
    seams_.pop_front();
    if (++dives_ % 16 == 0 && diveInto(region.box)) return true;
    divide(region);
    return true;
}

/// Halves a box that may hold a jump, and one of the halves that still may, and so on. Returns whether there
/// is one.
bool GradientStudy::diveInto(GradientBox box) {
    constexpr int depth = 130;
    for (int step = 0; step < depth; ++step) {
        const glm::dvec3 extent = box.high - box.low;
        const int axis = extent.x >= extent.y && extent.x >= extent.z ? 0 : extent.y >= extent.z ? 1 : 2;
        const double middle = 0.5 * box.low[axis] + 0.5 * box.high[axis];
        if (!(middle > box.low[axis] && middle < box.high[axis])) return false;
        // By turns the lower and the upper half come first.
        const bool lowerFirst = (dives_ + step) % 3 != 0;
        bool open = false;
        for (const bool lower : {lowerFirst, !lowerFirst}) {
            GradientBox half = box;
            (lower ? half.high : half.low)[axis] = middle;
            if (domain_.misses(half)) continue;
            const IntervalGradient whole = examiner().intervals().evaluate(half.intervals());
            if (whole.hazard != GradientHazard::jump) continue;
            examiner().ask(question());
            if (const auto jump = examiner().findJump(half, whole.slope)) {
                setSingular(GradientHazard::jump, *jump);
                return true;
            }
            box = half;
            open = true;
            break;
        }
        if (!open) return false;
    }
    return false;
}

/// Into boxes a quarter as wide, neighbours one after the other: what is kept of a place helps those beside
/// it.
void GradientStudy::divide(const Region& region) {
    const double width = region.box.width() / 4;
    const std::size_t others = seams_.size();
    std::vector<Region> parts;
    halve(region);
    --seamsLeft_;
    while (seams_.size() > others && bracket_.state == GradientState::running) {
        const Region next = seams_.back();
        seams_.pop_back();
        if (next.box.width() <= width) {
            parts.push_back(next);
            continue;
        }
        halve(next);
        --seamsLeft_;
    }
    seams_.insert(seams_.end(), parts.begin(), parts.end());
}

}  // namespace isoscope
