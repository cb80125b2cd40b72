// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <span>
#include <vector>

#include "core/roots/polynomial/real_roots.h"

namespace isoscope {

/// An interval of [0, 1] on whose ends a polynomial has opposite signs and inside of which it has exactly one
/// root.
struct UnitBracket {
    double low = 0;
    double high = 1;
    bool risesThrough = false;  ///< negative at `low`
};

/// Isolates the roots of a polynomial in (0, 1) by halving its Bernstein form and counting changes of sign.
/// Doubles with a running bound on their error: what is reported is proven, the rest is refused.
class BernsteinIsolation {
  public:
    using Coefficients = std::array<double, realRootsDegreeLimit + 1>;

    /// a[0] + a[1] u + ... + a[degree] u^degree, each a[k] known to within its rounding; `magnitude` bounds
    /// the sum of absolute values that went into the coefficients.
    BernsteinIsolation(const Coefficients& power, int degree, double magnitude);

    /// False when rounding leaves a doubt about their number; `brackets` then means nothing.
    bool isolate(std::vector<UnitBracket>& brackets);

  private:
    enum class Verdict { none, one, split, doubtful };

    Verdict judge(const Coefficients& b, double error) const;
    bool search(const Coefficients& b, double low, double width, double error, int depth,
                std::vector<UnitBracket>& brackets) const;
    /// De Casteljau's scheme at `at`.
    void split(const Coefficients& b, double at, Coefficients& left, Coefficients& right) const;

    int degree_;
    Coefficients start_;
    double error_;
};

}  // namespace isoscope
