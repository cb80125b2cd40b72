// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/evaluate/tape/tape_compiler.h"

#include <algorithm>
#include <limits>
#include <span>

#include "core/function/graph_copy.h"

namespace isoscope {

namespace {

constexpr Slot noSlot = std::numeric_limits<Slot>::max();

bool isLoop(Operation operation) { return operation == Operation::sum || operation == Operation::product; }

/// Whether an operation keeps its values within limits of its own and comes from one to the other again and
/// again, or all at once. (Sines do so, too, but pieces are hardly ever as long as their waves.)
bool hasRange(Operation operation) {
    switch (operation) {
        case Operation::arcTangent2:
        case Operation::fraction:
        case Operation::triangleWave:
        case Operation::remainder:
        case Operation::noise:
        case Operation::noiseGradientX:
        case Operation::noiseGradientY:
        case Operation::noiseGradientZ:
        case Operation::crackle: return true;
        default: return false;
    }
}

/// Calls visit(operand) for every operand of a node, captured values included.
template <class Visit>
void forEachOperand(const FunctionGraph& graph, const Node& node, Visit visit) {
    for (const NodeId operand : node.operands)
        if (operand != noNode) visit(operand);
    for (const NodeId operand : graph.captured(node)) visit(operand);
}

/// Where a vector noise is taken.
std::array<NodeId, 3> placeOf(const Node& node) {
    return {node.operands[0], node.operands[1], node.operands[2]};
}

}  // namespace

TapeCompiler::TapeCompiler(const Function& function, Role role)
    : function_(function), graph_(*function.graph), role_(role), tape_(std::make_shared<Tape>()) {
    last_ = *std::max_element(function.results.begin(), function.results.end());
    slotOf_.assign(last_ + 1, noSlot);
}

std::shared_ptr<const Tape> TapeCompiler::compile() {
    tape_->argumentCount_ = function_.argumentCount;
    markNeeded();
    findUniform();
    extractUniforms();
    measureSlotNeeds();
    order();
    countUses();
    tape_->slotCount_ = tape_->firstReused();
    for (const NodeId id : order_) emit(id);
    for (const NodeId result : function_.results) tape_->results_.push_back(slotOf_[result]);
    tape_->multipliesRanges_ = multipliesRanges();
    return std::move(tape_);
}

bool TapeCompiler::multipliesRanges() const {
    std::vector<bool> isRange(tape_->slotCount_, false);
    for (const Instruction& instruction : tape_->instructions_) {
        const auto operands = std::span(instruction.operands).first(instruction.operandCount);
        const bool ofRange = std::ranges::any_of(operands, [&](Slot slot) { return isRange[slot]; });
        const bool isSquare = instruction.operation == Operation::square;
        const bool isProduct =
            instruction.operation == Operation::multiply &&
            std::ranges::none_of(operands, [&](Slot slot) { return tape_->isUniform(slot); });
        if (isLoop(instruction.operation) || (ofRange && (isSquare || isProduct))) return true;
        isRange[instruction.target] = ofRange || hasRange(instruction.operation);
    }
    return false;
}

void TapeCompiler::markNeeded() {
    needed_.assign(last_ + 1, false);
    for (const NodeId result : function_.results) needed_[result] = true;
    for (NodeId id = last_ + 1; id-- > 0;)
        if (needed_[id]) forEachOperand(graph_, graph_[id], [&](NodeId operand) { needed_[operand] = true; });
}

void TapeCompiler::findUniform() {
    uniform_.assign(last_ + 1, false);
    for (NodeId id = 0; id <= last_; ++id) {
        const Node& node = graph_[id];
        // A variable beyond the arguments reads 0, as in the reference.
        if (node.operation == Operation::variable) {
            const bool exists = node.index < static_cast<std::uint32_t>(function_.argumentCount);
            uniform_[id] = !exists;
            if (exists) slotOf_[id] = node.index;
            continue;
        }
        bool uniform = role_ == Role::function || !isLoop(node.operation);
        forEachOperand(graph_, node, [&](NodeId operand) { uniform = uniform && uniform_[operand]; });
        uniform_[id] = uniform;
    }
}

bool TapeCompiler::varying(NodeId id) const {
    return !uniform_[id] && graph_[id].operation != Operation::variable;
}

void TapeCompiler::extractUniforms() {
    std::vector<bool> read(last_ + 1, false);
    for (const NodeId result : function_.results) read[result] = true;
    for (NodeId id = 0; id <= last_; ++id)
        if (needed_[id] && varying(id))
            forEachOperand(graph_, graph_[id], [&](NodeId operand) { read[operand] = true; });

    FunctionGraph uniforms;
    std::vector<NodeId> copies(last_ + 1, noNode);
    std::vector<NodeId> results;
    for (NodeId id = 0; id <= last_; ++id) {
        if (!needed_[id] || !uniform_[id]) continue;
        copyUniform(uniforms, id, copies);
        if (!read[id]) continue;
        slotOf_[id] = tape_->firstUniform() + static_cast<Slot>(results.size());
        results.push_back(copies[id]);
    }
    tape_->uniformCount_ = static_cast<std::uint32_t>(results.size());
    tape_->uniformFunction_ = finish(std::move(uniforms), std::move(results), 0);
}

void TapeCompiler::copyUniform(FunctionGraph& target, NodeId id, std::vector<NodeId>& copies) const {
    const Node& node = graph_[id];
    const auto operand = [&](std::size_t k) { return copies[node.operands[k]]; };
    switch (node.operation) {
        case Operation::constant: copies[id] = target.constant(node.value); return;
        case Operation::variable: copies[id] = target.constant(0); return;
        case Operation::parameter: copies[id] = target.parameter(static_cast<int>(node.index)); return;
        case Operation::crackle:
            copies[id] =
                target.crackle(graph_.crackleSettings(node.index), operand(0), operand(1), operand(2));
            return;
        case Operation::sum:
        case Operation::product: {
            std::vector<NodeId> captured;
            for (const NodeId value : graph_.captured(node)) captured.push_back(copies[value]);
            copies[id] =
                target.loop(node.operation, operand(0), operand(1), graph_.loopBody(node.index), captured);
            return;
        }
        default: break;
    }
    std::array<NodeId, 4> operands{};
    const auto count = static_cast<std::size_t>(arity(node.operation));
    for (std::size_t k = 0; k < count; ++k) operands[k] = operand(k);
    copies[id] = operationNode(target, node.operation, std::span(operands).first(count));
}

void TapeCompiler::measureSlotNeeds() {
    slotNeed_.assign(last_ + 1, 0);
    std::vector<std::uint32_t> needs;
    for (NodeId id = 0; id <= last_; ++id) {
        if (!needed_[id] || !varying(id)) continue;
        needs.clear();
        forEachOperand(graph_, graph_[id], [&](NodeId operand) { needs.push_back(slotNeed_[operand]); });
        std::sort(needs.begin(), needs.end(), std::greater<>());
        std::uint32_t need = 1;
        for (std::uint32_t k = 0; k < needs.size(); ++k)
            if (needs[k] > 0) need = std::max(need, needs[k] + k);
        slotNeed_[id] = need;
    }
}

void TapeCompiler::findPartners() {
    constexpr std::array none{noNode, noNode, noNode};
    for (NodeId id = 0; id <= last_; ++id) {
        const Node& node = graph_[id];
        if (!needed_[id] || !varying(id)) continue;
        if (node.operation == Operation::sine) sines_[node.operands[0]] = id;
        if (node.operation == Operation::cosine) cosines_[node.operands[0]] = id;
        if (isVectorNoise(node.operation))
            vectorNoises_.try_emplace(placeOf(node), none)
                .first->second[static_cast<std::size_t>(noiseComponent(node.operation))] = id;
    }
}

/// The cosine of the angle whose sine the node is, or the other way round, and the other components of a
/// vector noise, as far as they are needed.
TapeCompiler::Partners TapeCompiler::partnersOf(const Node& node) const {
    if (isVectorNoise(node.operation)) {
        const std::array<NodeId, 3>& components = vectorNoises_.at(placeOf(node));
        const auto own = static_cast<std::size_t>(noiseComponent(node.operation));
        return {components[(own + 1) % 3], components[(own + 2) % 3]};
    }
    if (node.operation != Operation::sine && node.operation != Operation::cosine) return {noNode, noNode};
    const auto& partners = node.operation == Operation::sine ? cosines_ : sines_;
    const auto found = partners.find(node.operands[0]);
    return {found == partners.end() ? noNode : found->second, noNode};
}

/// Operands first, and of those what needs most slots; partners side by side, so that evaluators can compute
/// them together.
void TapeCompiler::order() {
    findPartners();
    struct Visit {
        NodeId id;
        bool operandsDone;
    };
    std::vector<bool> done(last_ + 1, false);
    std::vector<Visit> stack;
    std::vector<NodeId> operands;
    for (const NodeId result : function_.results) {
        stack.push_back({result, false});
        while (!stack.empty()) {
            const auto [id, operandsDone] = stack.back();
            stack.pop_back();
            if (done[id] || !varying(id)) continue;
            if (operandsDone) {
                const auto [partner, other] = partnersOf(graph_[id]);
                for (const NodeId ready : {id, partner, other}) {
                    if (ready == noNode || done[ready]) continue;
                    done[ready] = true;
                    order_.push_back(ready);
                }
                continue;
            }
            stack.push_back({id, true});
            operands.clear();
            forEachOperand(graph_, graph_[id], [&](NodeId operand) { operands.push_back(operand); });
            // The last pushed comes first: the one that needs most slots.
            std::stable_sort(operands.begin(), operands.end(),
                             [&](NodeId a, NodeId b) { return slotNeed_[a] < slotNeed_[b]; });
            for (const NodeId operand : operands) stack.push_back({operand, false});
        }
    }
}

void TapeCompiler::countUses() {
    uses_.assign(last_ + 1, 0);
    for (const NodeId id : order_)
        forEachOperand(graph_, graph_[id], [&](NodeId operand) { ++uses_[operand]; });
    for (const NodeId result : function_.results) ++uses_[result];
}

Slot TapeCompiler::takeSlot() {
    if (freeSlots_.empty()) return tape_->slotCount_++;
    const Slot slot = freeSlots_.back();
    freeSlots_.pop_back();
    return slot;
}

void TapeCompiler::release(NodeId operand) {
    if (--uses_[operand] == 0 && varying(operand)) freeSlots_.push_back(slotOf_[operand]);
}

void TapeCompiler::emit(NodeId id) {
    const Node& node = graph_[id];
    Instruction instruction;
    instruction.operation = node.operation;
    for (const NodeId operand : node.operands)
        if (operand != noNode) instruction.operands[instruction.operandCount++] = slotOf_[operand];
    if (isLoop(node.operation)) {
        emitLoop(id, instruction);
    } else {
        if (node.operation == Operation::crackle) {
            instruction.index = static_cast<std::uint32_t>(tape_->crackles_.size());
            tape_->crackles_.push_back(graph_.crackleSettings(node.index));
        }
        forEachOperand(graph_, node, [&](NodeId operand) { release(operand); });
        slotOf_[id] = takeSlot();
    }
    instruction.target = slotOf_[id];
    instruction.number = static_cast<std::uint32_t>(tape_->instructions_.size());
    tape_->instructions_.push_back(instruction);
}

void TapeCompiler::emitLoop(NodeId id, Instruction& instruction) {
    const Node& node = graph_[id];
    instruction.index = static_cast<std::uint32_t>(tape_->loops_.size());
    TapeLoop loop;
    loop.body = TapeCompiler(graph_.loopBody(node.index), Role::loopBody).compile();
    for (const NodeId operand : graph_.captured(node)) loop.captured.push_back(slotOf_[operand]);
    tape_->loops_.push_back(std::move(loop));
    // The bounds and captured values are read while the total grows, so the target is a slot of its own.
    slotOf_[id] = takeSlot();
    forEachOperand(graph_, node, [&](NodeId operand) { release(operand); });
}

}  // namespace isoscope
