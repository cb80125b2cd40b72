// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "core/function/function_graph.h"

namespace isoscope {

/// Copies a function into another graph, with other nodes for its leaves.
struct GraphCopy {
    /// What stands for a variable; needed where the function has one.
    std::function<NodeId(std::uint32_t index)> variable;
    /// What stands for a parameter; empty: the same parameter.
    std::function<NodeId(std::uint32_t slot)> parameter;
    /// What stands for the body of a loop, which may capture more values; empty: the same body.
    std::function<Function(const Function& body, std::vector<NodeId>& captured)> body;

    /// The copy of result number `result`; the last node of an overflowed graph.
    NodeId into(FunctionGraph& graph, const Function& source, std::size_t result = 0) const;
};

/// The operation on as many operands as it takes (arity()). Not for leaves, crackle and loops.
NodeId operationNode(FunctionGraph& graph, Operation operation, std::span<const NodeId> operands);

/// Which nodes a result needs, itself included, by their numbers.
std::vector<bool> neededNodes(const FunctionGraph& graph, NodeId result);

/// The slots of the parameters that results of the function depend on, bodies of loops included; ascending.
std::vector<int> parameterSlots(const Function& function);

/// The first result of the function with one more argument, the last, in the place of the parameter: what is
/// proven over a range of that argument holds for all values of the parameter. Not valid() for a function
/// that becomes too large.
Function withFreeParameter(const Function& function, int slot);

}  // namespace isoscope
