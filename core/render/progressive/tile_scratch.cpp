// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/render/progressive/tile_scratch.h"

#include <ctime>
#include <numeric>

#include "core/render/progressive/tick_clock.h"

namespace isoscope {

double threadCpuSeconds() {
    std::timespec now{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
    return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

void TileScratch::restart() {
    context.restart();
    meters = {};
    verdicts = {};
    cutSamples = 0;
    elapsed_ = {};
    cpuSeconds_ = 0;
    begunSeconds_ = threadCpuSeconds();
}

void TileScratch::startMeter() {
    charged_ = ticks();
    chargedEvaluations_ = context.evaluations;
}

void TileScratch::charge(StageKind kind) {
    const std::uint64_t now = ticks();
    // Another core's counter may lag a little.
    if (now > charged_) elapsed_[static_cast<std::size_t>(kind)] += now - charged_;
    meter(kind).evaluations += context.evaluations - chargedEvaluations_;
    charged_ = now;
    chargedEvaluations_ = context.evaluations;
}

void TileScratch::finish() {
    cpuSeconds_ = threadCpuSeconds() - begunSeconds_;
    const std::uint64_t all = std::accumulate(elapsed_.begin(), elapsed_.end(), std::uint64_t{0});
    if (all == 0) return;
    for (std::size_t kind = 0; kind < stageKindCount; ++kind)
        meters[kind].cpuSeconds =
            cpuSeconds_ * static_cast<double>(elapsed_[kind]) / static_cast<double>(all);
}

}  // namespace isoscope
