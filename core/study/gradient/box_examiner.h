// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <glm/vec3.hpp>
#include <limits>
#include <memory>
#include <optional>
#include <span>

#include "core/evaluate/gradient_evaluator.h"
#include "core/evaluate/interval_gradient_evaluator.h"
#include "core/evaluate/point_evaluator.h"
#include "core/study/gradient/gradient_domain.h"
#include "core/study/gradient/left_out_cells.h"
#include "core/study/gradient/margin.h"

namespace isoscope {

/// A gradient that is attained, rounding included: what bounds are compared with.
struct SteepPlace {
    double length = 0;
    glm::dvec3 place{0};
};

/// What a study knows when it asks about a box.
struct BoxQuestion {
    double steepest = 0;               ///< the length of a gradient that is attained
    double target = 0;                 ///< what a bound need not be below
    double widening = 1;               ///< target / steepest, where that gradient decides
    bool beside = false;               ///< whether jumps and what is left out are known
    bool placesCount = true;           ///< whether steeper places are looked for
    bool triesCases = true;            ///< whether the cases of open choices are worth their evaluations
    bool triesMiddle = true;           ///< whether what has no bound is worth evaluateAboutMiddle()
    std::uint32_t finerClasses = ~0U;  ///< bit k: whether finer enclosures are, of a box of distance class k
};

/// By powers of two of how far a bound is above the target; without a bound it is as far as can be.
constexpr std::size_t distanceClasses = 16;
std::size_t distanceClass(double bound, double target);

/// What evaluations of a box, or of parts of it, say.
struct BoxFinding {
    double bound = 0;
    GradientHazard hazard = GradientHazard::none;
    std::array<SlopeRange, 3> slope{};
    glm::dvec3 influence{0};  ///< how much each axis contributes to the uncertainty
    bool settled = false;     ///< nothing in the box can be the largest
    bool shrunk = false;      ///< the box has become a part of a wall of the container
};

/// The answer to a question about a box.
struct ExaminedBox {
    /// Done with; open, so that parts of it are worth a look; or left by a stop, and nothing is known of it.
    enum class State : std::uint8_t { done, open, stopped };
    State state = State::done;
    GradientBox box;  ///< or the part of it that counts
    double bound = 0;
    BoxFinding finding;
    std::optional<glm::dvec3> jump;  ///< a place where the value jumps; nothing else counts then
    SteepPlace steepest;             ///< the steepest place met that is steeper than asked
    unsigned casesTried = 0, casesPaid = 0;
    unsigned middleTried = 0, middlePaid = 0;  ///< evaluateAboutMiddle(), and with less of a hazard
    std::optional<std::size_t> finerClass;     ///< the distance class of a box that was enclosed finely
    bool finerPaid = false;                    ///< whether that was the end of it
};

/// What is proven of the gradient in single boxes, and of values at both sides of a place: the part of a
/// GradientStudy that evaluates. Answers depend on the question alone, not on those before. One object per
/// thread; the domain and the cells are the study's, and must not change during a call.
class BoxExaminer {
  public:
    BoxExaminer(const std::shared_ptr<const PreparedFunction>& function, const GradientDomain& domain,
                const LeftOutCells& leftOut);

    /// Answers a question about a box of which `bound` is known. A LoopStop of this thread ends it early.
    ExaminedBox examine(GradientBox box, double bound, const BoxQuestion& question);

    /// A bound for the whole domain, by its middle; infinite where the function has no second derivatives.
    double boundAroundCenter();

    /// Sets the question for the following calls, and forgets the steepest place.
    void ask(const BoxQuestion& question);
    /// The steepest place met since ask() that is steeper than the question says; length 0 if none.
    const SteepPlace& steepest() const { return steepest_; }
    /// By doubles: 0 for what is left out, or has no gradient.
    double steepnessAt(const glm::dvec3& point);
    /// Proves how steep it is at a point, if that may be the steepest.
    void offerPoint(const glm::dvec3& point);
    /// A place of the box where the value certainly jumps: two values of it differ by more than slopes in
    /// `slope` allow. None where jumps are known already.
    std::optional<glm::dvec3> findJump(const GradientBox& box, const std::array<SlopeRange, 3>& slope);

    /// What it evaluates by; the next call of examine() takes nothing from their last results.
    IntervalGradientEvaluator& intervals() { return intervals_; }
    /// Gradients by doubles.
    GradientEvaluator& gradients() { return gradients_; }
    /// By doubles; NaN where the function has no value.
    double valueAt(const glm::dvec3& p) { return values_.evaluate(p.x, p.y, p.z); }
    /// Boxes evaluated so far. Those of a box that a stop left for later do not count: they come again.
    std::uint64_t evaluations() const { return intervals_.evaluations() - stoppedEvaluations_; }

  private:
    double target() const;
    bool isSteeper(double length) const;
    void offerSlope(const glm::dvec3& point, const glm::dvec3& direction);
    void offerGradient(const glm::dvec3& point, const IntervalGradient& at);
    void offerIfSteeper(const glm::dvec3& point);
    void offerSteepest(const GradientBox& box, const std::array<SlopeRange, 3>& growth);
    IntervalGradient enclosure(const GradientBox& box);
    BoxFinding find(GradientBox& box);
    double boundBesideJumps(const GradientBox& box);
    void useCurvature(GradientBox& box, const IntervalGradient& whole, BoxFinding& finding);
    void useFiner(const GradientBox& box, const glm::dvec3& p, const IntervalGradient& at,
                  BoxFinding& finding, std::array<SlopeRange, 3>& growth);
    void useCases(const GradientBox& box, BoxFinding& finding);
    std::array<SlopeRange, 3> usePieces(const GradientBox& box, BoxFinding& finding, std::size_t choices);
    std::array<SlopeRange, 3> tryPieces(const GradientBox& box, BoxFinding& finding, std::size_t choices);
    void useFold(const GradientBox& box, const IntervalGradientEvaluator::Fold& fold, BoxFinding& finding);
    void useMonotony(GradientBox& box, const std::array<SlopeRange, 3>& growth, BoxFinding& finding) const;
    static double curvatureBound(const GradientDomain& domain, const GradientBox& box, const glm::dvec3& p,
                                 const IntervalGradient& piece, const IntervalGradient& at,
                                 std::array<SlopeRange, 3>& growth, std::span<const Margin> margins = {});
    glm::dvec3 middleOf(const GradientBox& box) const;
    Interval realValueAt(const glm::dvec3& point);
    std::optional<glm::dvec3> jumpBetween(const glm::dvec3& a, const glm::dvec3& b,
                                          const std::array<SlopeRange, 3>& slope);
    bool isJump(const glm::dvec3& place, const glm::dvec3& direction);

    const GradientDomain& domain_;
    const LeftOutCells& leftOut_;
    IntervalGradientEvaluator intervals_;
    GradientEvaluator gradients_;
    PointEvaluator values_;
    BoxQuestion question_;
    SteepPlace steepest_;
    std::uint64_t stoppedEvaluations_ = 0;
    unsigned casesTried_ = 0, casesPaid_ = 0;
    unsigned middleTried_ = 0, middlePaid_ = 0;
    std::optional<std::size_t> finerClass_;
    bool finerPaid_ = false;
};

}  // namespace isoscope
