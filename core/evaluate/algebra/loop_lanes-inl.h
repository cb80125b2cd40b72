// SPDX-License-Identifier: GPL-3.0-or-later
// Included once per instruction set. Which lanes of a loop still run.
#if defined(ISOSCOPE_EVALUATE_LOOP_LANES_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef ISOSCOPE_EVALUATE_LOOP_LANES_INL
#undef ISOSCOPE_EVALUATE_LOOP_LANES_INL
#else
#define ISOSCOPE_EVALUATE_LOOP_LANES_INL
#endif

#include <hwy/highway.h>

#include <array>
#include <limits>

#include "core/evaluate/algebra/point_algebra-inl.h"
#include "core/evaluate/tape/loop_range.h"
#include "core/evaluate/tape/tape_workspace.h"

HWY_BEFORE_NAMESPACE();
namespace isoscope::HWY_NAMESPACE {

/// For numbers whose first component is the plain value: a lane runs while its variable is at most its last
/// value.
template <class Algebra>
class LoopLanes {
  public:
    explicit LoopLanes(bool isSum) : isSum_(isSum) {}

    void start(const TapeWorkspace& workspace, TapeWorkspace& body, const double* first, const double* last,
               std::size_t lanes) {
        for (std::size_t i = 0; i < lanes; ++i) {
            if (!Algebra::isExactLane(first + i) || !Algebra::isExactLane(last + i)) {
                neutral_[i] = std::numeric_limits<double>::infinity();
                continue;
            }
            const LoopRange range(first[i], last[i], workspace.loopAllowance()[i]);
            neutral_[i] = range.tooLong() ? std::numeric_limits<double>::quiet_NaN() : isSum_ ? 0 : 1;
            running_[i] = range.runs();
            left_ += range.runs();
            body.loopAllowance()[i] = range.bodyAllowance();
        }
    }

    bool isSum() const { return isSum_; }
    /// Lanes that run.
    std::size_t left() const { return left_; }
    /// The value before the first step: 0, 1, NaN where the loop is too long, infinity where its bounds are
    /// not known.
    typename Algebra::Number neutral(std::size_t i) const {
        return Algebra::widen({hn::Load(Doubles(), neutral_.data() + i)});
    }
    Mask running(std::size_t i) const {
        return hn::Gt(hn::Load(Doubles(), running_.data() + i), hn::Zero(Doubles()));
    }
    /// After a step, with the variables already increased.
    void advance(const double* variable, const double* last, std::size_t lanes) {
        left_ = 0;
        for (std::size_t i = 0; i < lanes; ++i) {
            if (running_[i] > 0) running_[i] = variable[i] <= last[i];
            left_ += running_[i] > 0;
        }
    }

  private:
    bool isSum_;
    std::size_t left_ = 0;
    HWY_ALIGN std::array<double, batchLanes> neutral_{};
    HWY_ALIGN std::array<double, batchLanes> running_{};
};

}  // namespace isoscope::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
