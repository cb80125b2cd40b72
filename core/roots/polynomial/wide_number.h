// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace isoscope {

/// A binary floating-point number with at least 113 bits where the compiler has one.
#ifdef __SIZEOF_FLOAT128__
using Wide = __float128;
#else
using Wide = long double;
#endif

/// Square root to the full width; NaN below 0.
Wide squareRoot(Wide a);

}  // namespace isoscope
