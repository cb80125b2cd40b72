// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/evaluate/point_program_compiler.h"

#include <algorithm>

namespace isoscope {

namespace {

bool isPlain(Operation operation) {
    switch (operation) {
        case Operation::negate:
        case Operation::absolute:
        case Operation::square:
        case Operation::squareRoot:
        case Operation::add:
        case Operation::subtract:
        case Operation::multiply:
        case Operation::divide:
        case Operation::minimum:
        case Operation::maximum: return true;
        default: return false;
    }
}

bool isSumOrDifference(Operation operation) {
    return operation == Operation::add || operation == Operation::subtract;
}

PointCode unaryCode(Operation operation) {
    switch (operation) {
        case Operation::negate: return PointCode::negate;
        case Operation::absolute: return PointCode::absolute;
        case Operation::square: return PointCode::square;
        default: return PointCode::squareRoot;
    }
}

/// The code of `accumulator operation value`, or, reversed, of `value operation accumulator`.
PointCode binaryCode(Operation operation, bool reversed) {
    switch (operation) {
        case Operation::add: return PointCode::add;
        case Operation::subtract: return reversed ? PointCode::subtractFrom : PointCode::subtract;
        case Operation::multiply: return PointCode::multiply;
        case Operation::divide: return reversed ? PointCode::divideInto : PointCode::divide;
        case Operation::minimum: return reversed ? PointCode::minimumFrom : PointCode::minimum;
        default: return reversed ? PointCode::maximumFrom : PointCode::maximum;
    }
}

bool isSumCode(PointCode code) { return code < PointCode::multiply; }
PointCode shifted(PointCode code, int by) { return static_cast<PointCode>(static_cast<int>(code) + by); }

/// How far an instruction looks for the reader of its value; a bound that keeps compiling linear.
constexpr std::uint32_t farthestReader = 16;

}  // namespace

PointProgramCompiler::PointProgramCompiler(const Tape& tape, std::vector<PointStep>& steps,
                                           std::vector<PointProgram::Stretch>& stretches)
    : tape_(tape), instructions_(tape.instructions()), steps_(steps), stretches_(stretches) {}

void PointProgramCompiler::compile() {
    findReaders();
    findDeferred();
    for (Place place = 0; place < instructions_.size(); ++place) {
        if (!isPlain(instructions_[place].operation))
            endStretch(instructions_.subspan(place, 1));
        else if (!deferred_[place])
            emit(place);
    }
    endStretch({});
}

void PointProgramCompiler::findReaders() {
    const std::size_t count = instructions_.size();
    definitions_.assign(count, {nowhere, nowhere, nowhere, nowhere});
    readerCount_.assign(count, 0);
    lastReader_.assign(count, nowhere);
    readBySums_.assign(count, true);
    std::vector<Place> writer(tape_.slotCount(), nowhere);
    const auto read = [&](Slot slot, Place reader) {
        const Place place = writer[slot];
        if (place == nowhere) return place;
        ++readerCount_[place];
        lastReader_[place] = reader;
        if (reader == nowhere || !isSumOrDifference(instructions_[reader].operation))
            readBySums_[place] = false;
        return place;
    };
    for (Place place = 0; place < count; ++place) {
        const Instruction& instruction = instructions_[place];
        for (int k = 0; k < instruction.operandCount; ++k)
            definitions_[place][k] = read(instruction.operands[k], place);
        if (instruction.operation == Operation::sum || instruction.operation == Operation::product)
            for (const Slot slot : tape_.loop(instruction.index).captured) read(slot, place);
        writer[instruction.target] = place;
    }
    for (const Slot slot : tape_.results()) read(slot, nowhere);
}

void PointProgramCompiler::findDeferred() {
    deferred_.assign(instructions_.size(), false);
    for (Place place = 0; place < instructions_.size(); ++place) deferred_[place] = mayBeDeferred(place);
}

/// Whether the value is a square or a product that later sums can compute themselves, at less than it costs
/// to store it and read it again.
bool PointProgramCompiler::mayBeDeferred(Place place) const {
    const Instruction& instruction = instructions_[place];
    const auto operands = std::span(instruction.operands).first(instruction.operandCount);
    if (instruction.operation != Operation::square && instruction.operation != Operation::multiply)
        return false;
    if (!readBySums_[place] ||
        std::ranges::all_of(operands, [&](Slot slot) { return tape_.isUniform(slot); }))
        return false;
    const bool lasting = std::ranges::all_of(operands, [&](Slot slot) { return slot < tape_.firstReused(); });
    return lasting ? readerCount_[place] <= 2 : readerCount_[place] == 1 && staysComputable(place);
}

/// Whether the operands are in memory, and stay there until the only reader of their square or product.
bool PointProgramCompiler::staysComputable(Place place) const {
    const Instruction& instruction = instructions_[place];
    const Place reader = lastReader_[place];
    if (reader - place > farthestReader) return false;
    // A value that is read here alone had better come through the accumulator.
    for (int k = 0; k < instruction.operandCount; ++k)
        if (definition(place, k) != nowhere && readerCount_[definition(place, k)] == 1) return false;
    for (Place between = place + 1; between < reader; ++between) {
        if (!isPlain(instructions_[between].operation)) return false;
        for (int k = 0; k < instruction.operandCount; ++k)
            if (instructions_[between].target == instruction.operands[k]) return false;
    }
    return true;
}

/// The instruction that is emitted after `place`, in the same stretch.
PointProgramCompiler::Place PointProgramCompiler::next(Place place) const {
    do ++place;
    while (place < instructions_.size() && deferred_[place]);
    return place < instructions_.size() && isPlain(instructions_[place].operation) ? place : nowhere;
}

bool PointProgramCompiler::goesOnInAccumulator(Place place) const {
    return readerCount_[place] == 1 && lastReader_[place] != nowhere && lastReader_[place] == next(place);
}

void PointProgramCompiler::emit(Place place) {
    const Instruction& instruction = instructions_[place];
    if (instruction.operandCount == 2) {
        emitBinary(place);
    } else if (isInAccumulator(place, 0)) {
        emitStep(unaryCode(instruction.operation));
    } else if (instruction.operation == Operation::square && !tape_.isUniform(instruction.operands[0])) {
        emitStep(PointCode::loadSquare, instruction.operands[0]);
    } else {
        emitTerm(PointCode::load, place, 0);
        emitStep(unaryCode(instruction.operation));
    }
    inAccumulator_ = place;
    if (!goesOnInAccumulator(place)) emitStep(PointCode::store, instruction.target);
}

bool PointProgramCompiler::isInAccumulator(Place place, int operand) const {
    return definition(place, operand) != nowhere && definition(place, operand) == inAccumulator_;
}

void PointProgramCompiler::emitBinary(Place place) {
    const Operation operation = instructions_[place].operation;
    if (isInAccumulator(place, 0)) return emitTerm(binaryCode(operation, false), place, 1);
    if (isInAccumulator(place, 1)) return emitTerm(binaryCode(operation, true), place, 0);
    if (operation == Operation::multiply && emitProduct(PointCode::load, instructions_[place])) return;
    emitTerm(PointCode::load, place, 0);
    emitTerm(binaryCode(operation, false), place, 1);
}

/// A step with an operand from memory, or with the square or product that was deferred to here.
void PointProgramCompiler::emitTerm(PointCode plain, Place place, int operand) {
    const Place from = definition(place, operand);
    const Slot slot = instructions_[place].operands[operand];
    if (from != nowhere && deferred_[from]) {
        if (instructions_[from].operation == Operation::square)
            emitStep(shifted(plain, 1), instructions_[from].operands[0]);
        else
            emitProduct(plain, instructions_[from]);
    } else if (tape_.isUniform(slot)) {
        emitStep(shifted(plain, isSumCode(plain) ? 4 : 1), slot);
    } else {
        emitStep(plain, slot);
    }
}

/// A step of a sum with a product. False for the product of two uniform slots, which has no code.
bool PointProgramCompiler::emitProduct(PointCode plain, const Instruction& product) {
    const auto [a, b] = std::pair(product.operands[0], product.operands[1]);
    if (tape_.isUniform(a) && tape_.isUniform(b)) return false;
    if (tape_.isUniform(a))
        emitStep(shifted(plain, 3), b, a);
    else
        emitStep(shifted(plain, tape_.isUniform(b) ? 3 : 2), a, b);
    return true;
}

void PointProgramCompiler::endStretch(std::span<const Instruction> instruction) {
    const auto end = static_cast<std::uint32_t>(steps_.size());
    inAccumulator_ = nowhere;
    if (!instruction.empty() && firstStep_ == end && !stretches_.empty()) {
        std::span<const Instruction>& before = stretches_.back().instructions;
        if (before.data() + before.size() == instruction.data()) {
            before = {before.data(), before.size() + 1};
            return;
        }
    }
    stretches_.push_back({firstStep_, end - firstStep_, instruction});
    firstStep_ = end;
}

}  // namespace isoscope
