// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/function/function_graph.h"

namespace isoscope {

/// Whose expressions a function is written in.
enum class FunctionNotation { povray, virtualight };

/// A function as an expression of that notation with these names for its arguments; parameters are written as
/// their values. Nothing when it calls for loops, noise, patterns or what the notation lacks
/// (OperationFacts::common), or gets longer than `functionLengthLimit`. Nodes in `named` are written as these
/// texts, the result itself apart.
std::optional<std::string> functionText(const Function& function, const std::vector<std::string>& arguments,
                                        std::span<const double> parameterTable,
                                        FunctionNotation notation = FunctionNotation::povray,
                                        const std::map<NodeId, std::string>& named = {});

constexpr std::size_t functionLengthLimit = 100'000;

}  // namespace isoscope
