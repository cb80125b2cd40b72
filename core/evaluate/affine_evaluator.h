// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "core/evaluate/jumps/affine_cases.h"
#include "core/evaluate/jumps/affine_sides.h"
#include "core/evaluate/algebra/affine_form.h"
#include "core/evaluate/steps/tape_programs.h"
#include "core/evaluate/tape/simplified_tape.h"
#include "core/evaluate/tape/tape_workspace.h"

namespace isoscope {

class GlobalSimplification;
class PreparedFunction;

/// Pieces of rays that stand in columns of the caller: entry i of each is lane i, as in RayPieces. Whole
/// vectors are read, up to batchLanes entries.
struct PieceColumns {
    std::array<const double*, 3> origin{};
    std::array<const double*, 3> direction{};
    const double* start = nullptr;
    const double* length = nullptr;
};

/// Pieces of rays: lane i is origin + t direction for t in [start, start + length]. Only the first `count`
/// lanes count.
struct RayPieces {
    std::array<std::array<double, batchLanes>, 3> origin{};
    std::array<std::array<double, batchLanes>, 3> direction{};
    std::array<double, batchLanes> start{};
    std::array<double, batchLanes> length{};

    /// Origin, direction, start and length of one lane into another (below batchLanes), or of two lanes
    /// exchanged.
    void copyLane(std::size_t from, std::size_t to);
    void swapLanes(std::size_t a, std::size_t b);
    /// Pointers into these arrays: valid while the object lives and stays where it is.
    PieceColumns columns() const {
        return {{origin[0].data(), origin[1].data(), origin[2].data()},
                {direction[0].data(), direction[1].data(), direction[2].data()},
                start.data(),
                length.data()};
    }
};

/// How far the rays of a bundle may be from the ray in the same lane of RayPieces, as half widths of boxes:
/// of the origins, and of the directions. Then t must not be negative.
struct RaySpread {
    std::array<std::array<double, batchLanes>, 3> origin{};
    std::array<std::array<double, batchLanes>, 3> direction{};
};

/// Affine forms (AffineForm) side by side: arrays of batchLanes entries.
struct AffineLanes {
    const double* center;
    const double* slope;
    const double* error;
};

/// Encloses a function of x, y, z along pieces of rays: its values lie in a + b s + [-e, e], where s runs
/// from -1 at the start to 1 at the end of the piece. Sound in real arithmetic, with constants and
/// parameter-only parts as rounded doubles; what is looked up has bounds over all of space alone (see
/// hasCrackleBounds). A lane's answer
/// does not depend on the others. One object per thread.
class AffineEvaluator {
  public:
    explicit AffineEvaluator(std::shared_ptr<const PreparedFunction> function);
    /// With what is known over all of space, PreparedFunction::global() or globalFor(): with the latter,
    /// forms are those of a function with the same sign.
    AffineEvaluator(std::shared_ptr<const PreparedFunction> function,
                    std::shared_ptr<const GlobalSimplification> global);
    /// The function is prepared for this evaluator alone.
    AffineEvaluator(std::shared_ptr<const Tape> tape, std::span<const double> parameters);

    /// From now on forms are of the function itself again. Only before the first evaluation.
    void keepValues();

    /// forms[i] for the first forms.size() lanes (at most batchLanes).
    void evaluate(const RayPieces& pieces, std::span<AffineForm> forms, std::size_t result = 0);

    /// The same for the first `count` lanes, without a copy: valid until the next evaluation. With `spread`
    /// the forms hold for every ray of each lane's bundle.
    AffineLanes evaluate(const RayPieces& pieces, std::size_t count, std::size_t result = 0,
                         const RaySpread* spread = nullptr);

    /// The first result where errors may be larger by `tolerance` than they need be: a coarse approximation
    /// of the function is cheaper.
    AffineLanes evaluate(const PieceColumns& pieces, std::size_t count, double tolerance,
                         const RaySpread* spread = nullptr);
    /// Whether a tolerance makes a difference.
    bool hasApproximations() const { return hasApproximations_; }

    /// The same with a shortened tape, whose choices must be right all over the pieces.
    AffineLanes evaluate(const RayPieces& pieces, std::size_t count, const SimplifiedTape& simplifiedTape);
    AffineLanes evaluate(const PieceColumns& pieces, std::size_t count, const SimplifiedTape& simplifiedTape);

    /// As evaluate(), and notes which choices are decided: choices[k] for the k-th choosing instruction
    /// (TapeSimplifier) of the tape, or of `simplifiedTape`. Where only the sign of the result counts, what
    /// cannot change it counts as not chosen.
    AffineLanes evaluateChoices(const RayPieces& pieces, std::size_t count, const RaySpread* spread,
                                std::vector<LaneChoices>& choices,
                                const SimplifiedTape* simplifiedTape = nullptr,
                                const SignStakes* signs = nullptr);

    /// As evaluate(), on the sides of jumps that `cases` tells, and notes where the function may jump
    /// besides. Empty cases are prepared; they must then always be used with this evaluator.
    AffineLanes evaluateCases(const RayPieces& pieces, std::size_t count, CaseLanes& cases);
    /// As evaluate(), on the sides of jumps that hold at one place of each piece. `sides` must always be used
    /// with this evaluator.
    AffineLanes evaluateSides(const PieceColumns& pieces, std::size_t count, SideLanes& sides);
    /// Whether there is anything to tell.
    bool canJump() const { return canJump_; }

    /// Evaluations of a piece so far.
    std::uint64_t evaluations() const { return evaluations_; }

    /// False when the function holds an operation without bounds for parts of space (hasCrackleBounds).
    bool certain() const { return certain_; }

  private:
    void lookAtTape();
    void placeArguments(const PieceColumns& pieces, std::size_t count, const RaySpread* spread);

    const SimplifiedTape* decided() const;
    /// The program for forms by cases; none where instructions do as well.
    const StepProgram* caseProgram(std::size_t count);
    AffineLanes runApproximation(std::size_t number, const PieceColumns& pieces, std::size_t count,
                                 const RaySpread* spread);
    AffineLanes lanesOf(Slot slot);
    LaneChoices decide(const Instruction& instruction, std::size_t count, const SignLevel* level) const;

    std::shared_ptr<const PreparedFunction> function_;
    std::shared_ptr<const GlobalSimplification> global_;
    std::shared_ptr<const GlobalSimplification> kept_;  ///< whose domains the workspace has
    const Tape* tape_;
    TapeWorkspace workspace_;
    TapePrograms programs_;
    std::optional<StepProgram> caseProgram_;
    alignas(64) std::array<std::array<double, batchLanes>, 3> ownForms_;  ///< for results that are no slots
    bool certain_ = true;
    bool canJump_ = false;
    bool hasApproximations_ = false;
    std::uint64_t evaluations_ = 0;
};

}  // namespace isoscope
