// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/gradient/gradient_study.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "core/evaluate/prepared_function.h"
#include "core/evaluate/tape/loop_stop.h"

namespace isoscope {

namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();

/// Places at which a missing bound is looked into before it is left open.
constexpr int probeLimit = 60;

/// One in so many boxes that may hold a jump is followed down to a point, up to so many.
constexpr int divingPace = 200, earlyDives = 60;

/// One in so many boxes goes to what is beside infinite gradients.
constexpr std::uint64_t besidePart = 5;

/// Choices whose cases are looked at one by one: in boxes below a part of the container, and in larger ones.
constexpr std::size_t mostOpenChoices = 4, mostInLargeBoxes = 1;
constexpr double largeBox = 1.0 / 48;

double lengthOf(const std::array<double, 3>& v) { return std::hypot(v[0], v[1], v[2]); }

/// An upper bound of the largest magnitude of an eigenvalue.
double normAbove(const std::array<SlopeRange, 6>& matrix) {
    double widest = 0;
    for (std::size_t i = 0; i < 3; ++i) {
        double row = 0;
        for (std::size_t j = 0; j < 3; ++j) row = raised(row + matrix[bendIndex(i, j)].size());
        widest = std::max(widest, row);
    }
    return widest;
}

int axisToHalve(const GradientBox& box, const glm::dvec3& influence) {
    const glm::dvec3 extent = box.high - box.low;
    const double widest = box.width();
    int best = -1;
    for (int k = 0; k < 3; ++k)
        if (extent[k] * 16 >= widest && influence[k] > 0 && (best < 0 || influence[k] > influence[best]))
            best = k;
    if (best >= 0) return best;
    best = 0;
    for (int k = 1; k < 3; ++k)
        if (extent[k] > extent[best]) best = k;
    return best;
}

}  // namespace

GradientStudy::GradientStudy(std::shared_ptr<const Tape> tape, std::span<const double> parameters,
                             const Container& container, GradientStudySettings settings)
    : GradientStudy(PreparedFunction::of(std::move(tape), parameters), container, settings) {}

GradientStudy::GradientStudy(const std::shared_ptr<const PreparedFunction>& function,
                             const Container& container, GradientStudySettings settings)
    : domain_(container),
      settings_(settings),
      intervals_(*function),
      gradients_(function),
      values_(function) {}

const GradientBracket& GradientStudy::run(std::stop_token stop) {
    const LoopStop loops(stop);
    while (step(10'000, stop)) {
        if (!stop.stop_requested()) continue;
        finish(GradientState::stopped);
        publish();
    }
    return bracket();
}

bool GradientStudy::step(std::uint64_t boxes, std::stop_token stop) {
    if (bracket().settled()) return false;
    if (!begun_) begin();
    const std::uint64_t end = intervals_.evaluations() + boxes;
    while (true) {
        const bool boundless = bracket_.state == GradientState::unbounded ||
                               (bracket_.state == GradientState::unproven && unresolved_);
        if (boundless && !beside_) beginBeside();
        if (bracket_.state != GradientState::running || intervals_.evaluations() >= end) break;
        if (!begun_ || stop.stop_requested() || LoopStop::requested()) break;
        if (intervals_.evaluations() >= (beside_ ? besideLimit_ : settings_.boxLimit))
            finish(GradientState::unproven);
        else
            work();
    }
    if (begun_ && bracket_.state == GradientState::running) report();
    publish();
    return !bracket().settled();
}

/// Takes the next box.
void GradientStudy::work() {
    if (!boundless_.empty() && probes_ < probeLimit) {
        const Region region = boundless_.back();
        boundless_.pop_back();
        halve(region);
    } else if (unresolved_) {
        // Nothing has an upper bound any more.
        finish(GradientState::unproven);
    } else if (beside_ && !besideSampled_) {
        besideSampled_ = true;
        besideSampled_ = samplePoints();
    } else if (queue_.empty()) {
        if (!checkSeam()) finish(mayJump() || !isNarrow() ? GradientState::unproven : GradientState::tight);
    } else {
        const Region region = queue_.top();
        queue_.pop();
        queuedJumps_ -= region.hazard == GradientHazard::jump ? 1 : 0;
        if (leftOut_.holds(region.box)) return;
        if (region.bound <= target()) {
            dropped_ = std::max(dropped_, region.bound);
            if (region.hazard == GradientHazard::jump) seams_.push_back(region);
        } else {
            // A jump is worth being found before the bracket is narrow.
            const bool mayDive = region.hazard == GradientHazard::jump && ++jumpsSeen_ % divingPace == 0;
            if (mayDive && dives_++ < earlyDives && diveInto(region.box)) return;
            halve(region);
        }
    }
}

void GradientStudy::begin() {
    if (domain_.empty()) {
        finish(GradientState::unproven);
        return;
    }
    if (!samplePoints()) return;
    lookForSingularities();
    const double bound = bracket_.state == GradientState::running ? boundAroundCenter() : infinite;
    if (bracket_.state == GradientState::running && LoopStop::requested()) return;
    begun_ = true;
    if (bracket_.state == GradientState::running) consider(domain_.box(), bound, GradientHazard::none);
}

void GradientStudy::report() {
    double upper = std::max(bracket_.lower, dropped_);
    if (!queue_.empty()) upper = std::max(upper, queue_.top().bound);
    if (unresolved_ || !boundless_.empty()) upper = infinite;
    bracket_.upper = std::min(bracket_.upper, upper);
    bracket_.boxes = intervals_.evaluations();
    bracket_.seams = mayJump();
}

void GradientStudy::finish(GradientState state) {
    if (!boundless_.empty() && !bracket_.singularity) {
        const Region& region = boundless_.front();
        bracket_.singularity = {region.hazard, domain_.nearest(region.box.center())};
    }
    if (begun_ && !domain_.empty()) report();
    bracket_.seams = mayJump();
    bracket_.state = state;
}

void GradientStudy::beginBeside() {
    whole_ = bracket_;
    beside_ = true;
    bracket_ = {};
    queue_ = {};
    boundless_.clear();
    seams_.clear();
    summits_.clear();
    queuedJumps_ = 0;
    dropped_ = 0;
    probes_ = 0;
    unresolved_ = false;
    leftOut_ = LeftOutCells(domain_.box());
    besideLimit_ = std::min(settings_.boxLimit, intervals_.evaluations() + settings_.boxLimit / besidePart);
    consider(domain_.box(), infinite, GradientHazard::none);
}

void GradientStudy::leaveOut(const GradientBox& box, GradientHazard hazard) {
    // What has no bound anywhere has none beside anything.
    if (hazard == GradientHazard::unknown) unresolved_ = true;
    leftOut_.add(box);
}

void GradientStudy::publish() {
    if (!beside_) return;
    const double reach = leftOut_.empty() ? 0 : leftOut_.width();
    whole_.beside = GradientBeside{bracket_.lower, bracket_.upper, bracket_.place,
                                   bracket_.state, reach,          leftOut_.share()};
    whole_.boxes = intervals_.evaluations();
}

void GradientStudy::setSingular(GradientHazard kind, const glm::dvec3& place) {
    bracket_.singularity = {kind, place};
    bracket_.place = place;
    bracket_.lower = bracket_.upper = infinite;
    bracket_.boxes = intervals_.evaluations();
    bracket_.state = GradientState::unbounded;
}

/// Looks at a box of which `known` is a bound and whose surroundings may hold what `hazard` says.
void GradientStudy::consider(GradientBox box, double known, GradientHazard hazard) {
    while (true) {
        if (bracket_.state != GradientState::running || domain_.misses(box)) return;
        const Finding finding = examine(box);
        if (LoopStop::requested()) {
            // Whatever was found.
            putBack({box, known, axisToHalve(box, glm::dvec3(0)), hazard});
            return;
        }
        if (finding.settled) return;
        known = std::min(known, finding.bound);
        if (finding.hazard == GradientHazard::jump && findJump(box, finding.slope)) return;
        if (finding.shrunk) continue;
        const Region region = regionOf(box, known, finding);
        if (known == infinite) {
            if (beside_ && box.width() <= leftOut_.width() * (1 + 1e-9))
                leaveOut(box, finding.hazard);
            else
                putBack(region);
            return;
        }
        if (known > target()) return putBack(region);
        dropped_ = std::max(dropped_, known);
        if (finding.hazard == GradientHazard::jump) seams_.push_back(region);
        return;
    }
}

GradientStudy::Region GradientStudy::regionOf(const GradientBox& box, double bound, const Finding& finding) {
    Region region{box, bound, axisToHalve(box, finding.influence), finding.hazard};
    GradientBox half = box;
    half.high[region.axis] = 0.5 * box.low[region.axis] + 0.5 * box.high[region.axis];
    glm::dvec3 influence = finding.influence;
    influence[region.axis] *= 0.5;
    region.nextAxis = axisToHalve(half, influence);
    return region;
}

/// By powers of two of what the bound is above the target.
std::size_t GradientStudy::distanceClass(double bound) const {
    const double excess = (bound - target()) / target();
    return static_cast<std::size_t>(std::clamp(std::ilogb(std::max(excess, 1e-300)) + 10, 0, 15));
}

GradientStudy::Finding GradientStudy::examine(GradientBox& box) {
    const IntervalGradient whole = intervals_.evaluate(box.intervals());
    Finding finding;
    finding.hazard = whole.hazard;
    // Those are known to be there.
    if (beside_ && whole.hazard == GradientHazard::jump) finding.hazard = GradientHazard::none;
    finding.settled = whole.value.empty();
    finding.bound = whole.steepness;
    finding.slope = whole.slope;
    for (int k = 0; k < 3; ++k)
        if ((whole.axes >> k & 1) != 0) finding.influence[k] = box.high[k] - box.low[k];
    if (finding.settled || !whole.bounded() || whole.value.maybeUndefined) return finding;
    // Slopes at a point gain nothing where several pieces bend much over the box, or where the box is done
    // with.
    const double turn = normAbove(whole.bend) * 0.5 * glm::length(box.high - box.low);
    const bool pays = !whole.pieced || (turn < 0.1 * whole.steepness && whole.steepness > target());
    if (whole.smooth && pays)
        useCurvature(box, whole, finding);
    else
        useCases(box, whole, finding);
    return finding;
}

glm::dvec3 GradientStudy::middleOf(const GradientBox& box) const {
    const glm::dvec3 p = domain_.nearest(box.center());
    for (int k = 0; k < 3; ++k)
        if (p[k] < box.low[k] || p[k] > box.high[k]) return box.center();
    return p;
}

/// Of a function with the derivatives `piece` over the box and `at` at its point `p`. Sets `growth` to half
/// the gradient of the square of the length.
double GradientStudy::curvatureBound(const GradientDomain& domain, const GradientBox& box,
                                     const glm::dvec3& p, const IntervalGradient& piece,
                                     const IntervalGradient& at, std::array<SlopeRange, 3>& growth,
                                     std::span<const Margin> margins) {
    std::array<SlopeRange, 3> slope = piece.slope;
    const std::array<SlopeRange, 3> ways = box.waysFrom(p);
    for (std::size_t i = 0; i < 3; ++i) {
        SlopeRange from = at.slope[i];
        for (std::size_t j = 0; j < 3; ++j) from = from + piece.bend[bendIndex(i, j)] * ways[j];
        const SlopeRange both = meet(slope[i], from);
        if (both.low <= both.high) slope[i] = both;
    }
    growth = {};
    for (std::size_t i = 0; i < 3; ++i)
        for (std::size_t j = 0; j < 3; ++j) growth[i] = growth[i] + piece.bend[bendIndex(i, j)] * slope[j];
    const double length = std::min(at.steepness, gradient_rules::lengthAbove(at.slope));
    std::array<SlopeRange, 3> change;
    for (std::size_t i = 0; i < 3; ++i) change[i] = 2 * growth[i];
    double grown = domain.advance(change, box, p), added = 0;
    // What is not below 0 may be added, times any factor: with Lagrange's the growth towards the edge of the
    // piece is gone.
    for (const Margin& margin : margins) {
        double along = 0, squares = 0;
        for (std::size_t i = 0; i < 3; ++i) {
            const double slopeInMiddle = 0.5 * margin.slope[i].low + 0.5 * margin.slope[i].high;
            along += (0.5 * change[i].low + 0.5 * change[i].high) * slopeInMiddle;
            squares += slopeInMiddle * slopeInMiddle;
        }
        const double factor = -along / squares;
        if (!(factor > 0) || !std::isfinite(factor)) continue;
        std::array<SlopeRange, 3> next;
        for (std::size_t i = 0; i < 3; ++i) next[i] = change[i] + factor * margin.slope[i];
        const double start = raised(added + raised(factor * margin.at));
        const double less = raised(start + domain.advance(next, box, p));
        if (!(less < grown)) continue;
        grown = less;
        added = start;
        change = next;
    }
    const double square = raised(raised(length * length) + grown);
    return std::min({piece.steepness, gradient_rules::lengthAbove(slope), rootAbove(square)});
}

/// Looks at the corner where the length has grown most.
void GradientStudy::offerSteepest(const GradientBox& box, const std::array<SlopeRange, 3>& growth) {
    const glm::dvec3 rise(growth[0].low + growth[0].high, growth[1].low + growth[1].high,
                          growth[2].low + growth[2].high);
    glm::dvec3 corner;
    for (int k = 0; k < 3; ++k) corner[k] = rise[k] > 0 ? box.high[k] : box.low[k];
    corner = domain_.nearest(corner);
    if (steepnessAt(corner) > bracket_.lower * (1 + 1e-9)) offerPoint(corner);
}

void GradientStudy::useCurvature(GradientBox& box, const IntervalGradient& whole, Finding& finding) {
    const glm::dvec3 p = middleOf(box);
    const std::array<Interval, 3> point{Interval::point(p.x), Interval::point(p.y), Interval::point(p.z)};
    // Of all pieces, whichever the point belongs to.
    const std::size_t choices = intervals_.openChoices();
    const IntervalGradient at =
        whole.pieced ? intervals_.evaluatePieces(point) : intervals_.evaluateSlopes(point);
    if (!at.bounded()) return;
    if (!whole.pieced) offerGradient(p, at);

    std::array<SlopeRange, 3> growth{};
    finding.bound = std::min(finding.bound, curvatureBound(domain_, box, p, whole, at, growth));
    finding.influence *= glm::dvec3(growth[0].size(), growth[1].size(), growth[2].size());
    if (whole.pieced) tryPieces(box, finding, choices);
    // Other points end what is known of the choices of the box.
    if (whole.pieced && steepnessAt(p) > bracket_.lower * (1 + 1e-9)) offerPoint(p);
    offerSteepest(box, growth);
    // Where one piece takes over from another the length may fall.
    if (!whole.pieced) useMonotony(box, growth, finding);
}

/// Where there are no second derivatives: by those of a fold, and of the cases of choices.
void GradientStudy::useCases(const GradientBox& box, const IntervalGradient& whole, Finding& finding) {
    if (finding.bound <= target()) return;
    const auto* given = intervals_.fold();
    const std::optional<IntervalGradientEvaluator::Fold> fold = given ? std::optional(*given) : std::nullopt;
    // Those in loops are not counted.
    const std::size_t choices = intervals_.openChoices();
    std::array<SlopeRange, 3> growth{};
    if (whole.pieced) growth = tryPieces(box, finding, choices);
    if (fold && finding.bound > target()) useFold(box, *fold, finding);
    if (finding.bound <= target()) return;
    if (const glm::dvec3 p = middleOf(box); steepnessAt(p) > bracket_.lower * (1 + 1e-9)) offerPoint(p);
    if (choices > 0) offerSteepest(box, growth);
}

/// usePieces() where there are few choices and it is worth its evaluations.
std::array<SlopeRange, 3> GradientStudy::tryPieces(const GradientBox& box, Finding& finding,
                                                   std::size_t choices) {
    const double before = finding.bound;
    const bool large = box.width() > largeBox * domain_.box().width();
    if (before <= target() || choices == 0 || choices > (large ? mostInLargeBoxes : mostOpenChoices))
        return {};
    if (!casesPay_.tries()) return {};
    const std::array<SlopeRange, 3> growth = usePieces(box, finding, choices);
    // Halving the box three times, for about as many evaluations, takes half of the excess away.
    casesPay_.note(finding.bound - target() < 0.5 * (before - target()));
    return growth;
}

/// The bound of the function of the operand that stands for two or three coordinates, where these alone have
/// no second derivatives: a surface of revolution at its axis.
void GradientStudy::useFold(const GradientBox& box, const IntervalGradientEvaluator::Fold& fold,
                            Finding& finding) {
    const double speed = fold.steepness;
    if (fold.value.empty() || fold.value.maybeUndefined || !(speed > 0 && std::isfinite(speed))) return;
    const IntervalGradient whole = intervals_.evaluateFolded(box.intervals(), fold);
    if (!whole.bounded() || whole.value.empty() || whole.value.maybeUndefined) return;
    double bound = whole.steepness;
    if (whole.smooth && !whole.pieced) {
        const double middle = 0.5 * fold.value.low + 0.5 * fold.value.high;
        glm::dvec3 p = box.center();
        const std::array<Interval, 3> point{Interval::point(p.x), Interval::point(p.y), Interval::point(p.z)};
        const IntervalGradient at =
            intervals_.evaluateFolded(point, {Interval::point(middle), speed, fold.axis});
        // Along the axis of the fold from its middle.
        GradientBox folded = box;
        folded.low[fold.axis] = lowered(lowered((fold.value.low - middle) / speed));
        folded.high[fold.axis] = raised(raised((fold.value.high - middle) / speed));
        p[fold.axis] = 0;
        std::array<SlopeRange, 3> growth{};
        if (at.bounded())
            bound = std::min(bound, curvatureBound(GradientDomain(ContainerBox{folded.low, folded.high}),
                                                   folded, p, whole, at, growth));
    }
    finding.bound = std::min(finding.bound, bound);
}

/// The bound of the case with the largest, and half the gradient of its square. Nothing is known of a case
/// that has no bound.
std::array<SlopeRange, 3> GradientStudy::usePieces(const GradientBox& box, Finding& finding,
                                                   std::size_t choices) {
    const auto range = box.intervals();
    const glm::dvec3 p = middleOf(box);
    const std::array<Interval, 3> point{Interval::point(p.x), Interval::point(p.y), Interval::point(p.z)};
    const unsigned pieces = 1U << choices;
    double steepest = 0;
    std::array<SlopeRange, 3> steepestGrowth{};
    for (unsigned sides = 0; sides < pieces; ++sides) {
        const IntervalGradient piece = intervals_.evaluatePiece(range, sides);
        std::vector<IntervalGradient> margins(intervals_.margins().begin(), intervals_.margins().end());
        if (std::ranges::any_of(margins, [](const auto& margin) { return margin.value.high < 0; })) continue;
        if (!piece.bounded() || piece.value.empty() || piece.value.maybeUndefined) return {};
        double bound = piece.steepness;
        std::array<SlopeRange, 3> growth{};
        if (piece.smooth && !piece.pieced && bound > target()) {
            const IntervalGradient at = intervals_.evaluatePiece(point, sides);
            if (at.bounded()) {
                std::vector<Margin> known;
                for (std::size_t k = 0; k < margins.size(); ++k)
                    if (margins[k].bounded() && intervals_.margins()[k].bounded())
                        known.push_back({intervals_.margins()[k].value.high, margins[k].slope});
                bound = curvatureBound(domain_, box, p, piece, at, growth, known);
            }
        }
        if (bound < steepest) continue;
        steepest = bound;
        steepestGrowth = growth;
    }
    finding.bound = std::min(finding.bound, steepest);
    return steepestGrowth;
}

void GradientStudy::useMonotony(GradientBox& box, const std::array<SlopeRange, 3>& growth,
                                Finding& finding) const {
    if (!domain_.encloses(box)) return;
    for (int k = 0; k < 3; ++k) {
        if (box.low[k] == box.high[k]) continue;
        const SlopeRange& along = growth[static_cast<std::size_t>(k)];
        const bool rises = along.low > 0, falls = along.high < 0;
        if (!rises && !falls) continue;
        // The face where it is longest belongs to a neighbour, which may be left out, or to the container's
        // wall.
        const double face = rises ? box.high[k] : box.low[k];
        const double wall = rises ? domain_.box().high[k] : domain_.box().low[k];
        if (!beside_ && (domain_.isBall() || face != wall)) {
            finding.settled = true;
            return;
        }
        box.low[k] = box.high[k] = face;
        finding.shrunk = true;
    }
}

double GradientStudy::boundAroundCenter() {
    const glm::dvec3 c = domain_.isBall() ? domain_.ballCenter() : domain_.box().center();
    double reach = raised(domain_.radius());
    if (!domain_.isBall()) reach = raised(glm::length(domain_.box().high - c) * (1 + 1e-15));
    const std::array<Interval, 3> point{Interval::point(c.x), Interval::point(c.y), Interval::point(c.z)};
    const IntervalGradient whole = intervals_.evaluate(domain_.box().intervals());
    const IntervalGradient& at = intervals_.evaluatePieces(point);
    if (!whole.bounded() || !whole.smooth || whole.value.maybeUndefined || !at.bounded()) return infinite;
    return raised(at.steepness + raised(normAbove(whole.bend) * reach));
}

void GradientStudy::halve(const Region& region) {
    constexpr double smallest = 0x1p-42;
    const int axis = region.axis;
    const double middle = 0.5 * region.box.low[axis] + 0.5 * region.box.high[axis];
    const bool divisible = middle > region.box.low[axis] && middle < region.box.high[axis];
    const bool tiny = region.box.width() <= smallest * domain_.box().width();
    if (beside_ && !divisible && region.bound == infinite) {
        leaveOut(region.box, region.hazard);
        return;
    }
    if (region.hazard > GradientHazard::jump && (tiny || !divisible)) {
        if (isSingular(region)) return;
        if (LoopStop::requested()) return putBack(region);
        if (!unresolved_) bracket_.singularity = {region.hazard, domain_.nearest(region.box.center())};
        unresolved_ = true;
        ++probes_;
        // The neighbours of this place are hardly different: go on with the largest box.
        if (boundless_.empty()) return;
        boundless_.push_back(boundless_.front());
        boundless_.pop_front();
        return;
    }
    if (!divisible || (tiny && region.bound < infinite)) {
        // Its bound does not fall, and so need not that of others.
        dropped_ = std::max(dropped_, region.bound);
        stuck_ = stuck_ || region.hazard == GradientHazard::jump;
        return;
    }
    if (!leftOut_.empty() && steepnessAt(region.box.center()) > bracket_.lower * (1 + 1e-9))
        offerPoint(region.box.center());
    GradientBox first = region.box, second = region.box;
    first.high[axis] = second.low[axis] = middle;
    // Halves that are seldom done with are not worth being looked at before they are halved.
    double& done = done_[distanceClass(region.bound)];
    const int next = region.nextAxis;
    if (region.bound < infinite && next >= 0 && region.hazard == GradientHazard::none && done < 0.5 &&
        ++quarters_ % 16 != 0) {
        for (const GradientBox& half : {first, second}) {
            const double quarter = 0.5 * half.low[next] + 0.5 * half.high[next];
            GradientBox a = half, b = half;
            a.high[next] = b.low[next] = quarter;
            consider(a, region.bound, region.hazard);
            consider(b, region.bound, region.hazard);
        }
        return;
    }
    for (const GradientBox& half : {first, second}) {
        const std::size_t before = queue_.size() + boundless_.size();
        consider(half, region.bound, region.hazard);
        const bool isDone = queue_.size() + boundless_.size() == before;
        done += ((isDone ? 1 : 0) - done) / 64;
    }
}

/// Leaves a box, with what is known of it, for later.
void GradientStudy::putBack(const Region& region) {
    if (region.bound == infinite) {
        boundless_.push_back(region);
        return;
    }
    queue_.push(region);
    queuedJumps_ += region.hazard == GradientHazard::jump ? 1 : 0;
}

void GradientStudy::offerGradient(const glm::dvec3& point, const IntervalGradient& at) {
    if (!at.bounded() || at.value.empty() || !domain_.contains(point)) return;
    // Before it is known what is left out no point counts.
    if (beside_ && (!besideSampled_ || leftOut_.holds(point))) return;
    const double length = gradient_rules::lengthBelow(at.slope);
    if (length <= bracket_.lower || LoopStop::requested()) return;
    bracket_.lower = length;
    bracket_.place = point;
}

void GradientStudy::offerSlope(const glm::dvec3& point, const glm::dvec3& direction) {
    const double reach = 1e-5 * domain_.box().width();
    const glm::dvec3 a = domain_.nearest(point - reach * direction),
                     b = domain_.nearest(point + reach * direction);
    const double way = glm::distance(a, b) * (1 + 1e-14);
    if (!(way > 0) || !domain_.contains(a) || !domain_.contains(b)) return;
    const double fa = values_.evaluate(a.x, a.y, a.z), fb = values_.evaluate(b.x, b.y, b.z);
    // The values agree with those of real arithmetic to better than this.
    const double rounding = 1e-11 * (1 + std::abs(fa) + std::abs(fb));
    const double slope = (std::abs(fa - fb) - rounding) / way;
    if (!(slope > bracket_.lower) || !std::isfinite(slope) || LoopStop::requested()) return;
    bracket_.lower = slope;
    bracket_.place = point;
}

void GradientStudy::offerPoint(const glm::dvec3& p) {
    const std::array<Interval, 3> point{Interval::point(p.x), Interval::point(p.y), Interval::point(p.z)};
    const IntervalGradient& at = intervals_.evaluate(point);
    offerGradient(p, at);
    // A slope between two points may be that of a jump.
    if (beside_) return;
    if (!at.bounded() || at.value.empty() || at.steepness <= bracket_.lower * 1.001) return;
    // At a kink, and for crackle, the gradient at the point itself proves little; a slope across it does.
    const auto g = gradients_.evaluate(p.x, p.y, p.z).gradient;
    const glm::dvec3 direction(g[0], g[1], g[2]);
    const double length = glm::length(direction);
    if (length > bracket_.lower && length < GradientEvaluator::steepest) offerSlope(p, direction / length);
}

double GradientStudy::target() const {
    return std::max({negligibleSlope, dropped_, bracket_.lower * (1 + 0.999 * settings_.relativeWidth)});
}

bool GradientStudy::isNarrow() const {
    return dropped_ <= std::max(negligibleSlope, bracket_.lower * (1 + settings_.relativeWidth));
}

double GradientStudy::steepnessAt(const glm::dvec3& point) {
    if (leftOut_.holds(point)) return 0;
    const double length = lengthOf(gradients_.evaluate(point.x, point.y, point.z).gradient);
    return length < GradientEvaluator::steepest && !LoopStop::requested() ? length : 0;
}

}  // namespace isoscope
