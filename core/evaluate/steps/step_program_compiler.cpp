// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/evaluate/steps/step_program_compiler.h"

#include <algorithm>

#include "core/evaluate/jumps/affine_cases.h"

namespace isoscope {

namespace {

bool hasStep(Operation operation) {
    switch (operation) {
        case Operation::negate:
        case Operation::absolute:
        case Operation::square:
        case Operation::add:
        case Operation::subtract:
        case Operation::multiply:
        case Operation::minimum:
        case Operation::maximum: return true;
        default: return false;
    }
}

/// Steps only for plain numbers.
bool hasPlainStep(Operation operation) {
    switch (operation) {
        case Operation::squareRoot:
        case Operation::divide: return true;
        default: return false;
    }
}

StepOperation unaryStep(Operation operation) {
    switch (operation) {
        case Operation::negate: return StepOperation::negate;
        case Operation::absolute: return StepOperation::absolute;
        case Operation::square: return StepOperation::square;
        default: return StepOperation::squareRoot;
    }
}

/// The step for `accumulator operation value`, or, reversed, for `value operation accumulator`.
StepOperation binaryStep(Operation operation, bool reversed) {
    switch (operation) {
        case Operation::add: return StepOperation::add;
        case Operation::subtract: return reversed ? StepOperation::subtractFrom : StepOperation::subtract;
        case Operation::multiply: return reversed ? StepOperation::multiplyInto : StepOperation::multiply;
        case Operation::divide: return reversed ? StepOperation::divideInto : StepOperation::divide;
        case Operation::minimum: return reversed ? StepOperation::minimumFrom : StepOperation::minimum;
        default: return reversed ? StepOperation::maximumFrom : StepOperation::maximum;
    }
}

/// How far an instruction looks for the reader of its value; a bound that keeps compiling linear.
constexpr std::uint32_t farthestReader = 16;
/// How long a copy of the accumulator may be kept from others.
constexpr std::uint32_t longestSaved = 32;
/// Reading two slots instead of one costs as much as storing their product, at so many readers.
constexpr std::uint32_t mostReadersOfProduct = 2;

}  // namespace

StepProgramCompiler::StepProgramCompiler(const Tape& tape, std::span<const Instruction> instructions,
                                         StepNumberKind numbers, std::vector<ProgramStep>& steps,
                                         std::vector<StepCode::Stretch>& stretches)
    : tape_(tape), instructions_(instructions), numbers_(numbers), steps_(steps), stretches_(stretches) {
    if (numbers == StepNumberKind::byCases) wholeNumbers_ = findWholeNumbers(tape, instructions);
}

void StepProgramCompiler::compile(std::span<const Slot> results) {
    findReaders(results);
    findDeferred();
    for (InstructionIndex place = 0; place < instructions_.size(); ++place) {
        if (!isStep(place))
            endStretch(instructions_.subspan(place, 1));
        else if (!values_[place].deferred)
            emit(place);
    }
    endStretch({});
}

bool StepProgramCompiler::isStep(InstructionIndex place) const {
    const Operation operation = instructions_[place].operation;
    if (!wholeNumbers_.empty() && wholeNumbers_[place]) return false;
    return hasStep(operation) || (numbers_ == StepNumberKind::plain && hasPlainStep(operation));
}

void StepProgramCompiler::findReaders(std::span<const Slot> results) {
    values_.assign(instructions_.size(), {});
    std::vector<InstructionIndex> writer(tape_.slotCount(), nowhere);
    std::uint32_t stretch = 0;
    for (InstructionIndex place = 0; place < instructions_.size(); ++place) {
        const Instruction& instruction = instructions_[place];
        for (std::size_t k = 0; k < instruction.operandCount; ++k) {
            values_[place].definitions[k] = writer[instruction.operands[k]];
            read(writer[instruction.operands[k]], place);
        }
        if (instruction.operation == Operation::sum || instruction.operation == Operation::product)
            for (const Slot slot : tape_.loop(instruction.index).captured) read(writer[slot], place);
        writer[instruction.target] = place;
        values_[place].stretch = stretch;
        if (!isStep(place)) ++stretch;
    }
    for (const Slot slot : results) read(writer[slot], nowhere);
}

void StepProgramCompiler::read(InstructionIndex place, InstructionIndex reader) {
    if (place == nowhere) return;
    Value& value = values_[place];
    ++value.readerCount;
    value.lastReader = reader;
    if (reader == nowhere || !isStep(reader)) {
        value.readBySteps = false;
        return;
    }
    const Operation operation = instructions_[reader].operation;
    if (operation == Operation::minimum || operation == Operation::maximum) value.readByChoices = true;
}

void StepProgramCompiler::findDeferred() {
    for (InstructionIndex place = 0; place < instructions_.size(); ++place) {
        const Term term = termOf(place);
        if (!term || !mayBeDeferred(place, term)) continue;
        values_[place].deferred = term;
        for (const InstructionIndex definition : values_[place].definitions)
            if (definition != nowhere) values_[definition].inMemory = true;
    }
}

/// The value as an operand of slots; none where it cannot be one.
StepProgramCompiler::Term StepProgramCompiler::termOf(InstructionIndex place) const {
    const Instruction& instruction = instructions_[place];
    const auto deferred = [&](int operand) {
        const InstructionIndex from = definition(place, operand);
        return from == nowhere ? Term{} : values_[from].deferred;
    };
    const auto [a, b] = std::pair(instruction.operands[0], instruction.operands[1]);
    if (instruction.operation == Operation::square)
        return tape_.isUniform(a) || deferred(0) ? Term{} : Term{StepOperand::square, a};
    if (instruction.operation != Operation::multiply || (tape_.isUniform(a) && tape_.isUniform(b))) return {};
    if (!tape_.isUniform(a) && !tape_.isUniform(b))
        return deferred(0) || deferred(1) ? Term{} : Term{StepOperand::product, a, b};
    const int factor = tape_.isUniform(a) ? 1 : 0;
    const Slot uniform = factor == 1 ? a : b;
    const Term inner = deferred(factor);
    if (!inner) return {StepOperand::scaled, factor == 1 ? b : a, uniform};
    return inner.operand == StepOperand::square ? Term{StepOperand::scaledSquare, inner.a, uniform} : Term{};
}

/// Whether readers of the value can compute it themselves, at less than it costs to store it and read it
/// again.
bool StepProgramCompiler::mayBeDeferred(InstructionIndex place, const Term& term) const {
    const Value& value = values_[place];
    if (!value.readBySteps) return false;
    if (numbers_ != StepNumberKind::plain && (value.readerCount > 1 || value.readByChoices)) return false;
    const auto lasts = [&](Slot slot) { return slot < tape_.firstReused() || slot == ProgramStep::unused; };
    if (lasts(term.a) && lasts(term.b))
        return term.operand != StepOperand::product || value.readerCount <= mostReadersOfProduct;
    return term.operand != StepOperand::scaledSquare && value.readerCount == 1 && staysComputable(place);
}

/// Whether the operands are in memory, and stay there until the only reader of their square or product.
bool StepProgramCompiler::staysComputable(InstructionIndex place) const {
    const Instruction& instruction = instructions_[place];
    const InstructionIndex reader = values_[place].lastReader;
    if (reader - place > farthestReader || values_[reader].stretch != values_[place].stretch) return false;
    // A value that is read here alone, or is just there, costs less through the accumulator.
    for (int k = 0; k < instruction.operandCount; ++k) {
        const InstructionIndex from = definition(place, k);
        if (from == nowhere) continue;
        if (values_[from].readerCount == 1) return false;
        if (place - from <= farthestReader && next(from) == place) return false;
    }
    for (InstructionIndex between = place + 1; between < reader; ++between)
        for (std::size_t k = 0; k < instruction.operandCount; ++k)
            if (instructions_[between].target == instruction.operands[k]) return false;
    return true;
}

/// The instruction that is emitted after `place`, in the same stretch.
StepProgramCompiler::InstructionIndex StepProgramCompiler::next(InstructionIndex place) const {
    do ++place;
    while (place < instructions_.size() && values_[place].deferred);
    return place < instructions_.size() && isStep(place) ? place : nowhere;
}

bool StepProgramCompiler::goesOnInAccumulator(InstructionIndex place) const {
    const Value& value = values_[place];
    return value.readBySteps && value.readerCount == 1 && value.lastReader == next(place);
}

void StepProgramCompiler::emit(InstructionIndex place) {
    const Instruction& instruction = instructions_[place];
    if (instruction.operandCount == 2) {
        emitBinary(place);
    } else if (isInAccumulator(place, 0) || !emitTermOf(place)) {
        if (!isInAccumulator(place, 0)) emitTerm(StepOperation::load, place, 0);
        emitStep(unaryStep(instruction.operation));
    }
    inAccumulator_ = place;
    if (!goesOnInAccumulator(place)) keep(place);
}

/// Puts the accumulator where later steps find it.
void StepProgramCompiler::keep(InstructionIndex place) {
    Value& value = values_[place];
    if (numbers_ == StepNumberKind::plain && value.readBySteps && !value.inMemory &&
        value.lastReader - place <= longestSaved && values_[value.lastReader].stretch == value.stretch)
        for (std::size_t k = 0; k < savedUntil_.size(); ++k) {
            if (savedUntil_[k] > place) continue;
            savedUntil_[k] = value.lastReader;
            value.copy = k == 0 ? StepOperand::saved0 : StepOperand::saved1;
            emitStep(k == 0 ? StepOperation::save0 : StepOperation::save1);
            return;
        }
    emitStep(StepOperation::store, {StepOperand::lanes, instructions_[place].target});
}

bool StepProgramCompiler::isInAccumulator(InstructionIndex place, int operand) const {
    return definition(place, operand) != nowhere && definition(place, operand) == inAccumulator_;
}

bool StepProgramCompiler::isInCopy(InstructionIndex place, int operand) const {
    return definition(place, operand) != nowhere &&
           values_[definition(place, operand)].copy != StepOperand::lanes;
}

void StepProgramCompiler::emitBinary(InstructionIndex place) {
    const Operation operation = instructions_[place].operation;
    if (isInAccumulator(place, 0)) return emitTerm(binaryStep(operation, false), place, 1);
    if (isInAccumulator(place, 1)) return emitTerm(binaryStep(operation, true), place, 0);
    if (emitTermOf(place)) return;
    // A uniform operand need not be spread.
    const std::array<Slot, 4>& operands = instructions_[place].operands;
    const int first = tape_.isUniform(operands[0]) && !tape_.isUniform(operands[1]) ? 1 : 0;
    emitTerm(StepOperation::load, place, first);
    emitTerm(binaryStep(operation, first == 1), place, 1 - first);
}

/// The instruction as one step, if it can be one with operands in memory.
bool StepProgramCompiler::emitTermOf(InstructionIndex place) {
    const Term term = termOf(place);
    if (!term || isInCopy(place, 0) || isInCopy(place, 1)) return false;
    emitStep(StepOperation::load, term);
    return true;
}

/// A step with an operand from memory, from a copy of the accumulator, or computed here.
void StepProgramCompiler::emitTerm(StepOperation operation, InstructionIndex place, int operand) {
    const InstructionIndex from = definition(place, operand);
    const Slot slot = instructions_[place].operands[static_cast<std::size_t>(operand)];
    if (from != nowhere && values_[from].deferred)
        emitStep(operation, values_[from].deferred);
    else if (isInCopy(place, operand))
        emitStep(operation, {values_[from].copy});
    else
        emitStep(operation, {tape_.isUniform(slot) ? StepOperand::uniform : StepOperand::lanes, slot});
}

void StepProgramCompiler::endStretch(std::span<const Instruction> instruction) {
    const auto end = static_cast<std::uint32_t>(steps_.size());
    inAccumulator_ = nowhere;
    if (firstStep_ < end) {
        emitStep(StepOperation::end);
    } else if (!instruction.empty() && !stretches_.empty()) {
        std::span<const Instruction>& before = stretches_.back().instructions;
        if (before.data() + before.size() == instruction.data()) {
            before = {before.data(), before.size() + 1};
            return;
        }
    }
    stretches_.push_back({firstStep_, end - firstStep_, instruction});
    firstStep_ = static_cast<std::uint32_t>(steps_.size());
}

}  // namespace isoscope
