// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>

#include "core/function/builtins/formula_blocks.h"

namespace isoscope {

/// What a formula is applied to: the point, the extra parameters P0, P1, ... and the scene's noise generator.
struct BuiltinCall {
    Expression x, y, z;
    std::span<const Expression> p;
    int noiseGenerator = 2;
};

using Formula = Expression (*)(const BuiltinCall& call);

/// A formula with the number by which internal(n) knows it.
struct NumberedFormula {
    int id;
    Formula formula;
};

/// The formulas of docs/povray/functions.md by family. Each keeps the written order of operations, because
/// POV-Ray's last bit depends on it.
std::span<const NumberedFormula> latheFormulas();
std::span<const NumberedFormula> algebraicFormulas();
std::span<const NumberedFormula> shapedFormulas();
std::span<const NumberedFormula> gaussianFormulas();
std::span<const NumberedFormula> distanceFormulas();
std::span<const NumberedFormula> helicalFormulas();
std::span<const NumberedFormula> fractalFormulas();

}  // namespace isoscope
