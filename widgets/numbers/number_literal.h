// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string_view>

namespace isoscope {

/// A number as it stands in a scene text, bytes [begin, end) with a sign where that belongs to the number.
struct NumberLiteral {
    int begin = 0;
    int end = 0;
    double value = 0;
    int decimals = 0;  ///< places of its last digit behind the point, the exponent counted in: 1.5e-3 has 4

    /// One in the last place: how far one step of scrubbing goes. At least 1e-12.
    double step() const;
};

/// The number that the byte at `position` belongs to, or that ends there. A minus counts where no value can
/// stand before it
/// (`(-1`, `,-1`, `* -1`, `threshold -1`), not in `x-1`. Digits of names (`P0`) are none. Only the line of
/// `position` is looked at; the caller knows about comments and strings.
std::optional<NumberLiteral> numberAt(std::string_view text, int position);

}  // namespace isoscope
