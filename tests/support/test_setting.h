// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <cstdint>

namespace isoscope::test {

/// The number in an environment variable; `otherwise` where there is none.
inline double setting(const char* name, double otherwise) {
    bool given = false;
    const double value = qEnvironmentVariable(name).toDouble(&given);
    return given ? value : otherwise;
}

/// The seed of random tests, ISOSCOPE_SEED.
inline std::uint64_t seedSetting(std::uint64_t otherwise) {
    return static_cast<std::uint64_t>(setting("ISOSCOPE_SEED", static_cast<double>(otherwise)));
}

}  // namespace isoscope::test
