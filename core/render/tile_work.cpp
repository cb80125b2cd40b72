// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/render/tile_work.h"

#include <ctime>
#include <numeric>

namespace isoscope {

double threadCpuSeconds() {
    std::timespec now{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
    return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

void TileWork::restart() {
    context.restart();
    meters = {};
    verdicts = {};
    cutSamples = 0;
    elapsed_ = {};
    cpuSeconds_ = 0;
    begunSeconds_ = threadCpuSeconds();
}

void TileWork::startMeter() {
    charged_ = Clock::now();
    chargedEvaluations_ = context.evaluations;
}

void TileWork::charge(StageKind kind) {
    const Clock::time_point now = Clock::now();
    elapsed_[static_cast<std::size_t>(kind)] += now - charged_;
    meter(kind).evaluations += context.evaluations - chargedEvaluations_;
    charged_ = now;
    chargedEvaluations_ = context.evaluations;
}

void TileWork::finish() {
    cpuSeconds_ = threadCpuSeconds() - begunSeconds_;
    const Clock::duration all = std::accumulate(elapsed_.begin(), elapsed_.end(), Clock::duration(0));
    if (all <= Clock::duration(0)) return;
    for (std::size_t kind = 0; kind < stageKindCount; ++kind)
        meters[kind].cpuSeconds =
            cpuSeconds_ * static_cast<double>(elapsed_[kind].count()) / static_cast<double>(all.count());
}

}  // namespace isoscope
