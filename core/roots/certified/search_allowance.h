// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>

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
    /// For the list, for each line, and for each that has come to a proof, or to gaps alone (found by trial
    /// on escape patterns).
    static constexpr std::uint64_t ofList = 6000, ofLine = 6, ofProof = 400, ofGap = 250;

    /// No limit: each line has its budget.
    SearchAllowance() = default;
    /// For a list of `lines`, when `spent` enclosures have been taken before.
    SearchAllowance(std::size_t lines, std::uint64_t spent)
        : end_(spent + ofList + ofLine * lines), isLimited_(true) {}

    /// Once it is known that a line takes so many values by POV-Ray's method, for `lines` of them: where that
    /// is dear, enclosures may be, too.
    void notePrice(std::uint64_t values, std::size_t lines) {
        constexpr std::uint64_t valuesOfEnclosure = 4, cheap = 200;
        if (values > cheap) end_ += (values - cheap) / valuesOfEnclosure * lines;
    }

    /// False by default alone.
    bool isLimited() const { return isLimited_; }
    /// Whether another portion is left when `spent` enclosures have been taken.
    bool has(std::uint64_t spent) const { return spent < end_; }
    /// A line has ended with this verdict.
    void note(Verdict verdict) {
        if (verdict <= Verdict::certifiedMiss) end_ += ofProof;
        if (verdict == Verdict::gap) end_ += ofGap;
    }

  private:
    std::uint64_t end_ = 0;
    bool isLimited_ = false;
};

}  // namespace isoscope
