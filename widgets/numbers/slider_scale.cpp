// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/numbers/slider_scale.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "widgets/numbers/number_text.h"

namespace isoscope {
namespace {

constexpr double largest = 1e307;  // their difference is still a number
constexpr double mostSteps = 1e6;

double usable(double end, double fallback) {
    return std::isfinite(end) ? std::clamp(end, -largest, largest) : fallback;
}

/// The natural logarithm of the quotient, which itself may be no number.
double spanOf(double minimum, double maximum) { return std::log(maximum) - std::log(minimum); }

}  // namespace

SliderScale::SliderScale(double minimum, double maximum, Kind kind, double step)
    : minimum_(usable(minimum, 0)), maximum_(usable(maximum, 1)), kind_(kind) {
    if (minimum_ > maximum_) std::swap(minimum_, maximum_);
    if (kind_ == Kind::integral) {
        minimum_ = std::floor(minimum_);
        maximum_ = std::ceil(maximum_);
    }
    if (minimum_ == maximum_) maximum_ += std::max(1.0, std::abs(minimum_));
    if (kind_ == Kind::logarithmic && minimum_ <= 0) kind_ = Kind::linear;
    const double reach = maximum_ - minimum_;
    if (kind_ == Kind::integral) steps_ = static_cast<int>(std::min(reach, mostSteps));
    if (kind_ == Kind::integral || !(step > 0 && step <= reach && reach / step <= mostSteps)) return;
    step_ = step;
    // The last step is a short one where the range is no multiple.
    if (kind_ == Kind::linear) steps_ = static_cast<int>(std::ceil(reach / step * (1 - 1e-12)));
}

SliderScale SliderScale::widenedTo(double value) const {
    if (!std::isfinite(value) || contains(value)) return *this;
    double low = std::min(minimum_, value);
    // The values stay those that they were.
    if (step_ > 0 && value < minimum_ && kind_ == Kind::linear)
        low = minimum_ - std::ceil((minimum_ - value) / step_) * step_;
    return SliderScale(low, std::max(maximum_, value), kind_, step_);
}

int SliderScale::step(double value) const {
    if (!(value > minimum_)) return 0;
    if (value >= maximum_) return steps_;
    if (step_ > 0 && kind_ == Kind::linear)
        return std::min(steps_, static_cast<int>(std::lround((value - minimum_) / step_)));
    const double share = kind_ == Kind::logarithmic
                             ? (std::log(value) - std::log(minimum_)) / spanOf(minimum_, maximum_)
                             : (value - minimum_) / (maximum_ - minimum_);
    return static_cast<int>(std::lround(share * steps_));
}

double SliderScale::exactValue(int step) const {
    if (step <= 0) return minimum_;
    if (step >= steps_) return maximum_;
    if (step_ > 0 && kind_ == Kind::linear) return minimum_ + step * step_;
    const double share = static_cast<double>(step) / steps_;
    return kind_ == Kind::logarithmic ? minimum_ * std::exp(share * spanOf(minimum_, maximum_))
                                      : minimum_ + share * (maximum_ - minimum_);
}

double SliderScale::onGrid(double value) const {
    const double multiple = minimum_ + std::round((value - minimum_) / step_) * step_;
    // Digits that only rounding brought are far below the step.
    return std::clamp(roundToResolution(multiple, step_ * 1e-6), minimum_, maximum_);
}

double SliderScale::value(int step) const {
    const double exact = exactValue(step);
    // The ends stand as they were given.
    if (step <= 0 || step >= steps_) return exact;
    if (step_ > 0) return onGrid(exact);
    // Rounding may lead to the neighbour's half of the way; a place more, then, and at most two.
    const double fine = resolution(exact);
    for (const double unit : {fine, fine / 10}) {
        const double rounded = std::clamp(roundToResolution(exact, unit), minimum_, maximum_);
        if (this->step(rounded) == step) return rounded;
    }
    return std::clamp(roundToResolution(exact, fine / 100), minimum_, maximum_);
}

double SliderScale::resolution(double value) const {
    if (kind_ == Kind::integral) return std::max(1.0, (maximum_ - minimum_) / steps_);
    if (step_ > 0) return step_;
    if (kind_ == Kind::linear) return (maximum_ - minimum_) / steps_;
    const double within = std::clamp(value, minimum_, maximum_);
    return within * (std::exp(spanOf(minimum_, maximum_) / steps_) - 1);
}

}  // namespace isoscope
