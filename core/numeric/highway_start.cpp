// SPDX-License-Identifier: GPL-3.0-or-later
#include <cstdint>

#include <hwy/nanobenchmark.h>

namespace hwy::platform {

/// Stands in for Highway's own, which a constructor of its library calls for a benchmark that is not used
/// here: it measures the clock for 4 ms at each start, with an instruction (RDTSCP) that Valgrind does not
/// know on every machine. The loader takes the program's definition before the library's.
std::uint64_t TimerResolution() { return 1; }

}  // namespace hwy::platform
