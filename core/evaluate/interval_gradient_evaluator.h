// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <new>
#include <numeric>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "core/evaluate/algebra/interval_gradient.h"
#include "core/evaluate/algebra/interval_gradient_rules.h"
#include "core/evaluate/tape/linked_choices.h"
#include "core/evaluate/tape/tape.h"
#include "core/evaluate/tape/uniform_values.h"
#include "core/evaluate/tape/whole_powers.h"

namespace isoscope {

class PreparedFunction;
class UnivariateParts;

/// Encloses a tape's values, gradients and second derivatives in its first three arguments over a box:
/// forward differentiation with outward rounding. What is proven is stated at IntervalGradient, for the
/// function in real arithmetic with constants and parameter-only parts as rounded doubles; noise by the
/// bounds of core/numeric/noise_bounds.h. A box of no extent gives the gradient at a point, with its rounding
/// errors.
///
/// Where no bound exists the answer says so by its hazard; nothing is ever NaN. Loops whose number of steps
/// changes within the box, and loops of more than `stepLimit` steps, are `unknown`. A stop (LoopStop) ends a
/// call within milliseconds; what it has not come to is `unknown`, too. One object per thread.
class IntervalGradientEvaluator {
  public:
    static constexpr double stepLimit = 10'000;

    /// For a tape with these uniform values, which are needed by the constructor alone.
    IntervalGradientEvaluator(std::shared_ptr<const Tape> tape, const UniformValues& uniforms);
    explicit IntervalGradientEvaluator(const PreparedFunction& function);
    /// The uniform part is computed for this evaluator alone.
    IntervalGradientEvaluator(std::shared_ptr<const Tape> tape, std::span<const double> parameters);
    IntervalGradientEvaluator(IntervalGradientEvaluator&& other) noexcept;
    ~IntervalGradientEvaluator();

    /// Result `result` over the box of the first three arguments. Further arguments are 0. The reference is
    /// valid until the next call.
    const IntervalGradient& evaluate(std::span<const Interval, 3> box, std::size_t result = 0);

    /// What result 0 depends on in a box and all boxes in it, without choices that are decided there: what
    /// Duff, "Interval arithmetic and recursive subdivision for implicit functions and constructive solid
    /// geometry" (1992), leaves of a tape.
    struct Excerpt {
        /// Where a value comes from: an entry, or `fixed` and the slot of an argument or constant.
        static constexpr std::uint32_t fixed = 1u << 31;
        /// An instruction with what it works on; of a whole power its base alone.
        struct Entry {
            std::uint32_t instruction = 0;
            std::array<std::uint32_t, 4> operands{};
            std::uint8_t operandCount = 0;
            /// Not open where a magnitude is minus its operand.
            gradient_rules::ChosenSide side = gradient_rules::ChosenSide::open;
        };
        std::vector<Entry> entries;  ///< in their order
        std::uint32_t result = fixed;
    };
    /// That of the box of the last evaluate(), which was by the excerpt `within`; that one where it is hardly
    /// shorter. Null for all of the function, of those with loops always.
    std::shared_ptr<const Excerpt> excerpt(const std::shared_ptr<const Excerpt>& within) const;
    /// Result 0 over a box within that of the excerpt, which is one of this evaluator, or null. What is asked
    /// of the last evaluate(), openChoices() and so on, is not to be asked of this one, but for excerpt().
    const IntervalGradient& evaluate(std::span<const Interval, 3> box,
                                     const std::shared_ptr<const Excerpt>& excerpt);

    /// Result 0 as evaluate() has it, narrowed by UnivariateParts, for more work.
    const IntervalGradient& evaluateFinely(std::span<const Interval, 3> box);
    /// Whether that is another answer.
    bool hasFiner();

    /// Result 0 as evaluate() has it, with the value of each operation narrowed to what its value in the
    /// middle of the box and its slopes allow, for twice the work: y/sqrt(x*x+y*y) stays below 1 beside its
    /// axis.
    const IntervalGradient& evaluateAboutMiddle(std::span<const Interval, 3> box);

    /// Result 0 at a point, without second derivatives.
    const IntervalGradient& evaluateSlopes(std::span<const Interval, 3> point);

    /// The same at a point of the box of the last evaluate(), with the choices left open that were open in
    /// that box: what all pieces are at the point.
    const IntervalGradient& evaluatePieces(std::span<const Interval, 3> point);

    /// How many choices of the last evaluate() were open, and so are in the hands of evaluatePiece(). Those
    /// within loops do not count, and of those that the sign of one difference decides the first alone.
    std::size_t openChoices() const;
    /// Result 0 over a box with the k-th of those choices taken as bit k of `sides` says, everywhere: 0 for
    /// the first operand (the operand of abs, the negative case of select), 1 for the second (minus it, the
    /// other case). In the box of that evaluate(), or a part of it, the function is one of these at each
    /// place.
    const IntervalGradient& evaluatePiece(std::span<const Interval, 3> box, unsigned sides);
    /// The same in those places alone where the function may be that piece: |u| to a power is known, though u
    /// to that power has no value where u is below 0. Without second derivatives.
    const IntervalGradient& evaluatePossiblePiece(std::span<const Interval, 3> box, unsigned sides);
    /// Of the last evaluatePiece(): by how much each side was taken rather than the other, choice by choice.
    /// Where one of these is below 0 the function is another piece. Unbounded for a choice of what may be
    /// undefined.
    std::span<const IntervalGradient> margins() const { return margins_; }

    /// Result 0 over a box that may hold jumps, on one side of each: the k-th angle, whole number, comparison
    /// or select that jumps once in the box has the values at one side of its jump where bit k of `sides` is
    /// 0, at the other where it is 1. At each place of the box where nothing jumps the function is one of
    /// these, for the sides that belong to the place.
    const IntervalGradient& evaluateBesideJumps(std::span<const Interval, 3> box, unsigned sides);
    /// How many jumps the last evaluateBesideJumps() met; which ones depends on the sides of those before.
    std::size_t jumpsMet() const { return jumpsMet_; }

    /// An operand through which alone the function depends on two or three coordinates, such as the distance
    /// from an axis, as it is over the box of the last evaluate(). Everything else depends on the others.
    struct Fold {
        Interval value;
        double steepness = 0;  ///< at least the length of its gradient
        int axis = 0;          ///< the first of its coordinates
    };
    /// Null where the function has none.
    const Fold* fold() const { return fold_ ? &lastFold_ : nullptr; }
    /// Result 0 as a function of w and the other coordinates, where the operand is w times the steepness of
    /// `fold` and takes the values of `fold`; w stands in for its coordinate `axis`. Since the gradient of
    /// the operand is no longer than that and perpendicular to the other axes, no gradient of the function is
    /// longer than those of this one.
    const IntervalGradient& evaluateFolded(std::span<const Interval, 3> box, const Fold& fold);

    /// Whether the last evaluate() had a distance, or another root, without second derivatives on which the
    /// function depends in more than one way: near the centres of the balls of a smooth minimum.
    bool hasBlurredRoots() const { return blurred_; }
    /// At least the length of every gradient of result 0 in the box: that of the function of the coordinates
    /// and of its roots, r and s, as independent arguments, and |df/dr| times the steepness of r, and so on.
    /// What the roots add up to is right where their directions are not known. Infinite where nothing is
    /// known so.
    double steepnessByRoots(std::span<const Interval, 3> box);

    /// Boxes evaluated so far; one of evaluateFinely() counts for as many as it costs.
    std::uint64_t evaluations() const { return evaluations_; }

  private:
    /// What is known by slot. A result is made in a free place, for it may be made of what its slot holds;
    /// that becomes the free place then. Copies would take as long as many an operation.
    class Slots {
      public:
        explicit Slots(std::size_t count) : values_(count + 1), places_(count), free_(count) {
            std::iota(places_.begin(), places_.end(), std::size_t(0));
        }
        std::size_t size() const { return places_.size(); }
        IntervalGradient& operator[](std::size_t slot) { return values_[places_[slot]]; }
        const IntervalGradient& operator[](std::size_t slot) const { return values_[places_[slot]]; }
        /// The result of `maker` becomes that of the slot.
        template <class Maker>
        IntervalGradient& make(std::size_t slot, Maker maker) {
            auto* made = ::new (static_cast<void*>(&values_[free_])) IntervalGradient(maker());
            std::swap(free_, places_[slot]);
            return *made;
        }

      private:
        std::vector<IntervalGradient> values_;
        std::vector<std::size_t> places_;
        std::size_t free_;
    };

    bool run(double loopAllowance);
    void begin(std::span<const Interval, 3> box);
    const IntervalGradient& finish(IntervalGradient& answer, bool ended) const;
    bool stopsNow();
    Excerpt everything() const;
    Excerpt shorten(const Excerpt& within) const;
    IntervalGradient resultOf(const Instruction& instruction, std::size_t index, double loopAllowance);
    IntervalGradient rootInstead(std::size_t root) const;
    void noteRoot(std::size_t root, const IntervalGradient& found);
    IntervalGradient execute(const Instruction& instruction, std::size_t index, double loopAllowance);
    IntervalGradient apply(const Instruction& instruction, std::size_t index,
                           std::span<const IntervalGradient* const> operands, const IntervalGradient* base);
    bool isLed(std::size_t index) const;
    bool nextSide(std::size_t index);
    IntervalGradient sideOf(Operation operation, std::span<const IntervalGradient* const> operands,
                            bool second) const;
    IntervalGradient besideJump(const Instruction& instruction, std::size_t index,
                                const IntervalGradient& whole);
    IntervalGradient executeTriangle(const IntervalGradient& u, std::size_t index);
    void useMiddle(std::size_t index, IntervalGradient& target);
    const IntervalGradient& baseOf(const WholePower& power) const;
    bool joins(std::size_t index);
    std::vector<double> uniforms() const;
    IntervalGradient runLoop(const Instruction& instruction, double loopAllowance);

    std::shared_ptr<const Tape> tape_;
    Slots slots_;
    std::vector<std::unique_ptr<IntervalGradientEvaluator>> loops_;
    std::vector<IntervalGradient> margins_;
    std::vector<bool> open_;           ///< by instruction: the choices that the last box left open
    std::vector<LinkedChoice> links_;  ///< by instruction
    std::vector<bool> taken_;          ///< by instruction: whether it is the second side of an open choice
    std::vector<bool> wantedRoots_;    ///< by instruction: whether IntervalGradient::root is of use
    std::vector<gradient_rules::ChosenSide> chosen_;  ///< by instruction: what the last box decided
    std::vector<double> corners_;                     ///< of those among them that are triangle waves
    std::vector<IntervalGradient> short_;             ///< of the entries of an excerpt
    std::vector<double> cuts_;                        ///< by instruction: roundingCuts()
    std::vector<WholePower> powers_;                  ///< by instruction: those whose roots are of use
    std::vector<bool> isBase_;                        ///< by instruction: whether it is the base of one
    std::vector<IntervalGradient> bases_;             ///< by instruction: the last ones
    std::vector<bool> joined_;                        ///< by instruction; none until it is asked for
    bool bends_ = true;                               ///< whether second derivatives are asked for
    bool keepsOpen_ = false;                          ///< whether these stay as they are
    bool takesSides_ = false;                         ///< whether they are taken as `sides_` says
    std::unique_ptr<UnivariateParts> parts_;          ///< null until they are asked for
    bool finely_ = false;                             ///< whether they narrow what is evaluated
    std::vector<Interval> middles_;                   ///< by instruction: its value in the middle of the box
    std::array<SlopeRange, 3> ways_{};                ///< from there to the sides of the box
    enum class Middle : std::uint8_t { none, noted, used };
    Middle middle_ = Middle::none;     ///< what becomes of `middles_`
    std::optional<std::size_t> fold_;  ///< its instruction
    Fold lastFold_;
    bool folds_ = false;  ///< whether `lastFold_` takes its place
    /// What the last evaluate() found of one of sharedRoots().
    struct Root {
        Interval value;
        double steepness = 0;  ///< infinite where the root has no bound
    };
    std::vector<Root> roots_;
    std::vector<std::uint32_t> rootAt_;  ///< by instruction: which one it is; their number for none
    bool blurred_ = false;               ///< whether one of them is not smooth
    /// Which of them are the coordinates, from this one on, while all others are constants; those are when it
    /// is their number.
    std::optional<std::size_t> firstRoot_;
    unsigned sides_ = 0;          ///< of the open choices, or jumps, that are still to come
    bool possibleAlone_ = false;  ///< whether those leave out values that they cannot have
    bool takesJumps_ = false;     ///< whether they are those of jumps
    std::size_t jumpsMet_ = 0;
    unsigned steps_ = 0;  ///< instructions so far, to look for a stop now and then
    std::uint64_t evaluations_ = 0;
};

/// The operation for operands given over a box; loops, constants, variables and parameters are not allowed.
IntervalGradient evaluateOperation(Operation operation, std::span<const IntervalGradient* const> operands,
                                   const CrackleSettings* crackle = nullptr);

}  // namespace isoscope
