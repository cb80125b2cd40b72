// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <map>
#include <memory>
#include <unordered_map>
#include <vector>

#include "core/evaluate/tape/tape.h"

namespace isoscope {

/// Turns a function graph into a tape: marks what the results need, separates the uniform part, orders the
/// rest so that few values wait for others (operands that need most slots come first, after Sethi and
/// Ullman), and gives slots by a linear scan. Every pass is linear in the nodes and none recurses, except
/// into the bodies of loops.
class TapeCompiler {
  public:
    /// In the body of a loop, inner loops are never uniform: their allowance depends on the steps of the
    /// outer one.
    enum class Role { function, loopBody };

    TapeCompiler(const Function& function, Role role);

    /// The finished tape, which needs the function no longer. One call for each compiler.
    std::shared_ptr<const Tape> compile();

  private:
    void markNeeded();
    void findUniform();
    void extractUniforms();
    void copyUniform(FunctionGraph& target, NodeId id, std::vector<NodeId>& copies) const;
    void measureSlotNeeds();
    /// Nodes that are computed together with one: up to two, else noNode.
    using Partners = std::array<NodeId, 2>;
    void findPartners();
    Partners partnersOf(const Node& node) const;
    void order();
    void countUses();
    void emit(NodeId id);
    void emitLoop(NodeId id, Instruction& instruction);
    bool multipliesRanges() const;
    Slot takeSlot();
    void release(NodeId operand);
    bool varying(NodeId id) const;

    const Function& function_;
    const FunctionGraph& graph_;
    Role role_;
    std::shared_ptr<Tape> tape_;
    NodeId last_ = 0;  ///< nodes above it are not needed
    std::vector<bool> needed_;
    std::vector<bool> uniform_;
    std::vector<std::uint32_t> slotNeed_;
    std::unordered_map<NodeId, NodeId> sines_, cosines_;                   ///< by their angle
    std::map<std::array<NodeId, 3>, std::array<NodeId, 3>> vectorNoises_;  ///< by their place: x, y, z
    std::vector<NodeId> order_;
    std::vector<std::uint32_t> uses_;  ///< by instructions still to be emitted, and by results
    std::vector<Slot> slotOf_;
    std::vector<Slot> freeSlots_;
};

}  // namespace isoscope
