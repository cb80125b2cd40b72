// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/render/progressive/effect_budget.h"

#include <algorithm>

namespace isoscope {

void EffectBudget::note(double seconds, const RenderStatistics& statistics) {
    if (!(seconds > 0) || !(statistics.cpuSeconds > 0)) return;
    wholeSeconds_ = seconds;
    shares_.fill(0);
    for (const StageReport& stage : statistics.stages)
        shares_[static_cast<std::size_t>(stage.kind)] = stage.cpuSeconds / statistics.cpuSeconds;
}

void EffectBudget::forget() {
    wholeSeconds_ = Decision{}.seconds;
    shares_.fill(0);
}

EffectBudget::Decision EffectBudget::decide() const {
    Decision decision{{}, wholeSeconds_};
    if (!(seconds_ > 0)) return decision;
    auto shares = shares_;
    for (std::size_t i = 0; i < stageKindCount; ++i)
        if (!canBeLeftOut(static_cast<StageKind>(i))) shares[i] = 0;
    while (decision.seconds > seconds_) {
        const auto dearest = std::max_element(shares.begin(), shares.end());
        if (*dearest < smallestShare) break;
        decision.leftOut.set(static_cast<StageKind>(dearest - shares.begin()), true);
        decision.seconds -= *dearest * wholeSeconds_;
        *dearest = 0;
    }
    return decision;
}

}  // namespace isoscope
