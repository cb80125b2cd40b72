// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/gradient/gradient_study.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <glm/geometric.hpp>
#include <thread>

#include "core/evaluate/prepared_function.h"
#include "core/evaluate/tape/loop_stop.h"
#include "core/evaluate/tape/tape_axes.h"
#include "core/study/arguments/root_bound.h"

namespace isoscope {

namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();

/// Places at which a missing bound is looked into before it is left open.
constexpr int probeLimit = 60;

/// One in so many boxes that may hold a jump is followed down to a point, up to so many.
constexpr int divingPace = 200, earlyDives = 60;

/// One in so many boxes goes to what is beside infinite gradients.
constexpr std::uint64_t besidePart = 2;

/// The part of the width that bounds may take, so that roundings find room in the rest.
constexpr double targetPart = 0.999;

/// Boxes that are halved at the same time. Not by the number of threads, on which no answer depends.
constexpr std::size_t halvedTogether = 256;
/// Fewer parts are not worth waking a thread.
constexpr std::size_t sharedParts = 8;
/// Memory for the evaluators of threads beside the first.
constexpr std::size_t mostMemory = std::size_t(64) << 20;

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

/// Fewer than wanted where each takes much memory.
int threadsFor(const PreparedFunction& function, int wanted) {
    const std::size_t memory = (1 + function.tape()->slotCount()) * sizeof(IntervalGradient);
    const int most = static_cast<int>(1 + std::min<std::size_t>(mostMemory / memory, 63));
    if (wanted <= 0) wanted = static_cast<int>(std::thread::hardware_concurrency());
    return std::clamp(wanted, 1, most);
}

}  // namespace

GradientStudy::GradientStudy(std::shared_ptr<const Tape> tape, std::span<const double> parameters,
                             const Container& container, GradientStudySettings settings)
    : GradientStudy(PreparedFunction::of(std::move(tape), parameters), container, settings) {}

GradientStudy::GradientStudy(const std::shared_ptr<const PreparedFunction>& function,
                             const Container& container, GradientStudySettings settings)
    : domain_(container), settings_(settings), workers_(threadsFor(*function, settings.threads)) {
    if (std::optional<RidgeFunction> found = RidgeFunction::of(*function, container)) {
        ridge_ = std::make_unique<Ridge>(std::move(*found), function, container);
        domain_ = ridge_->searched.domain;
    }
    searched_ = ridge_ ? ridge_->searched.function : function;
    // Of coordinates without which the gradient is known, one value stands for all.
    const std::uint8_t axes = gradientAxes(*searched_->tape());
    for (int k = 0; k < 3; ++k)
        if ((axes >> k & 1) == 0) domain_ = domain_.flattened(k);
    for (int k = 0; k < workers_.threads(); ++k)
        examiners_.push_back(std::make_unique<BoxExaminer>(searched_, domain_, leftOut_));
}

GradientStudy::Ridge::Ridge(RidgeFunction found, const std::shared_ptr<const PreparedFunction>& function,
                            const Container& around)
    : searched(std::move(found)), container(around), examiner(function, container, nothing) {}

void GradientStudy::Ridge::tell(const GradientBracket& found) {
    // No slope at all is exactly none.
    const auto above = [&](double bound) {
        return bound > 0 ? raised(raised(1 + searched.slack) * bound) : 0;
    };
    const auto inSpace = [&](const glm::dvec3& place) { return searched.placeOf(place, container); };
    // The arguments of a steep place may be those of one just outside the container.
    const auto proveSlope = [&](SteepPlace& best, double lower, const glm::dvec3& place, bool beside) {
        if (!(lower > best.length)) return;
        BoxQuestion question;
        question.steepest = best.length;
        question.beside = beside;
        examiner.ask(question);
        examiner.offerPoint(inSpace(place));
        if (examiner.steepest().length > best.length) best = examiner.steepest();
    };
    bracket = found;
    bracket.upper = above(found.upper);
    if (found.state == GradientState::unbounded) {
        bracket.place = inSpace(found.place);
    } else {
        proveSlope(steepest, found.lower, found.place, false);
        bracket.lower = steepest.length;
        bracket.place = steepest.place;
    }
    if (bracket.singularity) bracket.singularity->place = inSpace(found.singularity->place);
    if (!bracket.beside) return;
    GradientBeside& beside = *bracket.beside;
    beside.upper = above(beside.upper);
    proveSlope(steepestBeside, beside.lower, beside.place, true);
    beside.lower = steepestBeside.length;
    beside.place = steepestBeside.place;
}

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
    const std::uint64_t end = evaluations() + boxes;
    while (true) {
        const bool boundless = bracket_.state == GradientState::unbounded ||
                               (bracket_.state == GradientState::unproven && unresolved_);
        if (boundless && !beside_) beginBeside();
        if (bracket_.state != GradientState::running || evaluations() >= end) break;
        if (!begun_ || stop.stop_requested() || LoopStop::requested()) break;
        if (evaluations() >= (beside_ ? besideLimit_ : settings_.boxLimit))
            finish(GradientState::unproven);
        else
            work(stop);
    }
    if (begun_ && bracket_.state == GradientState::running) report();
    publish();
    return !bracket().settled();
}

/// Takes the next boxes. A stop leaves those that no thread has begun with.
void GradientStudy::work(const std::stop_token& stop) {
    if (!boundless_.empty() && probes_ < probeLimit) {
        // Towards one place, or, where such places are left out, all over.
        const std::size_t taken = beside_ ? std::min(halvedTogether, boundless_.size()) : 1;
        const std::vector<Region> last(boundless_.end() - static_cast<std::ptrdiff_t>(taken),
                                       boundless_.end());
        boundless_.resize(boundless_.size() - taken);
        halve(last, stop);
    } else if (unresolved_) {
        // Nothing has an upper bound any more.
        finish(GradientState::unproven);
    } else if (beside_ && !besideSampled_) {
        besideSampled_ = true;
        besideSampled_ = samplePoints();
    } else if (queue_.empty()) {
        if (!checkSeam()) finish(mayJump() || !isNarrow() ? GradientState::unproven : GradientState::tight);
    } else {
        std::vector<Region> steepest;
        // Those that are hardly less steep than the first: what is far less steep may not matter once a jump
        // is found. One alone that is followed down to a point, which may end the search.
        const double least = target() + 0.9 * (queue_.top().bound - target());
        const bool nearPoint = queue_.top().box.width() < 0x1p-16 * domain_.box().width();
        const std::size_t most = nearPoint ? 1 : halvedTogether;
        while (!queue_.empty() && steepest.size() < most) {
            const Region region = queue_.top();
            if (!steepest.empty() && region.bound < least) break;
            queue_.pop();
            queuedJumps_ -= region.hazard == GradientHazard::jump ? 1 : 0;
            if (isWorthHalving(region)) steepest.push_back(region);
            if (bracket_.state != GradientState::running) break;
        }
        halve(steepest, stop);
    }
}

/// Whether a region of the queue is open. If not, it is done with.
bool GradientStudy::isWorthHalving(const Region& region) {
    if (leftOut_.holds(region.box)) return false;
    if (region.bound <= target()) {
        dropped_ = std::max(dropped_, region.bound);
        if (region.hazard == GradientHazard::jump) seams_.push_back(region);
        return false;
    }
    // A jump is worth being found before the bracket is narrow.
    const bool mayDive = region.hazard == GradientHazard::jump && ++jumpsSeen_ % divingPace == 0;
    return !(mayDive && dives_++ < earlyDives && diveInto(region.box));
}

void GradientStudy::begin() {
    if (domain_.empty()) {
        finish(GradientState::unproven);
        return;
    }
    if (!samplePoints()) return;
    lookForSingularities();
    double bound = infinite;
    if (bracket_.state == GradientState::running) {
        const RootBound byRoots = boundByRoots(*searched_, domain_, target());
        boxesByRoots_ = byRoots.boxes;
        bound = std::min(examiner().boundAroundCenter(), byRoots.bound);
    }
    if (bracket_.state == GradientState::running && LoopStop::requested()) return;
    begun_ = true;
    if (bracket_.state == GradientState::running) consider(domain_.box(), bound, GradientHazard::none);
}

void GradientStudy::report() {
    double upper = std::max(bracket_.lower, dropped_);
    if (!queue_.empty()) upper = std::max(upper, queue_.top().bound);
    if (unresolved_ || !boundless_.empty()) upper = infinite;
    bracket_.upper = std::min(bracket_.upper, upper);
    bracket_.boxes = evaluations();
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
    besideLimit_ = std::min(settings_.boxLimit, evaluations() + settings_.boxLimit / besidePart);
    consider(domain_.box(), infinite, GradientHazard::none);
}

void GradientStudy::leaveOut(const GradientBox& box, GradientHazard hazard) {
    // What has no bound anywhere has none beside anything.
    if (hazard == GradientHazard::unknown) unresolved_ = true;
    leftOut_.add(box);
}

void GradientStudy::publish() {
    if (beside_) {
        const double reach = leftOut_.empty() ? 0 : leftOut_.width();
        whole_.beside = GradientBeside{bracket_.lower, bracket_.upper, bracket_.place,
                                       bracket_.state, reach,          leftOut_.share()};
        whole_.boxes = evaluations();
        // What is attained beside some places is attained.
        if (bracket_.lower > whole_.lower) {
            whole_.lower = bracket_.lower;
            whole_.place = bracket_.place;
        }
    }
    if (ridge_) ridge_->tell(beside_ ? whole_ : bracket_);
}

void GradientStudy::setSingular(GradientHazard kind, const glm::dvec3& place) {
    bracket_.singularity = {kind, place};
    bracket_.place = place;
    bracket_.lower = bracket_.upper = infinite;
    bracket_.boxes = evaluations();
    bracket_.state = GradientState::unbounded;
}

/// Looks at a box of which `bound` is known and whose surroundings may hold what `hazard` says.
void GradientStudy::consider(const GradientBox& box, double bound, GradientHazard hazard) {
    const BoxQuestion asked = question();
    adopt(examiner().examine(box, bound, asked), hazard);
}

/// Takes over what was found of a box in a neighbourhood with that hazard. Returns whether the box is done
/// with.
bool GradientStudy::adopt(const ExaminedBox& answer, GradientHazard hazard) {
    if (bracket_.state != GradientState::running) return true;
    const auto& [state, box, bound, finding, jump, steepest, casesTried, casesPaid, middleTried, middlePaid,
                 finerClass, finerPaid] = answer;
    accept(steepest);
    for (unsigned k = 0; k < casesTried; ++k) casesPay_.note(k < casesPaid);
    for (unsigned k = 0; k < middleTried; ++k) middlePays_.note(k < middlePaid);
    if (finerClass) finerPays_[*finerClass].note(finerPaid);
    if (jump) {
        setSingular(GradientHazard::jump, *jump);
        return true;
    }
    if (state == ExaminedBox::State::stopped) {
        putBack({.box = box, .bound = bound, .axis = axisToHalve(box, {}), .hazard = hazard, .isNew = true});
        return false;
    }
    if (state == ExaminedBox::State::done) return true;
    const Region region = regionOf(box, bound, finding);
    if (bound == infinite && beside_ && box.width() <= leftOutWidth() * (1 + 1e-9)) {
        leaveOut(box, finding.hazard);
        return true;
    }
    if (bound > target()) {
        putBack(region);
        return false;
    }
    dropped_ = std::max(dropped_, bound);
    if (finding.hazard == GradientHazard::jump) seams_.push_back(region);
    return true;
}

BoxQuestion GradientStudy::question() {
    std::uint32_t finerClasses = 0;
    for (std::size_t k = 0; k < distanceClasses; ++k) finerClasses |= finerPays_[k].tries() ? 1U << k : 0;
    return {.steepest = bracket_.lower,
            .target = target(),
            .widening = 1 + targetPart * settings_.relativeWidth,
            .beside = beside_,
            .placesCount = !beside_ || besideSampled_,
            .triesCases = casesPay_.tries(),
            .triesMiddle = middlePays_.tries(),
            .finerClasses = finerClasses};
}

void GradientStudy::accept(const SteepPlace& found) {
    if (found.length <= bracket_.lower) return;
    bracket_.lower = found.length;
    bracket_.place = found.place;
}

void GradientStudy::offerPoint(const glm::dvec3& point) {
    examiner().ask(question());
    examiner().offerPoint(point);
    accept(examiner().steepest());
}

std::uint64_t GradientStudy::evaluations() const {
    std::uint64_t all = boxesByRoots_;
    for (const auto& examiner : examiners_) all += examiner->evaluations();
    return all;
}

GradientStudy::Region GradientStudy::regionOf(const GradientBox& box, double bound,
                                              const BoxFinding& finding) {
    Region region{box, bound, axisToHalve(box, finding.influence), finding.hazard};
    GradientBox half = box;
    half.high[region.axis] = 0.5 * box.low[region.axis] + 0.5 * box.high[region.axis];
    glm::dvec3 influence = finding.influence;
    influence[region.axis] *= 0.5;
    region.nextAxis = axisToHalve(half, influence);
    return region;
}

/// Halves regions, or quarters them, and looks at the parts, each by the next thread that has time. What is
/// found of them is taken over in their order.
void GradientStudy::halve(std::span<const Region> regions, const std::stop_token& stop) {
    std::vector<Part> parts;
    for (const Region& region : regions)
        if (bracket_.state != GradientState::running)
            putBack(region);
        else if (isDivisible(region))
            addParts(region, parts);
    std::vector<ExaminedBox> answers(parts.size());
    std::atomic<std::size_t> next{0};
    const std::stop_token loops = LoopStop::current();
    const auto work = [&](std::size_t worker) {
        const LoopStop stopLoops(loops);
        for (std::size_t i = next++; i < parts.size(); i = next++) {
            const Part& part = parts[i];
            answers[i].box = part.box;
            answers[i].bound = part.bound;
            answers[i].state = ExaminedBox::State::stopped;
            if (!stop.stop_requested())
                answers[i] = examiners_[worker]->examine(part.box, part.bound, part.question);
        }
    };
    if (parts.size() < sharedParts)
        work(0);
    else
        workers_.run(examiners_.size(), work);
    for (std::size_t i = 0; i < parts.size(); ++i) {
        const bool isDone = adopt(answers[i], parts[i].hazard);
        if (double* done = parts[i].done) *done += ((isDone ? 1 : 0) - *done) / 64;
    }
}

/// Whether a region can be halved. If not, it is dealt with.
bool GradientStudy::isDivisible(const Region& region) {
    if (region.isNew) return true;
    constexpr double smallest = 0x1p-42;
    const double middle = 0.5 * region.box.low[region.axis] + 0.5 * region.box.high[region.axis];
    const bool divisible = middle > region.box.low[region.axis] && middle < region.box.high[region.axis];
    const bool tiny = region.box.width() <= smallest * domain_.box().width();
    if (beside_ && !divisible && region.bound == infinite) {
        leaveOut(region.box, region.hazard);
        return false;
    }
    if (region.hazard > GradientHazard::jump && (tiny || !divisible)) {
        if (isSingular(region)) return false;
        if (LoopStop::requested()) {
            putBack(region);
            return false;
        }
        if (!unresolved_) bracket_.singularity = {region.hazard, domain_.nearest(region.box.center())};
        unresolved_ = true;
        ++probes_;
        // The neighbours of this place are hardly different: go on with the largest box.
        if (boundless_.empty()) return false;
        boundless_.push_back(boundless_.front());
        boundless_.pop_front();
        return false;
    }
    if (divisible && !(tiny && region.bound < infinite)) return true;
    // Its bound does not fall, and so need not that of others.
    dropped_ = std::max(dropped_, region.bound);
    stuck_ = stuck_ || region.hazard == GradientHazard::jump;
    return false;
}

void GradientStudy::addParts(const Region& region, std::vector<Part>& parts) {
    const auto halvesOf = [](const GradientBox& box, int axis) {
        std::array<GradientBox, 2> halves{box, box};
        halves[0].high[axis] = halves[1].low[axis] = 0.5 * box.low[axis] + 0.5 * box.high[axis];
        return halves;
    };
    if (region.isNew) {
        parts.push_back({region.box, region.bound, region.hazard, question(), nullptr});
        return;
    }
    // Halves that are seldom done with are not worth being looked at before they are halved.
    double& done = done_[distanceClass(region.bound, target())];
    const bool quarters = region.bound < infinite && region.nextAxis >= 0 &&
                          region.hazard == GradientHazard::none && done < 0.5 && ++quarters_ % 16 != 0;
    for (const GradientBox& half : halvesOf(region.box, region.axis)) {
        if (!quarters) {
            parts.push_back({half, region.bound, region.hazard, question(), &done});
            continue;
        }
        for (const GradientBox& quarter : halvesOf(half, region.nextAxis))
            parts.push_back({quarter, region.bound, region.hazard, question(), nullptr});
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

double GradientStudy::target() const {
    return std::max({negligibleSlope, dropped_, bracket_.lower * (1 + targetPart * settings_.relativeWidth)});
}

/// As wide as boxes without a bound may be to be left out. On fewer axes smaller ones cost little.
double GradientStudy::leftOutWidth() const {
    const glm::dvec3 extent = domain_.box().high - domain_.box().low;
    const bool isFlat = extent.x == 0 || extent.y == 0 || extent.z == 0;
    return isFlat ? 0.5 * leftOut_.width() : leftOut_.width();
}

bool GradientStudy::isNarrow() const {
    return dropped_ <= std::max(negligibleSlope, bracket_.lower * (1 + settings_.relativeWidth));
}

}  // namespace isoscope
