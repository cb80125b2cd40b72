// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/roots/root_settings.h"

#include <algorithm>

namespace isoscope {

RootSettings RootSettings::usable() const {
    const RootSettings defaults;
    RootSettings result = *this;
    if (!(result.accuracy > 0)) result.accuracy = defaults.accuracy;
    if (!(result.maxGradient > 0)) result.maxGradient = defaults.maxGradient;
    if (evaluate) {
        if (!((*evaluate)[0] > 0)) (*result.evaluate)[0] = defaults.maxGradient;
        if (!((*evaluate)[1] >= 1)) (*result.evaluate)[1] = 1;
        if (!((*evaluate)[2] > 0 && (*evaluate)[2] <= 1)) (*result.evaluate)[2] = 1;
    }
    result.maxTrace = std::clamp(maxTrace, 1, 10);
    return result;
}

}  // namespace isoscope
