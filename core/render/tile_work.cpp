// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/render/tile_work.h"

#include <ctime>

namespace isoscope {

double threadCpuSeconds() {
    std::timespec now{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
    return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

void TileWork::startMeter() {
    chargedSeconds_ = threadCpuSeconds();
    chargedEvaluations_ = context.evaluations;
}

void TileWork::charge(StageKind kind) {
    const double now = threadCpuSeconds();
    meter(kind).cpuSeconds += now - chargedSeconds_;
    meter(kind).evaluations += context.evaluations - chargedEvaluations_;
    chargedSeconds_ = now;
    chargedEvaluations_ = context.evaluations;
}

}  // namespace isoscope
