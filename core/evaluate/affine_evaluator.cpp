// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/evaluate/affine_evaluator.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/evaluate/affine_case_kernel.h"
#include "core/evaluate/affine_kernel.h"
#include "core/evaluate/algebra/affine_choices.h"
#include "core/evaluate/algebra/affine_crackle.h"
#include "core/evaluate/prepared_function.h"
#include "core/evaluate/ray_piece_forms.h"
#include "core/numeric/interval.h"

namespace isoscope {

namespace {

constexpr std::size_t components = 3;

bool hasCertainBounds(const Tape& tape) {
    for (const Instruction& instruction : tape.instructions())
        if (instruction.operation == Operation::crackle && !hasCrackleBounds(tape.crackle(instruction.index)))
            return false;
    return std::all_of(tape.loops().begin(), tape.loops().end(),
                       [](const TapeLoop& loop) { return hasCertainBounds(*loop.body); });
}

/// Loops have no cases.
bool hasJumps(std::span<const Instruction> instructions) {
    return std::any_of(instructions.begin(), instructions.end(),
                       [](const Instruction& instruction) { return hasSides(instruction.operation); });
}

/// Whether a coordinate is the same all along one of the pieces, and so may be a whole number.
bool mayBeWhole(const PieceColumns& pieces, std::size_t count) {
    return std::any_of(pieces.direction.begin(), pieces.direction.end(), [&](const double* along) {
        return std::find(along, along + count, 0.0) != along + count;
    });
}

AffineForm uniformForm(double value) {
    const double error = std::isnan(value) ? -Interval::infinite : std::isinf(value) ? Interval::infinite : 0;
    return {value, 0, error};
}

}  // namespace

AffineEvaluator::AffineEvaluator(std::shared_ptr<const PreparedFunction> function)
    : AffineEvaluator(function, function->global()) {}

AffineEvaluator::AffineEvaluator(std::shared_ptr<const PreparedFunction> function,
                                 std::shared_ptr<const GlobalSimplification> global)
    : function_(std::move(function)),
      global_(std::move(global)),
      tape_(function_->tape().get()),
      workspace_(*tape_, function_->uniforms(), components, &global_->domains()),
      programs_(function_),
      certain_(hasCertainBounds(*tape_)) {
    lookAtTape();
}

void AffineEvaluator::lookAtTape() {
    canJump_ = hasJumps(decided() != nullptr ? decided()->instructions : tape_->instructions());
    hasApproximations_ = global_->approximations().size() > 1;
}

void AffineEvaluator::keepValues() {
    std::shared_ptr<const GlobalSimplification> plain = function_->global();
    if (global_ == plain) return;
    // The workspace refers to the domains, which are those of the tape for any threshold, of what it has now.
    kept_ = std::exchange(global_, std::move(plain));
    lookAtTape();
}

AffineEvaluator::AffineEvaluator(std::shared_ptr<const Tape> tape, std::span<const double> parameters)
    : AffineEvaluator(PreparedFunction::of(std::move(tape), parameters)) {}

void RayPieces::copyLane(std::size_t from, std::size_t to) {
    for (std::size_t k = 0; k < 3; ++k) {
        origin[k][to] = origin[k][from];
        direction[k][to] = direction[k][from];
    }
    start[to] = start[from];
    length[to] = length[from];
}

void RayPieces::swapLanes(std::size_t a, std::size_t b) {
    for (std::size_t k = 0; k < 3; ++k) {
        std::swap(origin[k][a], origin[k][b]);
        std::swap(direction[k][a], direction[k][b]);
    }
    std::swap(start[a], start[b]);
    std::swap(length[a], length[b]);
}

void AffineEvaluator::evaluate(const RayPieces& pieces, std::span<AffineForm> forms, std::size_t result) {
    const AffineLanes lanes = evaluate(pieces, forms.size(), result);
    for (std::size_t i = 0; i < forms.size(); ++i)
        forms[i] = {lanes.center[i], lanes.slope[i], lanes.error[i]};
}

AffineLanes AffineEvaluator::evaluate(const RayPieces& pieces, std::size_t count, std::size_t result,
                                      const RaySpread* spread) {
    if (result == 0) return evaluate(pieces.columns(), count, 0, spread);
    placeArguments(pieces.columns(), count, spread);
    runAffineTape(workspace_, count);
    evaluations_ += count;
    return lanesOf(tape_->results()[result]);
}

AffineLanes AffineEvaluator::evaluate(const PieceColumns& pieces, std::size_t count, double tolerance,
                                      const RaySpread* spread) {
    evaluations_ += count;
    const std::span<const TapeApproximation> approximations = global_->approximations();
    if (approximations.empty()) {
        placeArguments(pieces, count, spread);
        runAffineTape(workspace_, count);
        return lanesOf(tape_->results()[0]);
    }
    std::size_t coarsest = approximations.size() - 1;
    while (coarsest > 0 && !(approximations[coarsest].error <= tolerance)) --coarsest;
    return runApproximation(coarsest, pieces, count, spread);
}

AffineLanes AffineEvaluator::runApproximation(std::size_t number, const PieceColumns& pieces,
                                              std::size_t count, const RaySpread* spread) {
    const TapeApproximation& approximation = global_->approximations()[number];
    if (const StepProgram* program = programs_.find(workspace_, *global_, number, count)) {
        runAffineProgram(workspace_, *program, pieces, spread, count);
    } else {
        placeArguments(pieces, count, spread);
        runAffineInstructions(workspace_, approximation.tape->instructions, count);
    }
    // Returned as it is made: a copy would wait until its parts are in memory.
    if (approximation.error == 0) return lanesOf(approximation.tape->result);
    const AffineLanes forms = lanesOf(approximation.tape->result);
    widenAffineForms(forms, approximation.offset, approximation.error, count, ownForms_[0].data(),
                     ownForms_[2].data());
    return {ownForms_[0].data(), forms.slope, ownForms_[2].data()};
}

AffineLanes AffineEvaluator::evaluate(const RayPieces& pieces, std::size_t count,
                                      const SimplifiedTape& simplifiedTape) {
    return evaluate(pieces.columns(), count, simplifiedTape);
}

AffineLanes AffineEvaluator::evaluate(const PieceColumns& pieces, std::size_t count,
                                      const SimplifiedTape& simplifiedTape) {
    placeArguments(pieces, count, nullptr);
    runAffineInstructions(workspace_, simplifiedTape.instructions, count);
    evaluations_ += count;
    return lanesOf(simplifiedTape.result);
}

AffineLanes AffineEvaluator::evaluateCases(const RayPieces& pieces, std::size_t count, CaseLanes& cases) {
    placeArguments(pieces.columns(), count, nullptr);
    evaluations_ += count;
    const SimplifiedTape* const decided = this->decided();
    const std::span<const Instruction> instructions =
        decided != nullptr ? decided->instructions : tape_->instructions();
    if (cases.jumpOf.empty()) prepareCases(*tape_, instructions, cases);
    const bool whole = mayBeWhole(pieces.columns(), count);
    const StepProgram* const program = whole ? nullptr : caseProgram(count);
    if (program == nullptr || !runAffineCases(workspace_, *program, cases, count))
        runAffineCases(workspace_, instructions, cases, count, whole);
    return lanesOf(decided != nullptr ? decided->result : tape_->results()[0]);
}

AffineLanes AffineEvaluator::evaluateSides(const PieceColumns& pieces, std::size_t count, SideLanes& sides) {
    placeArguments(pieces, count, nullptr);
    evaluations_ += count;
    const SimplifiedTape* const decided = this->decided();
    const std::span<const Instruction> instructions =
        decided != nullptr ? decided->instructions : tape_->instructions();
    if (sides.jumpOf.empty()) {
        sides.jumpOf = numberJumps(instructions);
        sides.isWhole = wholeNumbersByNumber(*tape_, instructions);
    }
    const bool whole = mayBeWhole(pieces, count);
    const StepProgram* const program = whole ? nullptr : caseProgram(count);
    if (program == nullptr || !runAffineSides(workspace_, *program, sides, count))
        runAffineSides(workspace_, instructions, sides, count, whole);
    return lanesOf(decided != nullptr ? decided->result : tape_->results()[0]);
}

/// The tape without what is decided all over the domain; null where that is the whole.
const SimplifiedTape* AffineEvaluator::decided() const {
    const std::span<const TapeApproximation> approximations = global_->approximations();
    return approximations.empty() ? nullptr : approximations[0].tape.get();
}

const StepProgram* AffineEvaluator::caseProgram(std::size_t count) {
    if (count < TapePrograms::fewestLanes) return nullptr;
    if (!caseProgram_) {
        constexpr StepNumberKind kind = StepNumberKind::byCases;
        caseProgram_.emplace(workspace_,
                             decided() == nullptr ? function_->code(kind) : global_->code(0, kind));
    }
    return &*caseProgram_;
}

AffineLanes AffineEvaluator::evaluateChoices(const RayPieces& pieces, std::size_t count,
                                             const RaySpread* spread, std::vector<LaneChoices>& choices,
                                             const SimplifiedTape* simplifiedTape, const SignStakes* signs) {
    placeArguments(pieces.columns(), count, spread);
    evaluations_ += count;
    choices.clear();
    const std::span<const Instruction> instructions =
        simplifiedTape != nullptr ? simplifiedTape->instructions : tape_->instructions();
    std::size_t begun = 0;
    for (std::size_t i = 0; i < instructions.size(); ++i) {
        if (!isChoice(instructions[i].operation)) continue;
        // The operands are in their slots only until later instructions use them anew.
        runAffineInstructions(workspace_, instructions.subspan(begun, i - begun), count);
        begun = i;
        choices.push_back(
            decide(instructions[i], count, signs != nullptr ? signs->of(choices.size()) : nullptr));
    }
    runAffineInstructions(workspace_, instructions.subspan(begun), count);
    return lanesOf(simplifiedTape != nullptr ? simplifiedTape->result : tape_->results()[0]);
}

AffineLanes AffineEvaluator::lanesOf(Slot slot) {
    if (workspace_.isUniform(slot)) {
        const AffineForm form = uniformForm(workspace_.uniform(slot));
        ownForms_[0].fill(form.a);
        ownForms_[1].fill(form.b);
        ownForms_[2].fill(form.e);
        return {ownForms_[0].data(), ownForms_[1].data(), ownForms_[2].data()};
    }
    const double* lanes = workspace_.address(slot);
    return {lanes, lanes + batchLanes, lanes + 2 * batchLanes};
}

LaneChoices AffineEvaluator::decide(const Instruction& instruction, std::size_t count,
                                    const SignLevel* level) const {
    const bool twoSided =
        instruction.operation == Operation::minimum || instruction.operation == Operation::maximum;
    const auto operand = [&](std::size_t k) {
        const Slot slot = instruction.operands[k];
        if (workspace_.isUniform(slot)) return AffineOperand{nullptr, uniformForm(workspace_.uniform(slot))};
        return AffineOperand{workspace_.address(slot), {}};
    };
    // abs and select compare with 0.
    const AffineOperand second = twoSided ? operand(1) : AffineOperand{};
    const bool takesLower =
        instruction.operation != Operation::maximum && instruction.operation != Operation::absolute;
    LaneChoices choices =
        decideAffineChoices(operand(0), second, takesLower, twoSided ? level : nullptr, count);
    if (level == nullptr || !isSelect(instruction.operation)) return choices;
    // Where all operands that may be taken are on one side, the sign is the same whichever is.
    std::uint64_t above = ~std::uint64_t(0), below = above;
    for (std::size_t k = 1; k < instruction.operandCount; ++k) {
        const LanesBeyond beyond = lanesBeyond(operand(k), *level, count);
        above &= beyond.above, below &= beyond.below;
    }
    const std::uint64_t alike = above | below;
    const bool takesLast = cheapestCase(*tape_, instruction) == Choice::second;
    choices.first = takesLast ? choices.first & ~alike : choices.first | alike;
    choices.second = takesLast ? choices.second | alike : choices.second & ~alike;
    return choices;
}

void AffineEvaluator::placeArguments(const PieceColumns& pieces, std::size_t count, const RaySpread* spread) {
    const auto arguments = static_cast<std::size_t>(std::min(3, tape_->argumentCount()));
    std::array<double*, 3> forms{};
    for (std::size_t k = 0; k < arguments; ++k) forms[k] = workspace_.slot(static_cast<Slot>(k));
    writeRayPieceForms(pieces, spread, count, std::span(forms).first(arguments));
}

}  // namespace isoscope
