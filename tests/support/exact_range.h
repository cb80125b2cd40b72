// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>

#include "tests/support/exact_evaluator.h"

namespace isoscope::test {

/// All numbers between two of 200 bits, infinite ones allowed. Written for checks: it shares nothing with
/// core/evaluate.
struct ExactRange {
    ExactNumber low, high;
    bool maybeUndefined = false;

    ExactRange() = default;
    explicit ExactRange(double value);
    ExactRange(const ExactNumber& least, const ExactNumber& most) : low(least), high(most) {}

    /// All numbers.
    static ExactRange all();
    bool holds(double value) const;
    bool isPoint() const { return mpfr_equal_p(low.get(), high.get()) != 0; }
    bool isBounded() const { return low.isFinite() && high.isFinite(); }
    bool isPositive() const { return mpfr_cmp_si(low.get(), 0) > 0; }
    bool isNegative() const { return mpfr_cmp_si(high.get(), 0) < 0; }
};

/// A function of t over a range of t: its values and, where `isSloped`, those of its derivative; then the
/// function is continuous there, with a derivative but for kinks.
struct ExactJet {
    ExactRange value, slope;
    bool isSloped = false;

    static ExactJet constant(double value);
};

/// Whether enclose() has a rule for it: all but noise, crackle and loops.
bool hasExactRule(Operation operation);

/// What an operation makes of what its operands hold: outward rounded at 200 bits, with the semantics of
/// evaluateOperation() in real numbers.
ExactJet enclose(Operation operation, std::span<const ExactJet* const> operands);

/// The numbers that are in both: of ranges that are known to have one in common.
ExactRange common(const ExactRange& a, const ExactRange& b);
ExactRange operator+(const ExactRange& a, const ExactRange& b);
ExactRange operator-(const ExactRange& a, const ExactRange& b);
ExactRange operator*(const ExactRange& a, const ExactRange& b);

}  // namespace isoscope::test
