// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/roots/polynomial/wide_number.h"

namespace isoscope {

/// The real roots, in no order and possibly twice, of a polynomial of degree 1 to 4 given highest power first
/// with a leading coefficient that is not 0: the quadratic formula without cancellation, Vieta's
/// trigonometric and Cardano's form for degree 3, Ferrari's resolvent for degree 4, each root then polished
/// by Newton's method. Double roots may be missed or found by rounding.
std::vector<Wide> closedFormRoots(const std::vector<Wide>& polynomial);

}  // namespace isoscope
