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

    /// `step`, where positive, is how far apart values are, counted from the lower end; a logarithmic scale
    /// still moves by equal ratios. Ignored where it is larger than the range or would give over a million
    /// steps, and for integers.
    SliderScale(double minimum, double maximum, Kind kind, double step = 0);

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
    /// The shortest decimal that lies on this step; the ends as they were given.
    double value(int step) const;
    /// How far apart neighbouring steps are near `value`, in round numbers' terms: what numberText() should
    /// keep.
    double resolution(double value) const;

  private:
    double exactValue(int step) const;
    /// The nearest multiple of step_ from the lower end, as a decimal.
    double onGrid(double value) const;

    double minimum_;
    double maximum_;
    Kind kind_;
    double step_ = 0;
    int steps_ = fineSteps;
};

}  // namespace isoscope
