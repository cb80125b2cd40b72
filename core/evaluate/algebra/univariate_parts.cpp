// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/evaluate/algebra/univariate_parts.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/evaluate/algebra/interval_gradient_rules.h"
#include "core/evaluate/interval_gradient_evaluator.h"
#include "core/evaluate/tape/tape_axes.h"
#include "core/evaluate/tape/tape_function.h"

namespace isoscope {

using namespace gradient_rules;

namespace {

constexpr std::size_t mostInstructions = 1000;
/// Parts of the range of an operand.
constexpr std::size_t pieces = 8;

/// A coordinate (0 to 2), an instruction, or none of them.
using TapeNode = std::size_t;
constexpr TapeNode firstInstruction = 3;
constexpr TapeNode nowhere = static_cast<TapeNode>(-1);

/// Which coordinates each slot of a tape holds before the first instruction.
std::vector<TapeNode> coordinateSlots(const Tape& tape) {
    std::vector<TapeNode> slots(tape.slotCount(), nowhere);
    const auto coordinates = static_cast<std::size_t>(std::min(3, tape.argumentCount()));
    for (std::size_t k = 0; k < coordinates; ++k) slots[k] = k;
    return slots;
}

/// Through which operand alone each instruction of a tape depends on the coordinates: its immediate dominator
/// in the graph of operands.
class Dominators {
  public:
    explicit Dominators(const Tape& tape)
        : above_(firstInstruction + tape.instructions().size(), nowhere), depth_(above_.size()) {
        std::vector<TapeNode> slots = coordinateSlots(tape);
        for (std::size_t i = 0; i < tape.instructions().size(); ++i) {
            const Instruction& instruction = tape.instructions()[i];
            const TapeNode node = firstInstruction + i;
            bool first = true;
            for (std::size_t k = 0; k < instruction.operandCount; ++k) {
                const TapeNode operand = slots[instruction.operands[k]];
                if (operand == nowhere) continue;  // uniform
                above_[node] = first ? operand : common(above_[node], operand);
                first = false;
            }
            depth_[node] = above_[node] == nowhere ? 0 : depth_[above_[node]] + 1;
            slots[instruction.target] = node;
        }
    }

    /// The operand through which alone a node depends on the coordinates; `nowhere` if there is none.
    TapeNode above(TapeNode node) const { return above_[node]; }

  private:
    TapeNode common(TapeNode a, TapeNode b) const {
        while (a != b) {
            if (a == nowhere || b == nowhere) return nowhere;
            TapeNode& deeper = depth_[a] >= depth_[b] ? a : b;
            deeper = above_[deeper];
        }
        return a;
    }

    std::vector<TapeNode> above_;
    std::vector<std::size_t> depth_;
};

}  // namespace

UnivariateParts::UnivariateParts(const Tape& tape, std::span<const double> uniforms) {
    const auto& instructions = tape.instructions();
    if (!tape.loops().empty() || instructions.size() > mostInstructions) return;
    const Dominators dominators(tape);
    // The operand of which each is a function. The length of a vector, a root, has a slope of its own that
    // is better known than as a function of its square.
    std::vector<TapeNode> base(firstInstruction + instructions.size());
    // How many operations that are no straight lines are one after the other behind the base.
    std::vector<std::size_t> bent(base.size(), 0);
    for (TapeNode k = 0; k < firstInstruction; ++k) base[k] = k;
    // The last of each base: what is used by others, or is the result.
    std::vector<bool> isLast(base.size(), false);
    std::vector<TapeNode> slots = coordinateSlots(tape);
    for (std::size_t i = 0; i < instructions.size(); ++i) {
        const TapeNode node = firstInstruction + i, above = dominators.above(node);
        const bool isOwn = above == nowhere || instructions[i].operation == Operation::squareRoot;
        base[node] = isOwn ? node : base[above];
        for (std::size_t k = 0; k < instructions[i].operandCount; ++k) {
            const TapeNode operand = slots[instructions[i].operands[k]];
            if (operand == nowhere) continue;
            if (base[operand] == base[node])
                bent[node] = std::max(bent[node], bent[operand]);
            else
                isLast[operand] = true;
        }
        if (!isOwn && !isLinear(tape, instructions[i])) ++bent[node];
        slots[instructions[i].target] = node;
    }
    if (const TapeNode result = slots[tape.results()[0]]; result != nowhere) isLast[result] = true;
    std::size_t length = 0;
    for (std::size_t i = 0; i < instructions.size(); ++i) {
        const TapeNode node = firstInstruction + i;
        if (!isLast[node] || bent[node] < 2) continue;
        TapeStandIns standIns;
        standIns.coordinate = [&](FunctionGraph& graph, std::size_t axis) {
            return axis == base[node] ? graph.variable(0) : noNode;
        };
        standIns.instruction = [&](FunctionGraph& graph, std::size_t k) {
            return firstInstruction + k == base[node] ? graph.variable(0) : noNode;
        };
        const Function function = functionOf(tape, uniforms, standIns, i);
        if (function.graph->overflowed()) continue;
        const std::shared_ptr<const Tape> part = Tape::compile(function);
        length += part->instructions().size();
        auto evaluator = std::make_unique<IntervalGradientEvaluator>(part, std::span<const double>());
        parts_.push_back({base[node], i, std::move(evaluator), {}});
    }
    // Measured: the 17 places of a part cost less than as many of the tape, of which more is asked.
    constexpr std::size_t costOfWhole = 3;
    if (!parts_.empty()) work_ = 1 + costOfWhole * length / instructions.size();
}

UnivariateParts::~UnivariateParts() = default;

void UnivariateParts::begin(std::span<const IntervalGradient* const> coordinates) {
    for (Part& part : parts_)
        if (part.base < coordinates.size()) part.from = *coordinates[part.base];
}

void UnivariateParts::note(std::size_t instruction, IntervalGradient& result) {
    for (Part& part : parts_) {
        if (part.result == instruction) refine(part, result);
        if (part.base == firstInstruction + instruction) part.from = result;
    }
}

/// Meets what is known of the result with the chain rule for the whole part.
void UnivariateParts::refine(Part& part, IntervalGradient& result) {
    const IntervalGradient& from = part.from;
    const auto isPlain = [](const IntervalGradient& a) {
        return a.bounded() && !a.pieced && a.wrap == 0 && a.value.isDefined();
    };
    if (!isPlain(from) || !isPlain(result) || from.isConstant()) return;
    std::array<double, pieces + 1> ends{};
    for (std::size_t k = 0; k <= pieces; ++k) {
        const double share = static_cast<double>(k) / static_cast<double>(pieces);
        ends[k] = (1 - share) * from.value.low + share * from.value.high;
    }
    ends.front() = from.value.low;
    ends.back() = from.value.high;
    if (!std::is_sorted(ends.begin(), ends.end(), std::less_equal<>()) ||
        !std::isfinite(ends.back() - ends.front()))
        return;
    const auto at = [&](double low, double high) -> const IntervalGradient& {
        const std::array<Interval, 3> argument{Interval{low, high, false}, Interval{}, Interval{}};
        return low == high ? part.function->evaluateSlopes(argument) : part.function->evaluate(argument);
    };
    Interval value = Interval::undefined();
    Derivatives h;
    SlopeRange before = at(ends[0], ends[0]).slope[0];
    for (std::size_t k = 0; k < pieces; ++k) {
        const IntervalGradient& piece = at(ends[k], ends[k + 1]);
        if (!isPlain(piece)) return;
        const Interval values = piece.value;
        SlopeRange first = piece.slope[0];
        const SlopeRange second = piece.smooth ? piece.bend[0] : SlopeRange::within(unlimited);
        const SlopeRange after = at(ends[k + 1], ends[k + 1]).slope[0];
        if (second.isFinite() && before.isFinite() && after.isFinite()) {
            // From the nearer of both ends.
            const double way = raised(0.5 * (ends[k + 1] - ends[k]));
            first =
                meet(first, hull(before + second * SlopeRange{0, way}, after + second * SlopeRange{-way, 0}));
            if (!(first.low <= first.high)) return;
        }
        before = after;
        value = k == 0 ? values : hull(value, values);
        h.first = k == 0 ? first : hull(h.first, first);
        h.second = k == 0 ? second : hull(h.second, second);
    }
    const IntervalGradient whole = chain(from, value, h, GradientHazard::overflow);
    if (!whole.bounded()) return;
    const auto narrow = [](SlopeRange& known, const SlopeRange& other) {
        const SlopeRange both = meet(known, other);
        if (both.low <= both.high) known = both;
    };
    for (std::size_t k = 0; k < 3; ++k) narrow(result.slope[k], whole.slope[k]);
    result.steepness = std::min(result.steepness, whole.steepness);
    if (whole.smooth && result.smooth)
        for (std::size_t k = 0; k < 6; ++k) narrow(result.bend[k], whole.bend[k]);
    settle(result);
}

}  // namespace isoscope
