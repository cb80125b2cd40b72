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
                     const UniformValues& uniforms, std::span<const SignLevel> levels)
        : tape_(links.tape()),
          everywhere_(everywhere),
          uniforms_(uniforms),
          simplifier_(links),
          signs_{levels, levels.empty() ? std::span<const std::uint32_t>() : simplifier_.levelNumbers()} {}

    std::vector<TapeApproximation> run() {
        std::vector<TapeApproximation> approximations(1);
        simplifier_.simplify(decidedChoices(), 0, approximations[0].tape);
        whole_ = approximations[0].tape;
        double cost = costOf(whole_);
        if (cost < worthwhileCost) return approximations;
        weigh();
        TapeApproximation next{whole_};
        SimplifiedTape rest = whole_;
        for (const Term& term : smallestTerms()) {
            if (!leaveOut(term, rest)) continue;
            next.offset += term.offset;
            next.error += term.error * (1 + roundings) + std::abs(next.offset) * roundings;
            simplify(rest, next.tape);
            if (costOf(next.tape) > worthwhileShare * cost) continue;
            cost = costOf(next.tape);
            approximations.push_back(next);
            if (approximations.size() == mostApproximations) break;
        }
        return approximations;
    }

  private:
    std::vector<Choice> decidedChoices() const {
        std::vector<Choice> choices;
        for (const Instruction& instruction : tape_.instructions()) {
            if (!isChoice(instruction.operation)) continue;
            Choice choice =
                decidedEverywhere(instruction.operation, range(instruction, 0), range(instruction, 1));
            if (choice == Choice::open)
                if (const SignLevel* level = signs_.of(choices.size()))
                    choice = decidedFor(*level, instruction);
            choices.push_back(choice);
        }
        return choices;
    }

    /// As BoxEvaluator decides where only the sign of the instruction's value minus a level counts.
    Choice decidedFor(const SignLevel& level, const Instruction& instruction) const {
        const auto isAbove = [&](int k) { return level.isBelow(range(instruction, k)); };
        const auto isBelow = [&](int k) { return level.isAbove(range(instruction, k)); };
        if (isSelect(instruction.operation)) {
            bool above = true, below = true;
            for (int k = 1; k < instruction.operandCount; ++k) {
                above = above && isAbove(k);
                below = below && isBelow(k);
            }
            return above || below ? cheapestCase(tape_, instruction) : Choice::open;
        }
        // Of an operand that is not a number min and max make the other one, or none.
        if (!range(instruction, 0).isDefined() || !range(instruction, 1).isDefined()) return Choice::open;
        const bool takesLower = instruction.operation == Operation::minimum;
        const auto leavesTheSign = [&](int k) { return takesLower ? isAbove(k) : isBelow(k); };
        return leavesTheSign(0) ? Choice::second : leavesTheSign(1) ? Choice::first : Choice::open;
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

    /// How much of each instruction's value is in the result; NaN where it is there in other ways too.
    void weigh() {
        const std::vector<Instruction>& instructions = whole_.instructions;
        constexpr std::size_t fixed = ~std::size_t{0};
        std::vector<std::size_t> writer(tape_.slotCount(), fixed);
        std::vector<std::array<std::size_t, 4>> sources(instructions.size());
        for (std::size_t i = 0; i < instructions.size(); ++i) {
            for (std::size_t k = 0; k < instructions[i].operandCount; ++k)
                sources[i][k] = writer[instructions[i].operands[k]];
            writer[instructions[i].target] = i;
        }
        weights_.assign(instructions.size(), {});
        if (writer[whole_.result] != fixed) weights_[writer[whole_.result]] = {1, 1};
        for (std::size_t i = instructions.size(); i-- > 0;)
            for (int k = 0; k < instructions[i].operandCount; ++k)
                if (const std::size_t source = sources[i][static_cast<std::size_t>(k)]; source != fixed) {
                    const double part = factor(instructions[i], k);
                    if (part == 0) continue;
                    weights_[source].sum += weights_[i].sum * part;
                    weights_[source].size += weights_[i].size * std::abs(part);
                }
    }

    std::vector<Term> smallestTerms() const {
        std::vector<Term> terms;
        for (std::size_t i = 0; i < weights_.size(); ++i) {
            const Instruction& instruction = whole_.instructions[i];
            if (instruction.operation != Operation::add && instruction.operation != Operation::subtract)
                continue;
            for (int k = 0; k < 2; ++k) {
                const Interval& values = range(instruction, k);
                const double weight = weights_[i].sum * factor(instruction, k);
                const double middle = 0.5 * (values.low + values.high);
                const double largest = std::max(std::abs(values.low), std::abs(values.high));
                const double error = std::abs(weight) * 0.5 * (values.high - values.low) +
                                     roundings * weights_[i].size * largest;
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

    void simplify(SimplifiedTape& rest, SimplifiedTape& into) {
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
        simplifier_.setBase(&rest);
        simplifier_.simplify(choices, 0, into);
        simplifier_.setBase(nullptr);
    }

    const Tape& tape_;
    const IntervalEvaluator& everywhere_;
    const UniformValues& uniforms_;
    TapeSimplifier simplifier_;
    SignStakes signs_;
    SimplifiedTape whole_;
    struct Weight {
        double sum = 0;
        double size = 0;  ///< of all its parts
    };
    std::vector<Weight> weights_;
};

}  // namespace

std::vector<TapeApproximation> approximationsOf(const TapeLinks& links, const IntervalEvaluator& everywhere,
                                                const UniformValues& uniforms,
                                                std::span<const SignLevel> levels) {
    if (!links.tape().loops().empty()) return {};
    return TapeApproximator(links, everywhere, uniforms, levels).run();
}

}  // namespace isoscope
