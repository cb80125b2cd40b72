// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/function/operation.h"

namespace isoscope {

/// Whether SlopeAlgebra and TaylorAlgebra have a rule for the operation, noise aside.
constexpr bool hasSlopeRule(Operation operation) {
#define ISOSCOPE_CASE(sloped) case Operation::sloped:
    switch (operation) {
        ISOSCOPE_SLOPED_OPERATIONS(ISOSCOPE_CASE, ISOSCOPE_CASE)
        return true;
        default: return false;
    }
#undef ISOSCOPE_CASE
}

}  // namespace isoscope
