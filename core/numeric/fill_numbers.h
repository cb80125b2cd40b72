// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>

namespace isoscope {

/// std::fill_n, but whole vectors at a time.
void fillNumbers(double* to, std::size_t count, double number);

}  // namespace isoscope
