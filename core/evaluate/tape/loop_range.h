// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace isoscope {

/// How `sum` and `prod` run, the same in every evaluator: i = first, first + 1, ... while i <= last.
///
/// A loop may run at most as many steps as its `allowance`: 10^6 for a loop of the function itself; the steps
/// of a loop share their allowance evenly, so that nested loops together stay below the same number. A longer
/// loop, and one whose bounds are so large that adding 1 no longer changes them, has the value NaN.
class LoopRange {
  public:
    static constexpr double topAllowance = 1e6;
    /// Up to here every whole number is a double, so that adding 1 makes progress.
    static constexpr double largestBound = 9007199254740992.0;

    LoopRange(double first, double last, double allowance) {
        // An empty range, or a bound that is NaN, gives the neutral element.
        if (!(first <= last)) return;
        const bool progresses = first > -largestBound && last < largestBound;
        runs_ = progresses && last - first <= allowance;
        tooLong_ = !runs_;
        if (runs_) bodyAllowance_ = allowance / (last - first + 1);
    }

    /// Whether there is at least one step to do.
    bool runs() const { return runs_; }
    /// Whether the value is NaN because the range is too long.
    bool tooLong() const { return tooLong_; }
    /// The allowance of loops inside the body.
    double bodyAllowance() const { return bodyAllowance_; }

  private:
    bool runs_ = false;
    bool tooLong_ = false;
    double bodyAllowance_ = 0;
};

}  // namespace isoscope
