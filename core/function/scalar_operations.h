// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <span>

#include "core/function/function_graph.h"

namespace isoscope {

/// The value of one operation at one point, with POV-Ray's semantics for NaN, infinities and 32-bit
/// conversions (docs/povray/operators.md). This is the reference that constant folding and every evaluator
/// agree with. Constants, variables, parameters and loops have no value of their own and are not allowed.
/// `operands` holds arity(operation) numbers; `crackle` is needed for Operation::crackle only.
double evaluateOperation(Operation operation, std::span<const double> operands,
                         const CrackleSettings* crackle = nullptr);

/// The gradient of crackle at a point: 0 where it is clipped, that of the nearest three distances elsewhere,
/// by central differences over `step` for what settings put in crackle's place and for `solid`. A component
/// that is not finite is 0.
std::array<double, 3> crackleGradient(const CrackleSettings& settings, const std::array<double, 3>& point,
                                      double step);

}  // namespace isoscope
