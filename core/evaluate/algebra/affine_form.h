// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace isoscope {

/// One lane of an affine form a + b s + [-e, e]; e is not finite where nothing is known (+infinity, NaN) or
/// where there is certainly no value (-infinity).
struct AffineForm {
    double a = 0;
    double b = 0;
    double e = 0;
};

}  // namespace isoscope
