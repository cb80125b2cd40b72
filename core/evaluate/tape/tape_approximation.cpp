// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/evaluate/tape/tape_approximation.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "core/evaluate/interval_evaluator.h"

namespace isoscope {

namespace {

/// Cheaper functions are not worth the search for terms.
constexpr double worthwhileCost = 30;
/// Approximations have to be cheaper than the one before by this factor.
constexpr double worthwhileShare = 0.9;
/// So many terms, the smallest, are tried.
constexpr std::size_t mostTerms = 64;
/// More than the roundings of weights and amounts come to: products of at most a few hundred factors.
constexpr double roundings = 1e-12;

/// About how much dearer than a sum the instructions are, together.
double costOf(const SimplifiedTape& tape) {
    double cost = 0;
    for (const Instruction& instruction : tape.instructions)
        cost += instruction.operation == Operation::noise || isVectorNoise(instruction.operation) ? 8 : 1;
    return cost;
}

Choice decidedEverywhere(Operation operation, const Interval& p, const Interval& q) {
    if (!p.isDefined()) return Choice::open;
    switch (operation) {
        case Operation::minimum:
        case Operation::maximum: {
            if (!q.isDefined()) return Choice::open;
            const bool below = p.high <= q.low, above = q.high <= p.low;
            if (!below && !above) return Choice::open;
            return below == (operation == Operation::minimum) ? Choice::first : Choice::second;
        }
        case Operation::absolute:
            return p.low >= 0 ? Choice::first : p.high <= 0 ? Choice::second : Choice::open;
        case Operation::select3:
            return p.high < 0 ? Choice::first : p.low >= 0 ? Choice::second : Choice::open;
        default:
            if (p.low == 0 && p.high == 0) return Choice::atZero;
            return p.high < 0 ? Choice::first : p.low > 0 ? Choice::second : Choice::open;
    }
}

/// As BoxEvaluator decides where only the sign of the instruction's value minus a level counts.
Choice decidedFor(const SignLevel& level, const Tape& tape, const Instruction& instruction,
                  std::span<const Interval> operands) {
    const auto isAbove = [&](const Interval& values) { return level.isBelow(values); };
    const auto isBelow = [&](const Interval& values) { return level.isAbove(values); };
    if (isSelect(instruction.operation)) {
        const std::span<const Interval> cases = operands.subspan(1);
        return std::ranges::all_of(cases, isAbove) || std::ranges::all_of(cases, isBelow)
                   ? cheapestCase(tape, instruction)
                   : Choice::open;
    }
    // Of an operand that is not a number min and max make the other one, or none.
    if (!operands[0].isDefined() || !operands[1].isDefined()) return Choice::open;
    const bool takesLower = instruction.operation == Operation::minimum;
    const auto leavesTheSign = [&](const Interval& values) {
        return takesLower ? isAbove(values) : isBelow(values);
    };
    return leavesTheSign(operands[0])   ? Choice::second
           : leavesTheSign(operands[1]) ? Choice::first
                                        : Choice::open;
}

/// A term of a sum: an operand of an addition or subtraction whose value goes into the result by sums and
/// constant factors alone.
struct Term {
    std::size_t instruction = 0;
    int operand = 0;
    double offset = 0;  ///< what it adds to the result on average
    double error = 0;   ///< how far it can be from that
};

class TapeApproximator {
  public:
    TapeApproximator(const TapeLinks& links, const IntervalEvaluator& everywhere,
                     const UniformValues& uniforms)
        : links_(links),
          tape_(links.tape()),
          everywhere_(everywhere),
          uniforms_(uniforms),
          simplifier_(links) {}

    std::vector<TapeApproximation> run(std::span<const Choice> choices) {
        std::vector<TapeApproximation> approximations{{decide(choices)}};
        const SimplifiedTape& whole = *approximations[0].tape;
        double cost = costOf(whole);
        if (cost < worthwhileCost) return approximations;
        const std::vector<Term> terms = smallestTerms(whole);
        // Long unions have none: they are not copied.
        if (terms.empty()) return approximations;
        TapeApproximation next;
        SimplifiedTape rest = whole;
        for (const Term& term : terms) {
            if (!leaveOut(term, rest)) continue;
            next.offset += term.offset;
            next.error += term.error * (1 + roundings) + std::abs(next.offset) * roundings;
            next.tape = simplify(rest);
            if (costOf(*next.tape) > worthwhileShare * cost) continue;
            cost = costOf(*next.tape);
            approximations.push_back(next);
            if (approximations.size() == mostApproximations) break;
        }
        return approximations;
    }

  private:
    std::shared_ptr<const SimplifiedTape> decide(std::span<const Choice> choices) {
        const bool isWhole = tape_.results().size() == 1 && std::ranges::all_of(choices, [](Choice choice) {
                                 return choice == Choice::open;
                             });
        // Long unions are not copied.
        if (isWhole) return {std::shared_ptr<const void>(), &links_.whole()};
        const auto decided = std::make_shared<SimplifiedTape>();
        simplifier_.simplify(choices, 0, *decided);
        return decided;
    }

    const Interval& range(const Instruction& instruction, int operand) const {
        return everywhere_.operandRange(instruction.number, operand);
    }

    /// The constant that an instruction multiplies operand k by, but for roundings; NaN where it does
    /// something else.
    double factor(const Instruction& instruction, int k) const {
        const auto uniform = [&](int other) {
            const Slot slot = instruction.operands[static_cast<std::size_t>(other)];
            if (tape_.isUniform(slot)) return uniforms_.of(tape_, slot);
            // The same everywhere, as a power with an exponent of 0 is.
            const Interval& values = range(instruction, other);
            const bool same = !values.maybeUndefined && !values.empty() &&
                              values.high - values.low <= 0.01 * roundings * std::abs(values.low);
            return same ? values.low : NAN;
        };
        switch (instruction.operation) {
            case Operation::add: return 1;
            case Operation::subtract: return k == 0 ? 1 : -1;
            case Operation::negate: return -1;
            case Operation::multiply: return uniform(1 - k);
            case Operation::divide: return k == 0 ? 1 / uniform(1) : NAN;
            // A power with an exponent of 0 is 1.
            case Operation::power: return k == 0 && uniform(1) == 0 ? 0 : NAN;
            default: return NAN;
        }
    }

    struct Weight {
        double sum = 0;
        double size = 0;  ///< of all its parts
    };

    /// Whether something else than the result itself can be in it by sums and constant factors.
    bool isSum(const SimplifiedTape& whole) const {
        if (SimplifiedTape::isFixed(whole.resultValue)) return false;
        const Instruction& last = whole.instructions[whole.resultValue];
        for (int k = 0; k < last.operandCount; ++k)
            if (!std::isnan(factor(last, k))) return true;
        return false;
    }

    /// How much of each instruction's value is in the result; NaN where it is there in other ways too.
    std::vector<Weight> weigh(const SimplifiedTape& whole) const {
        const std::vector<Instruction>& instructions = whole.instructions;
        constexpr std::size_t fixed = ~std::size_t{0};
        std::vector<std::size_t> writer(tape_.slotCount(), fixed);
        std::vector<std::array<std::size_t, 4>> sources(instructions.size());
        for (std::size_t i = 0; i < instructions.size(); ++i) {
            for (std::size_t k = 0; k < instructions[i].operandCount; ++k)
                sources[i][k] = writer[instructions[i].operands[k]];
            writer[instructions[i].target] = i;
        }
        std::vector<Weight> weights(instructions.size());
        if (writer[whole.result] != fixed) weights[writer[whole.result]] = {1, 1};
        for (std::size_t i = instructions.size(); i-- > 0;)
            for (int k = 0; k < instructions[i].operandCount; ++k)
                if (const std::size_t source = sources[i][static_cast<std::size_t>(k)]; source != fixed) {
                    const double part = factor(instructions[i], k);
                    if (part == 0) continue;
                    weights[source].sum += weights[i].sum * part;
                    weights[source].size += weights[i].size * std::abs(part);
                }
        return weights;
    }

    std::vector<Term> smallestTerms(const SimplifiedTape& whole) const {
        std::vector<Term> terms;
        if (!isSum(whole)) return terms;
        const std::vector<Weight> weights = weigh(whole);
        for (std::size_t i = 0; i < weights.size(); ++i) {
            const Instruction& instruction = whole.instructions[i];
            if (instruction.operation != Operation::add && instruction.operation != Operation::subtract)
                continue;
            for (int k = 0; k < 2; ++k) {
                const Interval& values = range(instruction, k);
                const double weight = weights[i].sum * factor(instruction, k);
                const double middle = 0.5 * (values.low + values.high);
                const double largest = std::max(std::abs(values.low), std::abs(values.high));
                const double error = std::abs(weight) * 0.5 * (values.high - values.low) +
                                     roundings * weights[i].size * largest;
                if (!values.maybeUndefined && std::isfinite(error) && error > 0)
                    terms.push_back({i, k, weight * middle, error});
            }
        }
        std::stable_sort(terms.begin(), terms.end(),
                         [](const Term& a, const Term& b) { return a.error < b.error; });
        terms.resize(std::min(terms.size(), mostTerms));
        return terms;
    }

    /// Makes a choice of the sum, which is to take what is left of it. False where nothing would be.
    static bool leaveOut(const Term& term, SimplifiedTape& rest) {
        Instruction& instruction = rest.instructions[term.instruction];
        if (instruction.operation != Operation::add && instruction.operation != Operation::subtract)
            return false;
        const bool flips = instruction.operation == Operation::subtract && term.operand == 0;
        const std::size_t kept = term.operand == 0 ? 1 : 0;
        instruction.operands[0] = instruction.operands[1] = instruction.operands[kept];
        std::array<SimplifiedTape::Value, 4>& links = rest.links[term.instruction].operands;
        links[0] = links[1] = links[kept];
        instruction.operation = flips ? Operation::negate : Operation::minimum;
        instruction.operandCount = flips ? 1 : 2;
        return true;
    }

    std::shared_ptr<const SimplifiedTape> simplify(SimplifiedTape& rest) {
        std::vector<Choice> choices;
        for (std::size_t i = 0; i < rest.instructions.size(); ++i) {
            const Instruction& instruction = rest.instructions[i];
            if (!isChoice(instruction.operation)) continue;
            // Sums have become choices: all have new numbers.
            rest.links[i].choice = static_cast<std::uint32_t>(choices.size());
            choices.push_back(instruction.operation == Operation::minimum &&
                                      instruction.operands[0] == instruction.operands[1]
                                  ? Choice::first
                                  : Choice::open);
        }
        rest.levelNumbers.assign(choices.size(), 0);
        const auto simplified = std::make_shared<SimplifiedTape>();
        simplifier_.setBase(&rest);
        simplifier_.simplify(choices, 0, *simplified);
        simplifier_.setBase(nullptr);
        return simplified;
    }

    const TapeLinks& links_;
    const Tape& tape_;
    const IntervalEvaluator& everywhere_;
    const UniformValues& uniforms_;
    TapeSimplifier simplifier_;
};

}  // namespace

std::vector<Choice> choicesEverywhere(const TapeLinks& links, const IntervalEvaluator& everywhere,
                                      std::span<const SignLevel> levels) {
    const SignStakes signs{
        levels, levels.empty() ? std::span<const std::uint32_t>() : std::span(links.whole().levelNumbers)};
    std::vector<Choice> choices;
    choices.reserve(links.whole().levelNumbers.size());
    for (const Instruction& instruction : links.tape().instructions()) {
        if (!isChoice(instruction.operation)) continue;
        std::array<Interval, 4> operands;
        for (std::size_t k = 0; k < instruction.operandCount; ++k)
            operands[k] = everywhere.operandRange(instruction.number, static_cast<int>(k));
        Choice choice = decidedEverywhere(instruction.operation, operands[0], operands[1]);
        if (choice == Choice::open)
            if (const SignLevel* level = signs.of(choices.size()))
                choice = decidedFor(*level, links.tape(), instruction,
                                    std::span(operands).first(instruction.operandCount));
        choices.push_back(choice);
    }
    return choices;
}

std::vector<TapeApproximation> approximationsOf(const TapeLinks& links, std::span<const Choice> choices,
                                                const IntervalEvaluator& everywhere,
                                                const UniformValues& uniforms) {
    if (!links.tape().loops().empty()) return {};
    return TapeApproximator(links, everywhere, uniforms).run(choices);
}

}  // namespace isoscope
