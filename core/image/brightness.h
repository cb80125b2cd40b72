// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace isoscope {

/// How bright a colour is, by POV-Ray's weights, in the precision of Weight. Value is a number, or anything
/// else that can be multiplied by one and added.
template <class Weight = double, class Value>
Value brightness(const Value& red, const Value& green, const Value& blue) {
    return Weight(0.297) * red + Weight(0.589) * green + Weight(0.114) * blue;
}

}  // namespace isoscope
