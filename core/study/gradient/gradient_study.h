// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <deque>
#include <memory>
#include <optional>
#include <queue>
#include <span>
#include <stop_token>
#include <vector>

#include "core/render/progressive/worker_pool.h"
#include "core/shapes/isosurface/isosurface.h"
#include "core/study/gradient/box_examiner.h"
#include "core/study/gradient/gradient_bracket.h"
#include "core/study/gradient/gradient_domain.h"
#include "core/study/gradient/left_out_cells.h"
#include "core/study/arguments/ridge_function.h"

namespace isoscope {

/// When a GradientStudy ends: by whichever limit it meets first.
struct GradientStudySettings {
    double relativeWidth = 0.01;  ///< stop when (upper - lower) / lower is at most this
    std::uint64_t boxLimit =
        1'000'000;  ///< stop after so many boxes; also bounds the memory (about 100 bytes each)
    /// That look at boxes, 0 for all cores; fewer where their evaluators would take much memory. No answer
    /// depends on their number.
    int threads = 1;
};

/// Proves a bracket of the largest |grad f| over the container of an isosurface by branch and bound over
/// boxes, steepest first. Bounds of a box (BoxExaminer) are the smaller of: its slopes by interval
/// differentiation; the gradient at a point p of it plus second derivatives times distance; and |grad f(p)|^2
/// plus the change of the square, which is accurate to second order (with the wall of a sphere taken into
/// account). Where few choices (min, max, abs) are open, the bound is the largest of those of all cases.
/// Boxes in which the length certainly grows towards a neighbour are dropped, those in which it grows towards
/// the container's wall shrink to it.
///
/// Infinite gradients are looked for first, and found by halving towards them: a jump is proven by two values
/// that differ by more than all slopes between them allow; other singularities are told from mere ignorance
/// by slopes that keep growing as the place is approached. Once one is found, what is left of the boxes goes
/// to the bound beside such places (GradientBeside).
///
/// Where bends decide and are known badly, boxes are enclosed finely (UnivariateParts) as long as that often
/// is the end of them.
///
/// A function that is the same along lines or planes is searched across them, as a RidgeFunction.
///
/// What is bounded is the function as IntervalGradientEvaluator understands it. The study shares its boxes
/// out to threads of its own; it is not to be called by several at once.
class GradientStudy {
  public:
    GradientStudy(std::shared_ptr<const Tape> tape, std::span<const double> parameters,
                  const Container& container, GradientStudySettings settings = {});
    GradientStudy(const std::shared_ptr<const PreparedFunction>& function, const Container& container,
                  GradientStudySettings settings = {});

    /// Works on about `boxes` further boxes; a stop ends it with the box at hand, and a LoopStop of this
    /// thread within milliseconds. Nothing is lost: the next call goes on. Returns whether there is more to
    /// do.
    bool step(std::uint64_t boxes, std::stop_token stop = {});
    /// Works to the end, or to a stop, which is the end then; it comes within milliseconds.
    const GradientBracket& run(std::stop_token stop = {});

    /// Narrows with every step and never widens.
    const GradientBracket& bracket() const {
        if (ridge_) return ridge_->bracket;
        return beside_ ? whole_ : bracket_;
    }
    /// The steepest gradient met at points, proven or not: what sampling alone would say.
    double sampled() const { return sampled_; }

  private:
    /// Whether something is worth its evaluations, by how often it has lately been.
    class Trial {
      public:
        /// Whether it is to be tried again: always while one in eight is a success, else one time in 16, or
        /// in 128 where a success is rare.
        bool tries() { return share_ >= 0.125 || ++skipped_ % (share_ >= 0.01 ? 16 : 128) == 0; }
        void note(bool success) { share_ += ((success ? 1 : 0) - share_) / 32; }

      private:
        double share_ = 0.5;
        unsigned skipped_ = 0;
    };
    struct Region {
        GradientBox box;
        double bound;
        int axis;  ///< to halve along
        GradientHazard hazard;
        int nextAxis = -1;   ///< to halve the halves along, where known
        bool isNew = false;  ///< a stop came before it was looked at: it is, before it is halved

        /// The steepest first.
        bool operator<(const Region& other) const { return bound < other.bound; }
    };
    /// A part of a region that is to be looked at.
    struct Part {
        GradientBox box;
        double bound;  ///< of the region, as `hazard`
        GradientHazard hazard;
        BoxQuestion question;
        double* done;  ///< hears whether it is done with; null for none
    };

    /// What is searched in place of the function, and what this says of it: all but this works with the
    /// arguments of a RidgeFunction for coordinates.
    struct Ridge {
        RidgeFunction searched;
        GradientDomain container;
        LeftOutCells nothing;
        BoxExaminer examiner;  ///< of the function as it is, for slopes at places
        SteepPlace steepest, steepestBeside;
        GradientBracket bracket;  ///< of the function

        Ridge(RidgeFunction found, const std::shared_ptr<const PreparedFunction>& function,
              const Container& around);
        /// Takes over what is known by now. A slope counts where it is proven of the function as it is.
        void tell(const GradientBracket& found);
    };

    void work(const std::stop_token& stop);
    bool isWorthHalving(const Region& region);
    void begin();
    void beginBeside();
    void leaveOut(const GradientBox& box, GradientHazard hazard);
    void publish();
    bool samplePoints();
    void climb(glm::dvec3 from);

    BoxExaminer& examiner() { return *examiners_.front(); }
    BoxQuestion question();
    std::uint64_t evaluations() const;
    double steepnessAt(const glm::dvec3& point) { return examiner().steepnessAt(point); }
    void offerPoint(const glm::dvec3& point);
    void accept(const SteepPlace& found);

    void consider(const GradientBox& box, double bound, GradientHazard hazard);
    bool adopt(const ExaminedBox& answer, GradientHazard hazard);
    static Region regionOf(const GradientBox& box, double bound, const BoxFinding& finding);
    void halve(std::span<const Region> regions, const std::stop_token& stop = {});
    void halve(const Region& region) { halve(std::span(&region, 1)); }
    bool isDivisible(const Region& region);
    void addParts(const Region& region, std::vector<Part>& parts);
    void putBack(const Region& region);

    bool isSingular(const Region& region);
    bool isConfirmed(const glm::dvec3& point, double length, double reach);
    void lookForSingularities();
    double steepestAround(const glm::dvec3& place, double distance);
    bool checkSeam();
    bool diveInto(GradientBox box);
    void divide(const Region& region);

    bool mayJump() const { return stuck_ || queuedJumps_ > 0 || !seams_.empty(); }
    void report();
    void finish(GradientState state);
    void setSingular(GradientHazard kind, const glm::dvec3& place);
    bool isNarrow() const;
    double target() const;  ///< what a bound need not be below
    double leftOutWidth() const;

    std::unique_ptr<Ridge> ridge_;  ///< null for a function searched as it is
    std::shared_ptr<const PreparedFunction> searched_;
    GradientDomain domain_;
    GradientStudySettings settings_;
    LeftOutCells leftOut_;
    WorkerPool workers_;
    std::vector<std::unique_ptr<BoxExaminer>> examiners_;  ///< by thread
    GradientBracket bracket_;  ///< of all, or of what is beside infinite gradients
    GradientBracket whole_;    ///< the answer, while it is worked on what is beside
    std::priority_queue<Region> queue_;
    std::deque<Region>
        boundless_;             ///< without a bound so far; the last ones are being halved towards a place
    std::deque<Region> seams_;  ///< done with, but for a jump that may lie in them
    int seamsLeft_ = 60'000;    ///< how many of them are halved before giving up
    bool stuck_ = false;        ///< whether one is too small to be halved
    int jumpsSeen_ = 0;         ///< halved boxes that may hold one
    int dives_ = 0;             ///< how many boxes were followed down to a point
    double dropped_ = 0;        ///< largest bound of the boxes that are done with
    double sampled_ = 0;
    bool begun_ = false;
    bool beside_ = false;
    bool besideSampled_ = false;
    std::uint64_t besideLimit_ = 0;  ///< of all boxes
    bool unresolved_ = false;
    std::uint64_t boxesByRoots_ = 0;  ///< that boundByRoots() evaluated
    std::uint64_t queuedJumps_ = 0;   ///< regions of the queue that may hold a jump
    int probes_ = 0;
    Trial casesPay_, middlePays_;
    std::array<Trial, distanceClasses> finerPays_;  ///< by how far the bound is from the target
    unsigned quarters_ = 0;
    std::array<double, distanceClasses>
        done_{};  ///< share of halves that are done with, by how far the whole is from it
    std::vector<glm::dvec3> summits_;  ///< where the climbs ended
};

}  // namespace isoscope
