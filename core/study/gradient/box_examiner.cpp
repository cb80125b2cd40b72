// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/gradient/box_examiner.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "core/evaluate/prepared_function.h"
#include "core/evaluate/tape/loop_stop.h"

namespace isoscope {

namespace {

/// Choices whose cases are looked at one by one: in boxes below a part of the container, and in larger ones.
constexpr std::size_t mostOpenChoices = 4, mostInLargeBoxes = 1;
constexpr double largeBox = 1.0 / 48;

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

std::array<Interval, 3> pointAt(const glm::dvec3& p) {
    return {Interval::point(p.x), Interval::point(p.y), Interval::point(p.z)};
}

}  // namespace

std::size_t distanceClass(double bound, double target) {
    constexpr int nearest = -10, farthest = 5;
    static_assert(farthest - nearest + 1 == distanceClasses);
    const double excess = (bound - target) / target;
    if (!(excess < 0x1p5)) return farthest - nearest;
    return static_cast<std::size_t>(std::ilogb(std::max(excess, 0x1p-10)) - nearest);
}

BoxExaminer::BoxExaminer(const std::shared_ptr<const PreparedFunction>& function,
                         const GradientDomain& domain, const LeftOutCells& leftOut)
    : domain_(domain), leftOut_(leftOut), intervals_(*function), gradients_(function), values_(function) {}

ExaminedBox BoxExaminer::examine(GradientBox box, double bound, const BoxQuestion& question) {
    ask(question);
    ExaminedBox answer;
    const std::uint64_t before = intervals_.evaluations();
    // Where boxes have no bound nothing else looks for steep places.
    if (!leftOut_.empty()) offerIfSteeper(box.center());
    while (!domain_.misses(box)) {
        GradientBox part = box;
        const BoxFinding finding = find(part);
        // Whatever was found, and whatever has become of the box.
        if (LoopStop::requested()) {
            answer.state = ExaminedBox::State::stopped;
            stoppedEvaluations_ += intervals_.evaluations() - before;
            break;
        }
        box = part;
        if (finding.settled) break;
        bound = std::min(bound, finding.bound);
        if (finding.hazard == GradientHazard::jump) answer.jump = findJump(box, finding.slope);
        if (answer.jump) break;
        if (finding.shrunk) continue;
        answer.state = ExaminedBox::State::open;
        answer.finding = finding;
        break;
    }
    answer.box = box;
    answer.bound = bound;
    answer.steepest = steepest_;
    answer.casesTried = casesTried_;
    answer.casesPaid = casesPaid_;
    answer.middleTried = middleTried_;
    answer.middlePaid = middlePaid_;
    answer.finerClass = finerClass_;
    answer.finerPaid = finerPaid_;
    return answer;
}

double BoxExaminer::boundAroundCenter() {
    const glm::dvec3 c = domain_.isBall() ? domain_.ballCenter() : domain_.box().center();
    double reach = raised(domain_.radius());
    if (!domain_.isBall()) reach = raised(glm::length(domain_.box().high - c) * (1 + 1e-15));
    const IntervalGradient whole = intervals_.evaluate(domain_.box().intervals());
    const IntervalGradient& at = intervals_.evaluatePieces(pointAt(c));
    if (!whole.bounded() || !whole.smooth || whole.value.maybeUndefined || !at.bounded())
        return std::numeric_limits<double>::infinity();
    return raised(at.steepness + raised(normAbove(whole.bend) * reach));
}

void BoxExaminer::ask(const BoxQuestion& question) {
    question_ = question;
    steepest_ = {};
    casesTried_ = casesPaid_ = middleTried_ = middlePaid_ = 0;
    finerClass_.reset();
}

double BoxExaminer::target() const {
    return std::max(question_.target, steepest_.length * question_.widening);
}

bool BoxExaminer::isSteeper(double length) const {
    return length > std::max(question_.steepest, steepest_.length);
}

void BoxExaminer::offerIfSteeper(const glm::dvec3& point) {
    if (isSteeper(steepnessAt(point) / (1 + 1e-9))) offerPoint(point);
}

/// What is known of a box; with more work where that has no bound.
IntervalGradient BoxExaminer::enclosure(const GradientBox& box) {
    IntervalGradient whole = intervals_.evaluate(box.intervals());
    if (!question_.triesMiddle || whole.hazard <= GradientHazard::jump || whole.value.empty()) return whole;
    const IntervalGradient& aboutMiddle = intervals_.evaluateAboutMiddle(box.intervals());
    ++middleTried_;
    if (aboutMiddle.hazard < whole.hazard) {
        ++middlePaid_;
        whole = aboutMiddle;
    }
    return whole;
}

BoxFinding BoxExaminer::find(GradientBox& box) {
    const IntervalGradient whole = enclosure(box);
    BoxFinding finding;
    finding.hazard = whole.hazard;
    // Those are known to be there.
    if (question_.beside && whole.hazard == GradientHazard::jump) finding.hazard = GradientHazard::none;
    finding.settled = whole.value.empty();
    finding.bound = whole.steepness;
    finding.slope = whole.slope;
    for (int k = 0; k < 3; ++k)
        if ((whole.axes >> k & 1) != 0) finding.influence[k] = box.high[k] - box.low[k];
    if (whole.hazard == GradientHazard::jump && finding.bound > target())
        finding.bound = std::min(finding.bound, boundBesideJumps(box));
    if (finding.settled || !whole.bounded() || whole.value.maybeUndefined) return finding;
    // Slopes at a point gain nothing where several pieces bend much over the box, or where the box is done
    // with.
    const double turn = normAbove(whole.bend) * 0.5 * glm::length(box.high - box.low);
    const bool pays = !whole.pieced || (turn < 0.1 * whole.steepness && whole.steepness > target());
    if (whole.smooth && pays)
        useCurvature(box, whole, finding);
    else
        useCases(box, finding);
    return finding;
}

/// The bound of what the function is beside its jumps, each of which leaves one side or the other; infinite
/// where there are many.
double BoxExaminer::boundBesideJumps(const GradientBox& box) {
    constexpr std::size_t mostJumps = 4;
    const auto range = box.intervals();
    double most = 0;
    unsigned sides = 0;
    while (true) {
        const IntervalGradient& piece = intervals_.evaluateBesideJumps(range, sides);
        if (intervals_.jumpsMet() > mostJumps) return std::numeric_limits<double>::infinity();
        most = std::max(most, piece.steepness);
        // The next in order: the last jump that has its first side takes the other.
        unsigned last = static_cast<unsigned>(intervals_.jumpsMet());
        while (last > 0 && (sides >> (last - 1) & 1) != 0) --last;
        if (last == 0) return most;
        sides = (sides & ((1U << (last - 1)) - 1)) | 1U << (last - 1);
    }
}

glm::dvec3 BoxExaminer::middleOf(const GradientBox& box) const {
    const glm::dvec3 p = domain_.nearest(box.center());
    for (int k = 0; k < 3; ++k)
        if (p[k] < box.low[k] || p[k] > box.high[k]) return box.center();
    return p;
}

/// Of a function with the derivatives `piece` over the box and `at` at its point `p`. Sets `growth` to half
/// the gradient of the square of the length.
double BoxExaminer::curvatureBound(const GradientDomain& domain, const GradientBox& box, const glm::dvec3& p,
                                   const IntervalGradient& piece, const IntervalGradient& at,
                                   std::array<SlopeRange, 3>& growth, std::span<const Margin> margins) {
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
    const double grown = growthWithin(margins, change, domain, box, p);
    const double square = raised(raised(length * length) + grown);
    return std::min({piece.steepness, gradient_rules::lengthAbove(slope), rootAbove(square)});
}

/// Looks at the corner where the length has grown most.
void BoxExaminer::offerSteepest(const GradientBox& box, const std::array<SlopeRange, 3>& growth) {
    const glm::dvec3 rise(growth[0].low + growth[0].high, growth[1].low + growth[1].high,
                          growth[2].low + growth[2].high);
    glm::dvec3 corner;
    for (int k = 0; k < 3; ++k) corner[k] = rise[k] > 0 ? box.high[k] : box.low[k];
    corner = domain_.nearest(corner);
    offerIfSteeper(corner);
}

void BoxExaminer::useCurvature(GradientBox& box, const IntervalGradient& whole, BoxFinding& finding) {
    const glm::dvec3 p = middleOf(box);
    const std::array<Interval, 3> point = pointAt(p);
    // Of all pieces, whichever the point belongs to.
    const std::size_t choices = intervals_.openChoices();
    const IntervalGradient at =
        whole.pieced ? intervals_.evaluatePieces(point) : intervals_.evaluateSlopes(point);
    if (!at.bounded()) return;
    if (!whole.pieced) offerGradient(p, at);

    std::array<SlopeRange, 3> growth{};
    finding.bound = std::min(finding.bound, curvatureBound(domain_, box, p, whole, at, growth));
    if (!whole.pieced) useFiner(box, p, at, finding, growth);
    finding.influence *= glm::dvec3(growth[0].size(), growth[1].size(), growth[2].size());
    if (whole.pieced) tryPieces(box, finding, choices);
    // Other points end what is known of the choices of the box.
    if (whole.pieced) offerIfSteeper(p);
    offerSteepest(box, growth);
    // Where one piece takes over from another the length may fall.
    if (!whole.pieced) useMonotony(box, growth, finding);
}

/// The bound by enclosures that are worth their work where bends are known badly. `at`: of the point `p`.
void BoxExaminer::useFiner(const GradientBox& box, const glm::dvec3& p, const IntervalGradient& at,
                           BoxFinding& finding, std::array<SlopeRange, 3>& growth) {
    if (finding.bound <= target()) return;
    const std::size_t distance = distanceClass(finding.bound, target());
    if ((question_.finerClasses >> distance & 1) == 0 || !intervals_.hasFiner()) return;
    const IntervalGradient slopes = at;
    const IntervalGradient finer = intervals_.evaluateFinely(box.intervals());
    finding.bound = std::min(finding.bound, curvatureBound(domain_, box, p, finer, slopes, growth));
    finerClass_ = distance;
    finerPaid_ = finding.bound <= target();
}

/// Where there are no second derivatives: by those of a fold, and of the cases of choices.
void BoxExaminer::useCases(const GradientBox& box, BoxFinding& finding) {
    if (finding.bound <= target()) return;
    const auto* given = intervals_.fold();
    const std::optional<IntervalGradientEvaluator::Fold> fold = given ? std::optional(*given) : std::nullopt;
    // Those in loops are not counted.
    const std::size_t choices = intervals_.openChoices();
    const bool blurred = intervals_.hasBlurredRoots();
    const std::array<SlopeRange, 3> growth = tryPieces(box, finding, choices);
    if (fold && finding.bound > target()) useFold(box, *fold, finding);
    if (blurred && finding.bound > target())
        finding.bound = std::min(finding.bound, intervals_.steepnessByRoots(box.intervals()));
    if (finding.bound <= target()) return;
    offerIfSteeper(middleOf(box));
    if (choices > 0) offerSteepest(box, growth);
}

/// usePieces() where there are few choices and it is worth its evaluations.
std::array<SlopeRange, 3> BoxExaminer::tryPieces(const GradientBox& box, BoxFinding& finding,
                                                 std::size_t choices) {
    const double before = finding.bound;
    const bool large = box.width() > largeBox * domain_.box().width();
    if (!question_.triesCases || before <= target() || choices == 0 ||
        choices > (large ? mostInLargeBoxes : mostOpenChoices))
        return {};
    const std::array<SlopeRange, 3> growth = usePieces(box, finding, choices);
    // Halving the box three times, for about as many evaluations, takes half of the excess away.
    ++casesTried_;
    casesPaid_ += finding.bound - target() < 0.5 * (before - target()) ? 1 : 0;
    return growth;
}

/// The bound of the function of the operand that stands for two or three coordinates, where these alone have
/// no second derivatives: a surface of revolution at its axis.
void BoxExaminer::useFold(const GradientBox& box, const IntervalGradientEvaluator::Fold& fold,
                          BoxFinding& finding) {
    const double speed = fold.steepness;
    if (fold.value.empty() || fold.value.maybeUndefined || !(speed > 0 && std::isfinite(speed))) return;
    const IntervalGradient whole = intervals_.evaluateFolded(box.intervals(), fold);
    if (!whole.bounded() || whole.value.empty() || whole.value.maybeUndefined) return;
    double bound = whole.steepness;
    if (whole.smooth && !whole.pieced) {
        const double middle = 0.5 * fold.value.low + 0.5 * fold.value.high;
        glm::dvec3 p = box.center();
        const std::array<Interval, 3> point = pointAt(p);
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
std::array<SlopeRange, 3> BoxExaminer::usePieces(const GradientBox& box, BoxFinding& finding,
                                                 std::size_t choices) {
    const auto range = box.intervals();
    const glm::dvec3 p = middleOf(box);
    const std::array<Interval, 3> point = pointAt(p);
    const unsigned pieces = 1U << choices;
    double steepest = 0;
    std::array<SlopeRange, 3> steepestGrowth{};
    for (unsigned sides = 0; sides < pieces; ++sides) {
        IntervalGradient piece = intervals_.evaluatePiece(range, sides);
        std::vector<IntervalGradient> margins(intervals_.margins().begin(), intervals_.margins().end());
        if (std::ranges::any_of(margins, [](const auto& margin) { return margin.value.high < 0; })) continue;
        if (!piece.bounded() || piece.value.maybeUndefined)
            piece = intervals_.evaluatePossiblePiece(range, sides);
        if (!piece.bounded() || piece.value.maybeUndefined) return {};
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

void BoxExaminer::useMonotony(GradientBox& box, const std::array<SlopeRange, 3>& growth,
                              BoxFinding& finding) const {
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
        if (!question_.beside && (domain_.isBall() || face != wall)) {
            finding.settled = true;
            return;
        }
        box.low[k] = box.high[k] = face;
        finding.shrunk = true;
    }
}

void BoxExaminer::offerGradient(const glm::dvec3& point, const IntervalGradient& at) {
    if (!at.bounded() || at.value.empty() || !domain_.contains(point)) return;
    if (!question_.placesCount || (question_.beside && leftOut_.holds(point))) return;
    const double length = gradient_rules::lengthBelow(at.slope);
    if (isSteeper(length) && !LoopStop::requested()) steepest_ = {length, point};
}

void BoxExaminer::offerSlope(const glm::dvec3& point, const glm::dvec3& direction) {
    const double reach = 1e-5 * domain_.box().width();
    const glm::dvec3 a = domain_.nearest(point - reach * direction),
                     b = domain_.nearest(point + reach * direction);
    const double way = glm::distance(a, b) * (1 + 1e-14);
    if (!(way > 0) || !domain_.contains(a) || !domain_.contains(b)) return;
    const double fa = valueAt(a), fb = valueAt(b);
    // The values agree with those of real arithmetic to better than this.
    const double rounding = 1e-11 * (1 + std::abs(fa) + std::abs(fb));
    const double slope = (std::abs(fa - fb) - rounding) / way;
    if (isSteeper(slope) && std::isfinite(slope) && !LoopStop::requested()) steepest_ = {slope, point};
}

void BoxExaminer::offerPoint(const glm::dvec3& p) {
    const std::array<Interval, 3> point = pointAt(p);
    const IntervalGradient& at = intervals_.evaluate(point);
    offerGradient(p, at);
    // A slope between two points may be that of a jump.
    if (question_.beside) return;
    if (!at.bounded() || at.value.empty() || !isSteeper(at.steepness / 1.001)) return;
    // At a kink, and for crackle, the gradient at the point itself proves little; a slope across it does.
    const auto g = gradients_.evaluate(p.x, p.y, p.z).gradient;
    const glm::dvec3 direction(g[0], g[1], g[2]);
    const double length = glm::length(direction);
    if (isSteeper(length) && length < GradientEvaluator::steepest) offerSlope(p, direction / length);
}

double BoxExaminer::steepnessAt(const glm::dvec3& point) {
    if (leftOut_.holds(point)) return 0;
    const double length = slopeOf(gradients_.evaluate(point.x, point.y, point.z));
    return length < GradientEvaluator::steepest && !LoopStop::requested() ? length : 0;
}

std::optional<glm::dvec3> BoxExaminer::findJump(const GradientBox& box,
                                                const std::array<SlopeRange, 3>& slope) {
    if (question_.beside) return {};
    const glm::dvec3 c = box.center();
    const auto at = [&](int x, int y, int z) {
        const auto along = [](int side, double low, double middle, double high) {
            return side < 0 ? low : side > 0 ? high : middle;
        };
        return glm::dvec3(along(x, box.low.x, c.x, box.high.x), along(y, box.low.y, c.y, box.high.y),
                          along(z, box.low.z, c.z, box.high.z));
    };
    constexpr int ends[7][3] = {{1, 0, 0},  {0, 1, 0},  {0, 0, 1}, {1, 1, 1},
                                {1, 1, -1}, {1, -1, 1}, {-1, 1, 1}};
    for (const auto& e : ends)
        if (const auto jump = jumpBetween(at(e[0], e[1], e[2]), at(-e[0], -e[1], -e[2]), slope)) return jump;
    return {};
}

/// Holds the value at a point in real arithmetic.
Interval BoxExaminer::realValueAt(const glm::dvec3& p) {
    const std::array<Interval, 3> point = pointAt(p);
    return intervals_.evaluate(point).value;
}

/// A place between two points whose values differ by more than the slopes between them allow. It is found by
/// halving, for one half at least differs too much as well.
std::optional<glm::dvec3> BoxExaminer::jumpBetween(const glm::dvec3& a, const glm::dvec3& b,
                                                   const std::array<SlopeRange, 3>& slope) {
    if (!domain_.contains(a) || !domain_.contains(b)) return {};
    const auto climb = [&](const glm::dvec3& p, const glm::dvec3& q) {
        const glm::dvec3 way = glm::abs(p - q);
        return (slope[0].size() * way.x + slope[1].size() * way.y + slope[2].size() * way.z) * (1 + 1e-9);
    };
    glm::dvec3 first = a, last = b;
    double f = valueAt(first), l = valueAt(last);
    if (!(std::abs(f - l) > climb(a, b) + 1e-9 * (std::abs(f) + std::abs(l)))) return {};
    const auto excess = [&](const glm::dvec3& p, double fp, const glm::dvec3& q, double fq) {
        return std::abs(fp - fq) - climb(p, q);
    };
    for (int halvings = 0; halvings < 60; ++halvings) {
        const glm::dvec3 middle = 0.5 * first + 0.5 * last;
        const double m = valueAt(middle);
        if (!std::isfinite(m)) break;
        if (excess(first, f, middle, m) >= excess(middle, m, last, l)) {
            last = middle;
            l = m;
        } else {
            first = middle;
            f = m;
        }
    }
    if (!isJump(first, glm::normalize(b - a)) || LoopStop::requested()) return {};
    return first;
}

/// A proof, for what was found by doubles may be made of their roundings: whether the values at both sides of
/// a place differ by more than the slopes between them.
bool BoxExaminer::isJump(const glm::dvec3& place, const glm::dvec3& direction) {
    const double reach = 1e-9 * domain_.box().width();
    const glm::dvec3 p = domain_.nearest(place - reach * direction),
                     q = domain_.nearest(place + reach * direction);
    const GradientBox between{glm::min(p, q), glm::max(p, q)};
    const IntervalGradient whole = intervals_.evaluate(between.intervals());
    if (whole.hazard > GradientHazard::jump) return false;
    const std::array<SlopeRange, 3> ways = GradientBox{p, p}.waysFrom(q);
    double climb = 0;
    for (std::size_t k = 0; k < 3; ++k)
        climb = raised(climb + raised(whole.slope[k].size() * ways[k].size()));
    const Interval first = realValueAt(p), last = realValueAt(q);
    return std::max(first.low - last.high, last.low - first.high) > climb * (1 + 1e-9);
}

}  // namespace isoscope
