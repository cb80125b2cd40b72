// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/evaluate/tape/tape_links.h"

namespace isoscope {

namespace {

using Value = SimplifiedTape::Value;

SignDependence opposite(SignDependence dependence) {
    return static_cast<SignDependence>(-static_cast<int>(dependence));
}

}  // namespace

TapeLinks::TapeLinks(const Tape& tape) : tape_(tape) {
    linkWhole();
    findStakes();
    leastLength_ = countLeast();
}

/// Follows the values through the slots, which the tape uses again and again.
void TapeLinks::linkWhole() {
    whole_.instructions.assign(tape_.instructions().begin(), tape_.instructions().end());
    std::vector<Value> current(tape_.slotCount());
    for (Slot slot = 0; slot < current.size(); ++slot) current[slot] = SimplifiedTape::fixed | slot;
    for (std::uint32_t i = 0; i < whole_.instructions.size(); ++i) {
        const Instruction& instruction = whole_.instructions[i];
        SimplifiedTape::Link& link = whole_.links.emplace_back();
        for (std::size_t k = 0; k < instruction.operandCount; ++k)
            link.operands[k] = current[instruction.operands[k]];
        current[instruction.target] = i;
        if (!tape_.loops().empty() || !isChoice(instruction.operation)) continue;
        link.choice = static_cast<std::uint32_t>(whole_.dependences.size());
        whole_.dependences.push_back(SignDependence::value);
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

/// From the result backwards, along values that are used but once: another user might need all of them.
void TapeLinks::findStakes() {
    std::vector<int> uses(whole_.links.size());
    const auto use = [&](Value value) {
        if (!SimplifiedTape::isFixed(value)) ++uses[value];
    };
    for (const Value value : results_) use(value);
    for (std::size_t i = 0; i < whole_.links.size(); ++i)
        for (std::size_t k = 0; k < whole_.instructions[i].operandCount; ++k)
            use(whole_.links[i].operands[k]);
    std::vector<SignDependence> dependences(whole_.links.size(), SignDependence::value);
    const auto put = [&](Value value, SignDependence dependence) {
        if (!SimplifiedTape::isFixed(value) && uses[value] == 1) dependences[value] = dependence;
    };
    put(whole_.resultValue, SignDependence::sign);
    for (std::size_t i = whole_.links.size(); i-- > 0;) {
        if (dependences[i] == SignDependence::value) continue;
        const SimplifiedTape::Link& link = whole_.links[i];
        const Operation operation = whole_.instructions[i].operation;
        if (operation == Operation::negate) put(link.operands[0], opposite(dependences[i]));
        if (!isChoice(operation) || operation == Operation::absolute) continue;
        // Of a select's first operand it is another sign that counts.
        const std::size_t compared = isSelect(operation) ? 1 : 0;
        for (std::size_t k = compared; k < whole_.instructions[i].operandCount; ++k)
            put(link.operands[k], dependences[i]);
        if (!whole_.dependences.empty()) whole_.dependences[link.choice] = dependences[i];
    }
}

}  // namespace isoscope
