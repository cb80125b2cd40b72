// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <mpfr.h>

#include <deque>
#include <span>

#include "core/function/function_graph.h"

namespace isoscope::test {

/// A number of 200 bits.
class ExactNumber {
  public:
    ExactNumber() { mpfr_init2(value_, 200); }
    explicit ExactNumber(double value) : ExactNumber() { mpfr_set_d(value_, value, MPFR_RNDN); }
    ExactNumber(const ExactNumber& other) : ExactNumber() { mpfr_set(value_, other.value_, MPFR_RNDN); }
    ExactNumber& operator=(const ExactNumber& other) {
        mpfr_set(value_, other.value_, MPFR_RNDN);
        return *this;
    }
    ~ExactNumber() { mpfr_clear(value_); }

    mpfr_ptr get() { return value_; }
    mpfr_srcptr get() const { return value_; }
    double rounded() const { return mpfr_get_d(value_, MPFR_RNDN); }
    bool isNan() const { return mpfr_nan_p(value_) != 0; }
    bool isFinite() const { return mpfr_number_p(value_) != 0; }
    bool isNegative() const { return mpfr_cmp_si(value_, 0) < 0; }

  private:
    mpfr_t value_;
};

/// One operation at 200 bits. Noise is taken in doubles at the rounded
/// coordinates and from there along its slope, crackle at the rounded coordinates.
ExactNumber evaluateExactly(Operation operation, std::span<const ExactNumber> operands,
                            const CrackleSettings* crackle);

/// A function without loops at a point of 200 bits. `regular` becomes false when an intermediate value was
/// infinite, or beyond 2^5000 or below 2^-5000: such a point lies outside real arithmetic.
ExactNumber evaluateExactly(const Function& function, std::span<const ExactNumber> arguments,
                            std::span<const double> parameters, bool& regular);

}  // namespace isoscope::test
