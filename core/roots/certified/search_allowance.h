// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <utility>

#include "core/roots/verdict.h"

namespace isoscope {

/// The enclosures that the lines of a list may take together, in portions: as long as most lines come to a
/// proof, hard ones get what they need. Where enclosures are mostly in vain, as beside the edge of a fractal,
/// all lines end soon; what is left is for POV-Ray's own method, and the whole costs about what POV-Ray
/// takes.
class SearchAllowance {
  public:
    /// Enclosures of a line between two looks at what is left.
    static constexpr std::uint32_t portion = 16;
    /// Those of a line that begins when nothing is left.
    static constexpr std::uint32_t leastPortion = 4;
    /// For the list, for each line, and for each that has come to a proof, or to gaps alone (found by trial
    /// on escape patterns).
    static constexpr std::uint64_t ofList = 6000, ofLine = 6, ofProof = 400, ofGap = 250;

    /// No limit: each line has its budget.
    SearchAllowance() = default;
    /// For a list of `lines`, when `spent` enclosures have been taken before. `price` tells about how many
    /// values a line takes by POV-Ray's method: where that is dear, enclosures may be, too. It is asked once,
    /// when the others are used up.
    SearchAllowance(std::size_t lines, std::uint64_t spent, std::function<std::uint64_t()> price)
        : lines_(lines), end_(spent + ofList + ofLine * lines), price_(std::move(price)), isLimited_(true) {}

    /// False by default alone.
    bool isLimited() const { return isLimited_; }
    /// Whether another portion is left when `spent` enclosures have been taken.
    bool has(std::uint64_t spent) {
        if (spent >= end_ && price_) {
            constexpr std::uint64_t valuesOfEnclosure = 4, cheap = 200;
            const std::uint64_t values = std::exchange(price_, nullptr)();
            if (values > cheap) end_ += (values - cheap) / valuesOfEnclosure * lines_;
        }
        return spent < end_;
    }
    /// The enclosures that a line begins with when `spent` have been taken.
    std::uint32_t firstPortion(std::uint64_t spent) { return has(spent) ? portion : leastPortion; }
    /// A line has ended with this verdict.
    void note(Verdict verdict) {
        if (verdict <= Verdict::certifiedMiss) end_ += ofProof;
        if (verdict == Verdict::gap) end_ += ofGap;
    }

  private:
    std::size_t lines_ = 0;
    std::uint64_t end_ = 0;
    std::function<std::uint64_t()> price_;
    bool isLimited_ = false;
};

}  // namespace isoscope
