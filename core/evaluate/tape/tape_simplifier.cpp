// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/evaluate/tape/tape_simplifier.h"

#include <algorithm>
#include <bit>
#include <utility>

namespace isoscope {

namespace {

constexpr std::size_t wordBits = 64;

/// The operand that a decided choice comes to.
std::size_t chosenOperand(Operation operation, Choice choice) {
    const bool first = choice == Choice::first;
    switch (operation) {
        case Operation::select3: return first ? 1 : 2;
        case Operation::select4: return first ? 1 : choice == Choice::atZero ? 2 : 3;
        case Operation::absolute: return 0;
        default: return first ? 0 : 1;
    }
}

bool becomesNegation(Operation operation, Choice choice) {
    return operation == Operation::absolute && choice == Choice::second;
}

using Value = SimplifiedTape::Value;

/// What an instruction comes to, by the choices of a tape one by one: choose(k) of its k-th choosing one.
template <class Choose>
class Decisions {
  public:
    Decisions(const SimplifiedTape& tape, Choose choose) : tape_(tape), choose_(choose) {}

    Choice of(Value value) const {
        // Tapes with loops are not shortened.
        return !tape_.levelNumbers.empty() && isChoice(tape_.instructions[value].operation)
                   ? choose_(tape_.links[value].choice)
                   : Choice::open;
    }

    /// What a value comes to if it is that of a decided choice.
    Value follow(Value value) const {
        while (!SimplifiedTape::isFixed(value)) {
            const Value next = step(value);
            if (next == value) break;
            value = next;
        }
        return value;
    }

    /// The operand that an instruction comes to; itself where that is open.
    Value step(Value value) const {
        const Choice choice = of(value);
        const Operation operation = tape_.instructions[value].operation;
        if (choice == Choice::open || becomesNegation(operation, choice)) return value;
        return tape_.links[value].operands[chosenOperand(operation, choice)];
    }

  private:
    const SimplifiedTape& tape_;
    Choose choose_;
};

/// The same for all of a tape, many links of a chain at once.
class ChainDecisions {
  public:
    ChainDecisions(const TapeLinks& links, const DecidedChoices& choices)
        : links_(links), chains_(links.chains()), choices_(choices) {}

    /// The choices one by one.
    auto plain() const {
        return Decisions(links_.whole(),
                         [this](std::uint32_t choice) { return choices_.of(chains_.places[choice]); });
    }

    Choice of(Value value) const { return plain().of(value); }

    Value follow(Value value) const {
        while (!SimplifiedTape::isFixed(value)) {
            const SimplifiedTape& whole = links_.whole();
            if (!isChoice(whole.instructions[value].operation)) break;
            const std::uint32_t place = chains_.places[whole.links[value].choice];
            const std::uint32_t end = endOfChain(place);
            const Value next = end < place ? chains_.instructions[end] : plain().step(value);
            if (next == value) break;
            value = next;
        }
        return value;
    }

  private:
    /// The place that decided choices of a chain lead to, link by link; this one where its own choice does
    /// not.
    std::uint32_t endOfChain(std::uint32_t place) const {
        std::size_t word = place / wordBits;
        const auto ends = [&] {
            return ~((choices_.first[word] & chains_.leadsByFirst[word]) |
                     (choices_.second[word] & chains_.leadsBySecond[word]));
        };
        // The first place of all leads nowhere.
        std::uint64_t found = ends() & (~std::uint64_t(0) >> (wordBits - 1 - place % wordBits));
        while (found == 0) {
            --word;
            found = ends();
        }
        return static_cast<std::uint32_t>(word * wordBits) +
               static_cast<std::uint32_t>(std::bit_width(found)) - 1;
    }

    const TapeLinks& links_;
    const TapeLinks::Chains& chains_;
    const DecidedChoices& choices_;
};

}  // namespace

Choice DecidedChoices::of(std::uint32_t place) const {
    const std::uint64_t bit = std::uint64_t(1) << place % wordBits;
    if ((first[place / wordBits] & bit) != 0) return Choice::first;
    return (second[place / wordBits] & bit) != 0 ? Choice::second : Choice::open;
}

void DecidedChoices::reset(const TapeLinks& links) {
    first.assign(links.chains().leadsByFirst.size(), 0);
    second.assign(first.size(), 0);
}

void DecidedChoices::add(std::span<const std::uint32_t> places, std::span<const LaneChoices> choices,
                         std::uint64_t lanes) {
    for (std::size_t k = 0; k < places.size(); ++k) {
        const std::size_t word = places[k] / wordBits;
        const std::uint64_t bit = std::uint64_t(1) << places[k] % wordBits;
        const Choice choice = choices[k].ofAll(lanes);
        if (choice == Choice::first) first[word] |= bit;
        if (choice == Choice::second) second[word] |= bit;
    }
}

void TapeSimplifier::simplify(std::span<const Choice> choices, std::size_t result,
                              SimplifiedTape& simplifiedTape) {
    shortenBy(Decisions(*base_, [choices](std::uint32_t choice) { return choices[choice]; }), result,
              simplifiedTape);
}

std::size_t TapeSimplifier::countLeft(std::span<const Choice> choices, std::size_t result) {
    makeRoom();
    const Decisions decisions(*base_, [choices](std::uint32_t choice) { return choices[choice]; });
    markNeeded(decisions.follow(resultOf(result)), decisions);
    const std::size_t count = countNeeded();
    std::fill(needed_.begin(), needed_.end(), std::uint64_t{0});
    return count;
}

void TapeSimplifier::simplify(std::span<const LaneChoices> choices, std::uint64_t lanes, std::size_t result,
                              SimplifiedTape& simplifiedTape) {
    const auto ofLanes = [choices, lanes](std::uint32_t choice) { return choices[choice].ofAll(lanes); };
    shortenBy(Decisions(*base_, ofLanes), result, simplifiedTape);
}

void TapeSimplifier::simplify(const DecidedChoices& choices, SimplifiedTape& simplifiedTape) {
    const SimplifiedTape* const base = std::exchange(base_, &links_.whole());
    shortenBy(ChainDecisions(links_, choices), 0, simplifiedTape);
    base_ = base;
}

template <class Decided>
void TapeSimplifier::shortenBy(const Decided& decisions, std::size_t result, SimplifiedTape& simplifiedTape) {
    makeRoom();
    const Value value = decisions.follow(resultOf(result));
    markNeeded(value, decisions);
    assignSlots(simplifiedTape);
    simplifiedTape.resultValue = SimplifiedTape::isFixed(value) ? value : numbers_[value];
    simplifiedTape.result = SimplifiedTape::isFixed(value) ? value - SimplifiedTape::fixed : slots_[value];
}

void TapeSimplifier::makeRoom() {
    if (!needed_.empty()) return;
    const std::size_t count = links_.whole().instructions.size();
    needed_.resize(count / wordBits + 1);
    operands_.resize(count);
    flipped_.resize(count);
    lastUse_.resize(count);
    numbers_.resize(count);
    slots_.resize(count);
}

void TapeSimplifier::need(Value value, std::uint32_t user) {
    if (SimplifiedTape::isFixed(value)) return;
    std::uint64_t& word = needed_[value / wordBits];
    const std::uint64_t bit = std::uint64_t(1) << value % wordBits;
    // The last user comes first.
    if ((word & bit) == 0) lastUse_[value] = user;
    word |= bit;
    firstWord_ = std::min(firstWord_, value / wordBits);
}

template <class Decided>
void TapeSimplifier::markNeeded(Value result, const Decided& decisions) {
    endWord_ = firstWord_ = SimplifiedTape::isFixed(result) ? 0 : result / wordBits + 1;
    need(result, static_cast<std::uint32_t>(base_->instructions.size()));
    for (std::size_t word = endWord_; word-- > firstWord_;) {
        // Operands stand before what uses them, maybe in the same word.
        for (std::uint64_t below = ~std::uint64_t(0); (needed_[word] & below) != 0;) {
            const auto bit = static_cast<int>(std::bit_width(needed_[word] & below)) - 1;
            below = (std::uint64_t(1) << bit) - 1;
            const auto i = static_cast<std::uint32_t>(word * wordBits) + static_cast<std::uint32_t>(bit);
            const Instruction& instruction = base_->instructions[i];
            flipped_[i] = becomesNegation(instruction.operation, decisions.of(i));
            for (std::size_t k = 0; k < instruction.operandCount; ++k) {
                operands_[i][k] = decisions.follow(base_->links[i].operands[k]);
                need(operands_[i][k], i);
            }
        }
    }
}

std::size_t TapeSimplifier::countNeeded() const {
    std::size_t count = 0;
    for (std::size_t word = firstWord_; word < endWord_; ++word)
        count += static_cast<std::size_t>(std::popcount(needed_[word]));
    return count;
}

void TapeSimplifier::assignSlots(SimplifiedTape& simplifiedTape) {
    simplifiedTape.instructions.clear();
    simplifiedTape.links.clear();
    simplifiedTape.levelNumbers.clear();
    free_.clear();
    Slot next = links_.tape().firstReused();
    const std::size_t left = countNeeded();
    simplifiedTape.instructions.reserve(left);
    simplifiedTape.links.reserve(left);
    for (std::size_t word = firstWord_; word < endWord_; ++word) {
        for (std::uint64_t bits = std::exchange(needed_[word], 0); bits != 0; bits &= bits - 1) {
            const auto i = static_cast<std::uint32_t>(word * wordBits) +
                           static_cast<std::uint32_t>(std::countr_zero(bits));
            append(i, simplifiedTape);
            if (free_.empty()) {
                slots_[i] = next++;
            } else {
                slots_[i] = free_.back();
                free_.pop_back();
            }
            simplifiedTape.instructions.back().target = slots_[i];
        }
    }
}

/// Instruction `source` of the base, on slots; those that it is the last to use become free.
void TapeSimplifier::append(std::uint32_t source, SimplifiedTape& simplifiedTape) {
    numbers_[source] = static_cast<std::uint32_t>(simplifiedTape.instructions.size());
    Instruction& instruction = simplifiedTape.instructions.emplace_back(base_->instructions[source]);
    SimplifiedTape::Link& link = simplifiedTape.links.emplace_back();
    if (flipped_[source]) {
        instruction.operation = Operation::negate;
    } else if (choiceCount() > 0 && isChoice(instruction.operation)) {
        link.choice = static_cast<std::uint32_t>(simplifiedTape.levelNumbers.size());
        simplifiedTape.levelNumbers.push_back(base_->levelNumbers[base_->links[source].choice]);
    }
    for (std::size_t k = 0; k < instruction.operandCount; ++k) {
        const Value value = operands_[source][k];
        if (SimplifiedTape::isFixed(value)) {
            link.operands[k] = value;
            instruction.operands[k] = value - SimplifiedTape::fixed;
            continue;
        }
        link.operands[k] = numbers_[value];
        instruction.operands[k] = slots_[value];
        if (lastUse_[value] != source) continue;
        free_.push_back(slots_[value]);
        // The same value may be both operands: its slot is free once.
        lastUse_[value] = static_cast<std::uint32_t>(base_->instructions.size());
    }
}

}  // namespace isoscope
