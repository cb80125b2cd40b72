// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/evaluate/tape/tape_links.h"

#include <cmath>
#include <limits>

namespace isoscope {

namespace {

using Value = SimplifiedTape::Value;

constexpr std::size_t wordBits = 64;

}  // namespace

TapeLinks::TapeLinks(const Tape& tape) : tape_(tape) {
    linkWhole();
    findLevels();
    leastLength_ = countLeast();
    findChains();
}

/// Follows the values through the slots, which the tape uses again and again.
void TapeLinks::linkWhole() {
    whole_.instructions.assign(tape_.instructions().begin(), tape_.instructions().end());
    std::vector<Value> current(tape_.slotCount());
    for (Slot slot = 0; slot < current.size(); ++slot) current[slot] = SimplifiedTape::fixed | slot;
    whole_.links.reserve(whole_.instructions.size());
    for (std::uint32_t i = 0; i < whole_.instructions.size(); ++i) {
        const Instruction& instruction = whole_.instructions[i];
        SimplifiedTape::Link& link = whole_.links.emplace_back();
        for (std::size_t k = 0; k < instruction.operandCount; ++k)
            link.operands[k] = current[instruction.operands[k]];
        current[instruction.target] = i;
        if (!tape_.loops().empty() || !isChoice(instruction.operation)) continue;
        link.choice = static_cast<std::uint32_t>(whole_.levelNumbers.size());
        whole_.levelNumbers.push_back(0);
    }
    for (const Slot slot : tape_.results()) results_.push_back(current[slot]);
    whole_.result = tape_.results()[0];
    whole_.resultValue = results_[0];
}

std::size_t TapeLinks::countLeast() const {
    std::vector<bool> needed(whole_.links.size());
    const auto need = [&](Value value) {
        if (!SimplifiedTape::isFixed(value)) needed[value] = true;
    };
    need(results_[0]);
    std::size_t length = 0;
    for (std::size_t i = needed.size(); i-- > 0;) {
        const Operation operation = whole_.instructions[i].operation;
        if (!needed[i] || (isChoice(operation) && operation != Operation::absolute)) continue;
        ++length;
        for (std::size_t k = 0; k < whole_.instructions[i].operandCount; ++k)
            need(whole_.links[i].operands[k]);
    }
    return length;
}

void TapeLinks::findChains() {
    const std::size_t count = whole_.levelNumbers.size();
    constexpr std::uint32_t none = ~std::uint32_t{0};
    std::vector<std::uint32_t> instructions, next(count, none);
    std::vector<int> leadingOperand(count, -1);
    for (std::uint32_t i = 0; instructions.size() < count; ++i) {
        const Operation operation = whole_.instructions[i].operation;
        if (!isChoice(operation)) continue;
        const auto choice = static_cast<std::uint32_t>(instructions.size());
        instructions.push_back(i);
        for (int k = 0; k < whole_.instructions[i].operandCount && !isSelect(operation); ++k) {
            const Value value = whole_.links[i].operands[static_cast<std::size_t>(k)];
            if (SimplifiedTape::isFixed(value) || !isChoice(whole_.instructions[value].operation)) continue;
            std::uint32_t& after = next[whole_.links[value].choice];
            if (after != none) continue;
            after = choice;
            leadingOperand[choice] = k;
            break;
        }
    }
    chains_.places.resize(count);
    chains_.leadsByFirst.resize(count / wordBits + 1);
    chains_.leadsBySecond.resize(count / wordBits + 1);
    for (std::uint32_t first = 0; first < count; ++first) {
        if (leadingOperand[first] >= 0) continue;
        for (std::uint32_t choice = first; choice != none; choice = next[choice]) {
            const std::size_t place = chains_.instructions.size();
            chains_.places[choice] = static_cast<std::uint32_t>(place);
            chains_.instructions.push_back(instructions[choice]);
            const std::uint64_t bit = std::uint64_t(1) << place % wordBits;
            if (leadingOperand[choice] == 0) chains_.leadsByFirst[place / wordBits] |= bit;
            if (leadingOperand[choice] == 1) chains_.leadsBySecond[place / wordBits] |= bit;
        }
    }
}

/// From the result backwards, along values that are used but once: another user might need all of them.
void TapeLinks::findLevels() {
    std::vector<int> uses(whole_.links.size());
    const auto use = [&](Value value) {
        if (!SimplifiedTape::isFixed(value)) ++uses[value];
    };
    for (const Value value : results_) use(value);
    for (std::size_t i = 0; i < whole_.links.size(); ++i)
        for (std::size_t k = 0; k < whole_.instructions[i].operandCount; ++k)
            use(whole_.links[i].operands[k]);
    std::vector<std::uint32_t> numbers(whole_.links.size());
    const auto put = [&](Value value, std::uint32_t number) {
        if (!SimplifiedTape::isFixed(value) && uses[value] == 1) numbers[value] = number;
    };
    put(whole_.resultValue, 1);
    for (std::size_t i = whole_.links.size(); i-- > 0;) {
        if (numbers[i] == 0) continue;
        const SimplifiedTape::Link& link = whole_.links[i];
        const Operation operation = whole_.instructions[i].operation;
        if (std::optional<LevelStep> step = levelStep(i)) {
            step->from = numbers[i];
            levelSteps_.push_back(*step);
            put(link.operands[step->uniformFirst ? 1 : 0],
                static_cast<std::uint32_t>(levelSteps_.size() + 1));
        }
        if (!isChoice(operation) || operation == Operation::absolute) continue;
        // Of a select's first operand it is another sign that counts.
        for (std::size_t k = isSelect(operation) ? 1 : 0; k < whole_.instructions[i].operandCount; ++k)
            put(link.operands[k], numbers[i]);
        if (!whole_.levelNumbers.empty()) whole_.levelNumbers[link.choice] = numbers[i];
    }
}

/// How the value of an operand of a monotone operation is compared when its own value is.
std::optional<TapeLinks::LevelStep> TapeLinks::levelStep(std::size_t instruction) const {
    LevelStep step;
    step.operation = whole_.instructions[instruction].operation;
    const auto isUniform = [&](std::size_t k) {
        const Value value = whole_.links[instruction].operands[k];
        return SimplifiedTape::isFixed(value) && (value & ~SimplifiedTape::fixed) >= tape_.firstUniform();
    };
    switch (step.operation) {
        case Operation::negate: return step;
        case Operation::add:
        case Operation::subtract:
        case Operation::multiply: step.uniformFirst = isUniform(0); [[fallthrough]];
        case Operation::divide: break;
        default: return std::nullopt;
    }
    const std::size_t other = step.uniformFirst ? 0 : 1;
    if (!isUniform(other)) return std::nullopt;
    step.uniform = whole_.links[instruction].operands[other] & ~SimplifiedTape::fixed;
    return step;
}

std::vector<SignLevel> TapeLinks::levels(const UniformValues& uniforms, double threshold) const {
    std::vector<SignLevel> levels{{}, {threshold, 0}};
    for (const LevelStep& step : levelSteps_) {
        const auto [value, reach] = levels[step.from];
        if (step.operation == Operation::negate) {
            levels.push_back({-value, reach});
            continue;
        }
        const double number = uniforms.of(tape_, step.uniform);
        // Roundings of the level, and those of the operation, whose products may underflow.
        constexpr double roundings = 4e-16, smallest = std::numeric_limits<double>::min();
        const double ofSum = reach + roundings * (std::abs(value) + reach + std::abs(number));
        const auto ofProduct = [](double product, double itsReach) {
            return SignLevel{product, itsReach + roundings * (std::abs(product) + itsReach) + smallest};
        };
        SignLevel level;
        switch (step.operation) {
            case Operation::add: level = {value - number, ofSum}; break;
            case Operation::subtract:
                level = {step.uniformFirst ? number - value : value + number, ofSum};
                break;
            case Operation::multiply:
                level = ofProduct(value / number, (reach + smallest) / std::abs(number));
                break;
            default: level = ofProduct(value * number, (reach + smallest) * std::abs(number));
        }
        // Nothing is beyond what is not known, as where a factor is 0.
        if (!std::isfinite(level.value) || !std::isfinite(level.reach))
            level = {0, std::numeric_limits<double>::infinity()};
        levels.push_back(level);
    }
    return levels;
}

}  // namespace isoscope
