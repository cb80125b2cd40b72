// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/evaluate/tape/tape_function.h"

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

#include "core/function/graph_copy.h"

namespace isoscope {

Function functionOf(const Tape& tape, std::span<const double> uniforms, const TapeStandIns& standIns,
                    std::optional<std::size_t> instruction) {
    FunctionGraph graph;
    std::vector<NodeId> slots(tape.slotCount(), noNode);
    for (std::size_t k = 0; k < static_cast<std::size_t>(tape.argumentCount()); ++k)
        slots[k] = k < 3 ? standIns.coordinate(graph, k) : graph.constant(0);
    for (std::size_t k = 0; k < uniforms.size(); ++k)
        slots[tape.firstUniform() + k] = graph.constant(uniforms[k]);
    const auto& all = tape.instructions();
    const std::size_t last = instruction.value_or(all.size() - 1);
    for (std::size_t i = 0; i < all.size() && i <= last; ++i) {
        std::array<NodeId, 4> nodes{};
        for (std::size_t k = 0; k < all[i].operandCount; ++k) nodes[k] = slots[all[i].operands[k]];
        const auto operands = std::span(nodes).first(all[i].operandCount);
        NodeId& target = slots[all[i].target];
        if (const NodeId replaced = standIns.instruction(graph, i); replaced != noNode)
            target = replaced;
        else if (std::ranges::find(operands, noNode) != operands.end())
            target = noNode;
        else if (all[i].operation == Operation::crackle)
            target = graph.crackle(tape.crackle(all[i].index), operands[0], operands[1], operands[2]);
        else
            target = operationNode(graph, all[i].operation, operands);
    }
    const NodeId result = slots[instruction ? all[*instruction].target : tape.results()[0]];
    return finish(std::move(graph), {result}, 3);
}

}  // namespace isoscope
