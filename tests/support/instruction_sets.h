// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <hwy/targets.h>

#include <utility>
#include <vector>

namespace isoscope::test {

/// Makes the kernels run with one instruction set while it lives. Not for use beside other threads.
class ForcedInstructionSet {
  public:
    explicit ForcedInstructionSet(std::int64_t target) { force(target); }
    ~ForcedInstructionSet() { force(0); }
    ForcedInstructionSet(const ForcedInstructionSet&) = delete;
    ForcedInstructionSet& operator=(const ForcedInstructionSet&) = delete;

  private:
    static void force(std::int64_t target) {
        hwy::SetSupportedTargetsForTest(target);
        hwy::GetChosenTarget().DeInit();
    }
};

/// The instruction sets that the kernels are compiled for and that this machine has, with their names.
inline std::vector<std::pair<std::int64_t, const char*>> instructionSets() {
    std::vector<std::pair<std::int64_t, const char*>> found;
    for (const std::int64_t target : {HWY_SCALAR, HWY_SSE4, HWY_AVX2, HWY_AVX3})
        if (target == HWY_SCALAR || (hwy::SupportedTargets() & target))
            found.emplace_back(target, hwy::TargetName(target));
    return found;
}

}  // namespace isoscope::test
