// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/background_priority.h"

#ifdef __linux__
#include <sys/resource.h>
#include <unistd.h>
#endif

namespace isoscope {

void lowerThreadPriority() {
#ifdef __linux__
    // Not SCHED_IDLE: on a machine that is busy with something else nothing would ever be known.
    constexpr int politeness = 10;
    setpriority(PRIO_PROCESS, static_cast<id_t>(gettid()), politeness);
#endif
}

}  // namespace isoscope
