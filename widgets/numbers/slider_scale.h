// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace isoscope {

/// Maps a range of numbers to the whole steps of a slider, evenly, by equal ratios or one step per integer.
/// Always a usable scale: ends that are not finite, equal or exchanged are put right, and a logarithmic scale
/// that would reach zero is an even one.
class SliderScale {
  public:
    /// How the steps are spread: evenly, by equal ratios, or one per integer.
    enum class Kind { linear, logarithmic, integral };

    SliderScale(double minimum, double maximum, Kind kind);

    static constexpr int fineSteps = 1000;

    /// The scale as it was put right: ends and kind may differ from those asked for. contains() includes both
    /// ends.
    double minimum() const { return minimum_; }
    double maximum() const { return maximum_; }
    Kind kind() const { return kind_; }
    bool contains(double value) const { return value >= minimum_ && value <= maximum_; }
    /// The same scale, reaching `value`, too.
    SliderScale widenedTo(double value) const;

    /// Steps are 0 to steps().
    int steps() const { return steps_; }
    /// The nearest step; values outside give the ends.
    int step(double value) const;
    /// The shortest decimal that lies on this step.
    double value(int step) const;
    /// How far apart neighbouring steps are near `value`, in round numbers' terms: what numberText() should
    /// keep.
    double resolution(double value) const;

  private:
    double exactValue(int step) const;

    double minimum_;
    double maximum_;
    Kind kind_;
    int steps_ = fineSteps;
};

}  // namespace isoscope
