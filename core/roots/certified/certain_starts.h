// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>

#include "core/numeric/aligned_column.h"
#include "core/numeric/fill_numbers.h"
#include "core/roots/line_columns.h"

namespace isoscope {

/// What is certain about the beginning of a line: f - threshold has the sign `sign` (1 or -1, negative
/// inside) from the line's near to `start`. Nothing when sign is 0.
struct CertainStart {
    double start = 0;
    double sign = 0;
    double length = 0;  ///< of a piece worth trying next
};

/// The certain beginnings of many lines, in columns with LineColumns::padding.
class CertainStarts {
  public:
    CertainStarts() = default;
    explicit CertainStarts(std::size_t lines) { reset(lines); }

    /// Nothing is certain about any of so many lines.
    void reset(std::size_t lines) {
        const std::size_t room = lines + LineColumns::padding;
        if (sign_.size() < room)
            for (AlignedColumn* column : {&start_, &sign_, &length_})
                column->resize(roomier(lines) + LineColumns::padding);
        fillNumbers(sign_.data(), room, 0);
    }

    CertainStart operator[](std::size_t line) const {
        if (sign_[line] == 0) return {};
        return {start_[line], sign_[line], length_[line]};
    }
    /// Makes `value` what is certain of lines [first, first + count), which must be among those of reset().
    void set(std::size_t first, std::size_t count, const CertainStart& value) {
        for (std::size_t k = first; k < first + count; ++k)
            start_[k] = value.start, sign_[k] = value.sign, length_[k] = value.length;
    }

    /// Whether some of `count` lines from `first` on have an interval that is not empty, and none of them is
    /// certain to its end.
    bool open(const LineColumns& lines, std::size_t first, std::size_t count) const;

    /// The columns, as in CertainStart; start and length mean nothing where sign is 0. Valid until reset().
    const double* start() const { return start_.data(); }
    double* start() { return start_.data(); }
    const double* sign() const { return sign_.data(); }
    const double* length() const { return length_.data(); }

  private:
    /// Lists of some length mostly grow: new memory every time would take as much again, and its first touch
    /// has its price.
    static std::size_t roomier(std::size_t lines) {
        return lines < 256 ? lines : (lines + 1023) / 1024 * 1024;
    }

    AlignedColumn start_, sign_, length_;
};

}  // namespace isoscope
