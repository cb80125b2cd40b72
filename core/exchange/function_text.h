// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/function/function_graph.h"

namespace isoscope {

/// A function as an expression of POV-Ray's language with these names for its arguments; parameters are
/// written as their values. Nothing when it calls for loops, noise or patterns, or gets longer than
/// `lengthLimit`.
std::optional<std::string> functionText(const Function& function, const std::vector<std::string>& arguments,
                                        std::span<const double> parameterTable);

constexpr std::size_t functionLengthLimit = 100'000;

}  // namespace isoscope
