// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/evaluate/interval_gradient_evaluator.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

#include "core/evaluate/algebra/interval_gradient_rules.h"
#include "core/evaluate/interval_evaluator.h"
#include "core/evaluate/prepared_function.h"
#include "core/evaluate/tape/joined_selects.h"
#include "core/evaluate/tape/loop_range.h"
#include "core/evaluate/tape/loop_stop.h"
#include "core/evaluate/tape/rounding_cuts.h"
#include "core/evaluate/tape/shared_roots.h"
#include "core/evaluate/tape/tape_axes.h"
#include "core/evaluate/algebra/univariate_parts.h"

namespace isoscope {

using namespace gradient_rules;

namespace {

bool isLoop(Operation operation) { return operation == Operation::sum || operation == Operation::product; }

bool isTruth(Operation operation) {
    switch (operation) {
        case Operation::equal:
        case Operation::notEqual:
        case Operation::less:
        case Operation::lessEqual:
        case Operation::greater:
        case Operation::greaterEqual:
        case Operation::logicalAnd:
        case Operation::logicalOr: return true;
        default: return false;
    }
}

/// Whether a select has one value for a condition below 0 and one for others, or one above 0 and one for
/// others.
bool hasTwoCases(const Instruction& instruction) {
    const auto& cases = instruction.operands;
    return instruction.operation == Operation::select3 ||
           (instruction.operation == Operation::select4 && (cases[2] == cases[1] || cases[2] == cases[3]));
}

bool usesWraps(Operation operation) {
    switch (operation) {
        case Operation::negate:
        case Operation::sine:
        case Operation::cosine:
        case Operation::cycle:
        case Operation::triangleWave:
        case Operation::add:
        case Operation::subtract:
        case Operation::multiply:
        case Operation::divide:
        case Operation::remainder: return true;
        default: return false;
    }
}

bool isEven(Operation operation) {
    return operation == Operation::absolute || operation == Operation::square ||
           operation == Operation::hyperbolicCosine;
}

Interval valueOf(Operation operation, Operands operands, const CrackleSettings* crackle) {
    std::array<Interval, 4> values;
    for (std::size_t k = 0; k < operands.size(); ++k) values[k] = operands[k]->value;
    return evaluateOperation(operation, std::span(values).first(operands.size()), crackle);
}

IntervalGradient twoOperands(Operation operation, Operands operands) {
    const IntervalGradient& a = *operands[0];
    const IntervalGradient& b = *operands[1];
    switch (operation) {
        case Operation::add: return sum(a, b);
        case Operation::subtract: return sum(a, b.isConstant() ? constant(-b.value) : scaled(b, -1));
        case Operation::multiply: return product(a, b);
        case Operation::divide: return quotient(a, b);
        case Operation::power: return power(a, b);
        case Operation::arcTangent2: return arcTangent2Of(a, b);
        case Operation::remainder: return remainderOf(a, b);
        case Operation::minimum: return minimumOf(a, b);
        case Operation::maximum: return maximumOf(a, b);
        default: return stepped(operands, valueOf(operation, operands, nullptr));
    }
}

IntervalGradient withoutWraps(Operation operation, Operands operands, const CrackleSettings* crackle) {
    switch (operation) {
        case Operation::floor:
        case Operation::ceiling:
        case Operation::truncate: return wholeNumberOf(*operands[0], valueOf(operation, operands, nullptr));
        case Operation::fraction: return fractionOf(*operands[0], valueOf(operation, operands, nullptr));
        case Operation::select3:
        case Operation::select4: return selectOf(operands);
        case Operation::noise:
        case Operation::noiseGradientX:
        case Operation::noiseGradientY:
        case Operation::noiseGradientZ: return noiseOf(operation, operands);
        case Operation::crackle: return crackleOf(*crackle, operands, valueOf(operation, operands, crackle));
        default: break;
    }
    return operands.size() == 1 ? elementary(operation, *operands[0]) : twoOperands(operation, operands);
}

/// Whether the root of each instruction's result may be asked for.
std::vector<bool> wantedRoots(const Tape& tape) {
    std::vector<bool> slots(tape.slotCount()), all(tape.instructions().size());
    for (std::size_t i = all.size(); i-- > 0;) {
        const Instruction& instruction = tape.instructions()[i];
        const bool wanted = all[i] = slots[instruction.target];
        slots[instruction.target] = false;
        switch (instruction.operation) {
            case Operation::squareRoot:
            case Operation::naturalLogarithm:
            case Operation::decimalLogarithm:
            case Operation::power: slots[instruction.operands[0]] = true; break;
            case Operation::divide:
                slots[instruction.operands[1]] = true;
                if (wanted) slots[instruction.operands[0]] = true;
                break;
            case Operation::absolute:
            case Operation::add:
            case Operation::multiply:
            case Operation::square:
                for (std::size_t k = 0; wanted && k < instruction.operandCount; ++k)
                    slots[instruction.operands[k]] = true;
                break;
            case Operation::sum:
            case Operation::product:
                // What becomes of them in the loop is not looked into.
                for (const Slot slot : tape.loop(instruction.index).captured) slots[slot] = true;
                break;
            default: break;
        }
    }
    return all;
}

/// The first root of a tape without loops through which alone two or three coordinates count.
std::optional<std::size_t> foldOf(const Tape& tape) {
    // Looking for one takes the square of this.
    constexpr std::size_t mostInstructions = 1000;
    const auto& instructions = tape.instructions();
    if (!tape.loops().empty() || instructions.size() > mostInstructions) return {};
    const std::vector<std::uint8_t> axes = axesWithout(tape);
    for (std::size_t i = 0; i < instructions.size(); ++i) {
        if (instructions[i].operation != Operation::squareRoot) continue;
        if (std::popcount(axes[i]) > 1 && (axes[i] & axesWithout(tape, {&i, 1}).back()) == 0) return i;
    }
    return {};
}

}  // namespace

IntervalGradient evaluateOperation(Operation operation, Operands operands, const CrackleSettings* crackle) {
    bool wrapped = false;
    for (const IntervalGradient* operand : operands) wrapped = wrapped || operand->wrap != 0;
    if (!wrapped || usesWraps(operation)) return withoutWraps(operation, operands, crackle);
    if (operands.size() == 1)
        return acrossCut(*operands[0], isEven(operation), [&](const IntervalGradient& u) {
            const IntervalGradient* const pointer = &u;
            return withoutWraps(operation, {&pointer, 1}, crackle);
        });
    std::array<IntervalGradient, 4> resolved;
    std::array<const IntervalGradient*, 4> pointers{};
    for (std::size_t k = 0; k < operands.size(); ++k) {
        resolved[k] = resolveWrap(*operands[k]);
        pointers[k] = &resolved[k];
    }
    return withoutWraps(operation, std::span(pointers).first(operands.size()), crackle);
}

IntervalGradientEvaluator::IntervalGradientEvaluator(std::shared_ptr<const Tape> tape,
                                                     const UniformValues& uniforms)
    : tape_(std::move(tape)),
      slots_(tape_->slotCount()),
      open_(tape_->instructions().size()),
      links_(linkedChoices(*tape_)),
      taken_(open_.size()),
      chosen_(open_.size()),
      corners_(open_.size()) {
    for (std::size_t k = 0; k < uniforms.values.size(); ++k)
        slots_[tape_->firstUniform() + k] = constant(Interval::point(uniforms.values[k]));
    for (std::size_t k = 0; k < uniforms.loops.size(); ++k)
        loops_.push_back(
            std::make_unique<IntervalGradientEvaluator>(tape_->loops()[k].body, uniforms.loops[k]));
    fold_ = foldOf(*tape_);
    const std::vector<std::size_t> roots = sharedRoots(*tape_);
    roots_.resize(roots.size());
    rootAt_.assign(open_.size(), static_cast<std::uint32_t>(roots.size()));
    for (std::size_t k = 0; k < roots.size(); ++k) rootAt_[roots[k]] = static_cast<std::uint32_t>(k);
    wantedRoots_ = wantedRoots(*tape_);
    cuts_ = roundingCuts(*tape_, this->uniforms());
    powers_ = wholePowers(*tape_);
    isBase_.resize(powers_.size());
    for (std::size_t i = 0; i < powers_.size(); ++i) {
        if (!wantedRoots_[i]) powers_[i] = {};
        if (powers_[i].exponent == 0 || powers_[i].base < slots_.size()) continue;
        isBase_[powers_[i].base - slots_.size()] = true;
        bases_.resize(powers_.size());
    }
}

IntervalGradientEvaluator::IntervalGradientEvaluator(const PreparedFunction& function)
    : IntervalGradientEvaluator(function.tape(), function.uniforms()) {}

IntervalGradientEvaluator::IntervalGradientEvaluator(std::shared_ptr<const Tape> tape,
                                                     std::span<const double> parameters)
    : IntervalGradientEvaluator(tape, UniformValues(*tape, parameters)) {}

const IntervalGradient& IntervalGradientEvaluator::evaluate(std::span<const Interval, 3> box,
                                                            std::size_t result) {
    begin(box);
    const bool ended = run(LoopRange::topAllowance);
    return finish(slots_[tape_->results()[result]], ended);
}

/// The arguments take their values.
void IntervalGradientEvaluator::begin(std::span<const Interval, 3> box) {
    ++evaluations_;
    const auto argumentCount = static_cast<std::size_t>(tape_->argumentCount());
    const bool isOfRoots = firstRoot_ && *firstRoot_ < roots_.size();
    for (std::size_t k = 0; k < argumentCount; ++k)
        slots_[k] = k >= 3      ? constant(Interval::point(0))
                    : isOfRoots ? constant(box[k])
                                : coordinate(k, box[k]);
    blurred_ = false;
    // What is not smooth has no second derivatives, nor has what is made of it.
    for (std::size_t k = 0; k < std::min<std::size_t>(argumentCount, 3); ++k) slots_[k].smooth = bends_;
}

/// What is known of a result, of which all was computed, or not.
const IntervalGradient& IntervalGradientEvaluator::finish(IntervalGradient& answer, bool ended) const {
    if (!ended) answer = hazardous(Interval::unknown(), 7, GradientHazard::unknown);
    if (answer.wrap != 0) answer = resolveWrap(answer);
    // Choices within loops are not told apart.
    if (answer.pieced && !loops_.empty()) answer.smooth = false;
    return answer;
}

IntervalGradientEvaluator::IntervalGradientEvaluator(IntervalGradientEvaluator&& other) noexcept = default;
IntervalGradientEvaluator::~IntervalGradientEvaluator() = default;

std::vector<double> IntervalGradientEvaluator::uniforms() const {
    std::vector<double> values;
    for (std::uint32_t k = 0; k < tape_->uniformCount(); ++k) {
        const Interval& value = slots_[tape_->firstUniform() + k].value;
        values.push_back(value.empty() ? std::numeric_limits<double>::quiet_NaN() : value.low);
    }
    return values;
}

bool IntervalGradientEvaluator::hasFiner() {
    if (!parts_) parts_ = std::make_unique<UnivariateParts>(*tape_, uniforms());
    return !parts_->empty();
}

const IntervalGradient& IntervalGradientEvaluator::evaluateFinely(std::span<const Interval, 3> box) {
    finely_ = hasFiner();
    evaluations_ += parts_->work();
    const IntervalGradient& answer = evaluate(box);
    finely_ = false;
    return answer;
}

const IntervalGradient& IntervalGradientEvaluator::evaluateAboutMiddle(std::span<const Interval, 3> box) {
    std::array<Interval, 3> middle;
    for (std::size_t k = 0; k < 3; ++k) {
        const double at = std::midpoint(box[k].low, box[k].high);
        middle[k] = Interval::point(at);
        ways_[k] = {lowered(box[k].low - at), raised(box[k].high - at)};
    }
    middles_.resize(tape_->instructions().size());
    middle_ = Middle::noted;
    evaluateSlopes(middle);
    middle_ = Middle::used;
    const IntervalGradient& answer = evaluate(box);
    middle_ = Middle::none;
    return answer;
}

/// What has a slope everywhere in the box differs no more than that from its value in the middle.
void IntervalGradientEvaluator::useMiddle(std::size_t index, IntervalGradient& target) {
    Interval& middle = middles_[index];
    if (middle_ == Middle::noted) {
        middle = target.wrap == 0 ? target.value : Interval::unknown();
        return;
    }
    if (!target.bounded() || target.wrap != 0 || !target.value.isDefined() || !middle.isDefined()) return;
    SlopeRange near = rangeOf(middle);
    for (std::size_t k = 0; k < 3; ++k)
        if (dependsOn(target.axes, k)) near = near + target.slope[k] * ways_[k];
    const double low = std::max(target.value.low, near.low), high = std::min(target.value.high, near.high);
    if (low <= high) target.value = {low, high, false};
}

const IntervalGradient& IntervalGradientEvaluator::evaluateSlopes(std::span<const Interval, 3> point) {
    bends_ = false;
    const IntervalGradient& answer = evaluate(point);
    bends_ = true;
    return answer;
}

const IntervalGradient& IntervalGradientEvaluator::evaluatePieces(std::span<const Interval, 3> point) {
    keepsOpen_ = true;
    const IntervalGradient& answer = evaluateSlopes(point);
    keepsOpen_ = false;
    return answer;
}

std::size_t IntervalGradientEvaluator::openChoices() const {
    std::size_t count = 0;
    for (std::size_t i = 0; i < open_.size(); ++i) count += open_[i] && !isLed(i) ? 1 : 0;
    return count;
}

/// Whether an earlier choice that is open decides this one.
bool IntervalGradientEvaluator::isLed(std::size_t index) const {
    const std::size_t first = links_[index].first;
    return first != LinkedChoice::none && open_[first];
}

/// The side that an open choice takes, as `sides_` says: whether it is the second one.
bool IntervalGradientEvaluator::nextSide(std::size_t index) {
    bool second = false;
    if (isLed(index)) {
        second = taken_[links_[index].first] != links_[index].reversed;
    } else {
        second = (sides_ & 1) != 0;
        sides_ >>= 1;
    }
    taken_[index] = second;
    return second;
}

const IntervalGradient& IntervalGradientEvaluator::evaluatePiece(std::span<const Interval, 3> box,
                                                                 unsigned sides) {
    takesSides_ = true;
    sides_ = sides;
    margins_.clear();
    const IntervalGradient& answer = evaluate(box);
    takesSides_ = false;
    return answer;
}

const IntervalGradient& IntervalGradientEvaluator::evaluatePossiblePiece(std::span<const Interval, 3> box,
                                                                         unsigned sides) {
    possibleAlone_ = true;
    const IntervalGradient& answer = evaluatePiece(box, sides);
    possibleAlone_ = false;
    return answer;
}

IntervalGradient IntervalGradientEvaluator::sideOf(Operation operation,
                                                   std::span<const IntervalGradient* const> operands,
                                                   bool second) const {
    return possibleAlone_ ? possibleSide(operation, operands, second)
                          : takenSide(operation, operands, second);
}

const IntervalGradient& IntervalGradientEvaluator::evaluateBesideJumps(std::span<const Interval, 3> box,
                                                                       unsigned sides) {
    takesJumps_ = true;
    sides_ = sides;
    jumpsMet_ = 0;
    const IntervalGradient& answer = evaluate(box);
    takesJumps_ = false;
    return answer;
}

/// What an instruction with the result `whole` is on one side of its jump, as `sides_` says; `whole` where it
/// has no jump, or more than one.
IntervalGradient IntervalGradientEvaluator::besideJump(const Instruction& instruction, std::size_t index,
                                                       const IntervalGradient& whole) {
    std::array<const IntervalGradient*, 4> operands{};
    for (std::size_t k = 0; k < instruction.operandCount; ++k) operands[k] = &slots_[instruction.operands[k]];
    const Operands all = std::span(operands).first(instruction.operandCount);
    const bool isSelect =
        hasTwoCases(instruction) && isOpenSelect(instruction.operation, all) && !joins(index);
    const bool isOpenTruth = isTruth(instruction.operation) && !whole.value.isPoint();
    if (whole.wrap == 0 && !isSelect && !isOpenTruth) return whole;
    ++jumpsMet_;
    const bool second = (sides_ & 1) != 0;
    sides_ >>= 1;
    if (isSelect) return takenSide(instruction.operation, all, second);
    if (isOpenTruth) return constant(Interval::point(second ? 1 : 0));
    if (second) return afterWrap(whole);
    IntervalGradient before = whole;
    before.wrap = 0;
    return before;
}

const IntervalGradient& IntervalGradientEvaluator::evaluateFolded(std::span<const Interval, 3> box,
                                                                  const Fold& fold) {
    const Fold last = std::exchange(lastFold_, fold);
    folds_ = true;
    const IntervalGradient& answer = evaluate(box);
    folds_ = false;
    lastFold_ = last;
    return answer;
}

double IntervalGradientEvaluator::steepnessByRoots(std::span<const Interval, 3> box) {
    constexpr std::size_t axes = 3;
    evaluate(box);
    double total = 0;
    // The coordinates come last.
    for (std::size_t first = 0; first <= roots_.size();) {
        firstRoot_ = first;
        const IntervalGradient& part = evaluateSlopes(box);
        firstRoot_.reset();
        if (!part.bounded() || part.value.empty() || part.value.maybeUndefined) return unlimited;
        if (first == roots_.size()) return raised(total + part.steepness);
        const std::size_t end = std::min(first + axes, roots_.size());
        for (std::size_t k = first; k < end; ++k)
            total = raised(total + raised(part.slope[k - first].size() * roots_[k].steepness));
        first = end;
    }
    return unlimited;
}

/// A root while roots and coordinates are independent of each other.
IntervalGradient IntervalGradientEvaluator::rootInstead(std::size_t root) const {
    const auto& [value, steepness] = roots_[root];
    if (!(steepness < unlimited) || value.maybeUndefined) return hazardous(value, 7, GradientHazard::unknown);
    const std::size_t first = *firstRoot_;
    return root < first || root >= first + 3 ? constant(value) : coordinate(root - first, value);
}

void IntervalGradientEvaluator::noteRoot(std::size_t root, const IntervalGradient& found) {
    roots_[root] = {found.value, found.bounded() ? found.steepness : unlimited};
    blurred_ = blurred_ || !found.smooth;
}

/// The coordinate that stands in for the operand of a fold.
static IntervalGradient coordinateOf(const IntervalGradientEvaluator::Fold& fold) {
    const auto axis = static_cast<std::size_t>(fold.axis);
    IntervalGradient result = coordinate(axis, fold.value);
    result.slope[axis] = {fold.steepness, fold.steepness};
    result.steepness = fold.steepness;
    return result;
}

/// Whether it came to the end before a stop did.
bool IntervalGradientEvaluator::run(double loopAllowance) {
    const auto& instructions = tape_->instructions();
    if (finely_) {
        const auto count = std::min<std::size_t>(static_cast<std::size_t>(tape_->argumentCount()), 3);
        std::array<const IntervalGradient*, 3> coordinates{};
        for (std::size_t k = 0; k < count; ++k) coordinates[k] = &slots_[k];
        parts_->begin(std::span(coordinates).first(count));
    }
    for (std::size_t i = 0; i < instructions.size(); ++i) {
        if (stopsNow()) return false;
        IntervalGradient& target =
            slots_.make(instructions[i].target, [&] { return resultOf(instructions[i], i, loopAllowance); });
        target.root.known = target.root.known && wantedRoots_[i];
        if (!firstRoot_ && rootAt_[i] < roots_.size()) noteRoot(rootAt_[i], target);
        if (i == fold_ && !folds_ && !firstRoot_)
            lastFold_ = {target.value, target.steepness, std::countr_zero(target.axes)};
        if (finely_) parts_->note(i, target);
        if (middle_ != Middle::none) useMiddle(i, target);
        if (isBase_[i]) bases_[i] = target;
    }
    return true;
}

/// Looks for a stop before some of the instructions.
bool IntervalGradientEvaluator::stopsNow() {
    constexpr unsigned pace = 64;
    return ++steps_ % pace == 0 && LoopStop::requested();
}

/// What an instruction makes of its operands, or what stands for that.
IntervalGradient IntervalGradientEvaluator::resultOf(const Instruction& instruction, std::size_t index,
                                                     double loopAllowance) {
    if (firstRoot_ && rootAt_[index] < roots_.size()) return rootInstead(rootAt_[index]);
    if (folds_ && index == fold_) return coordinateOf(lastFold_);
    const auto found = [&] { return execute(instruction, index, loopAllowance); };
    return takesJumps_ ? besideJump(instruction, index, found()) : found();
}

IntervalGradient IntervalGradientEvaluator::execute(const Instruction& instruction, std::size_t index,
                                                    double loopAllowance) {
    if (isLoop(instruction.operation)) return runLoop(instruction, loopAllowance);
    std::array<const IntervalGradient*, 4> operands{};
    for (std::size_t k = 0; k < instruction.operandCount; ++k) operands[k] = &slots_[instruction.operands[k]];
    const IntervalGradient* const base = powers_[index].exponent > 0 ? &baseOf(powers_[index]) : nullptr;
    return apply(instruction, index, std::span(operands).first(instruction.operandCount), base);
}

/// Anything but a loop; `base` is that of a whole power.
IntervalGradient IntervalGradientEvaluator::apply(const Instruction& instruction, std::size_t index,
                                                  Operands operands, const IntervalGradient* base) {
    const CrackleSettings* crackle =
        instruction.operation == Operation::crackle ? &tape_->crackle(instruction.index) : nullptr;
    if (instruction.operation == Operation::triangleWave) return executeTriangle(*operands[0], index);
    // Of products alone it is not known that they have a root.
    if (const WholePower& power = powers_[index]; power.exponent > 0) {
        const IntervalGradient exponent = constant(Interval::point(power.exponent));
        return evaluateOperation(Operation::power, std::array{base, &exponent}, crackle);
    }
    if (takesSides_ && open_[index]) {
        const bool second = nextSide(index);
        if (!isLed(index)) margins_.push_back(marginOf(instruction.operation, operands, second));
        return sideOf(instruction.operation, operands, second);
    }
    const bool isJoined = isOpenSelect(instruction.operation, operands) && joins(index);
    if (!keepsOpen_ && !takesSides_) {
        open_[index] = isJoined || isOpenChoice(instruction.operation, operands);
        chosen_[index] = chosenSide(instruction.operation, operands);
    } else if (chosen_[index] != ChosenSide::open) {
        // Not decided anew: a piece that is not the function at a point may have any value there, and what an
        // open choice leaves of both sides has the value of one of them.
        return sideOf(instruction.operation, operands, chosen_[index] == ChosenSide::second);
    }
    if (isJoined || (keepsOpen_ && open_[index])) return openChoice(instruction.operation, operands);
    if (!std::isnan(cuts_[index]) && operands[0]->wrap == 0)
        return withCut(evaluateOperation(instruction.operation, operands), cuts_[index]);
    return evaluateOperation(instruction.operation, operands, crackle);
}

const IntervalGradient& IntervalGradientEvaluator::baseOf(const WholePower& power) const {
    const bool isSlot = power.base < slots_.size();
    return isSlot ? slots_[power.base] : bases_[power.base - slots_.size()];
}

/// Whether a select is continuous where its condition is 0.
bool IntervalGradientEvaluator::joins(std::size_t index) {
    if (joined_.empty()) joined_ = joinedSelects(*tape_, uniforms());
    return joined_[index];
}

/// A corner is a choice as that of a magnitude.
IntervalGradient IntervalGradientEvaluator::executeTriangle(const IntervalGradient& u, std::size_t index) {
    if (!keepsOpen_ && !takesSides_) {
        corners_[index] = cornerOf(u);
        open_[index] = !std::isnan(corners_[index]);
    }
    const IntervalGradient* const operand = &u;
    if (!open_[index] || (!keepsOpen_ && !takesSides_))
        return evaluateOperation(Operation::triangleWave, {&operand, 1});
    const IntervalGradient from = fromCorner(u, corners_[index]);
    const IntervalGradient* const distance = &from;
    if (keepsOpen_) return aboutCorner(openChoice(Operation::absolute, {&distance, 1}), corners_[index]);
    const bool second = nextSide(index);
    margins_.push_back(marginOf(Operation::absolute, {&distance, 1}, second));
    return aboutCorner(sideOf(Operation::absolute, {&distance, 1}, second), corners_[index]);
}

IntervalGradient IntervalGradientEvaluator::runLoop(const Instruction& instruction, double loopAllowance) {
    const TapeLoop& loop = tape_->loop(instruction.index);
    IntervalGradientEvaluator& body = *loops_[instruction.index];
    const bool isSum = instruction.operation == Operation::sum;
    const IntervalGradient total0 = constant(Interval::point(isSum ? 0 : 1));
    std::uint8_t axes = 0;
    for (const Slot slot : loop.captured) axes |= slots_[slot].axes;
    const IntervalGradient& first = slots_[instruction.operands[0]];
    const IntervalGradient& last = slots_[instruction.operands[1]];
    axes |= first.axes | last.axes;
    const auto isKnown = [](const IntervalGradient& end) { return end.value.isPoint() && end.wrap == 0; };
    if (!isKnown(first) || !isKnown(last))
        return hazardous(Interval::unknown(), axes, GradientHazard::unknown);
    const LoopRange range(first.value.low, last.value.low, loopAllowance);
    if (range.tooLong()) return undefinedEverywhere();
    if (!range.runs()) return total0;
    if (last.value.low - first.value.low > stepLimit)
        return hazardous(Interval::unknown(), axes, GradientHazard::unknown);
    // A sum of constants alone has no slopes, however many steps it takes.
    IntervalGradient total = total0;
    const double end = last.value.low;
    for (double i = first.value.low; i <= end; i += 1) {
        body.slots_[0] = constant(Interval::point(i));
        for (std::size_t k = 0; k < loop.captured.size(); ++k) body.slots_[k + 1] = slots_[loop.captured[k]];
        if (!body.run(range.bodyAllowance()) || LoopStop::requested())
            return hazardous(Interval::unknown(), 7, GradientHazard::unknown);
        const IntervalGradient& term = body.slots_[body.tape_->results()[0]];
        total = isSum ? sum(total, term) : product(total, term);
    }
    return total;
}

}  // namespace isoscope
