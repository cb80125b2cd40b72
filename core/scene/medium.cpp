// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/scene/medium.h"

#include <cmath>
#include <utility>

namespace isoscope {

double phaseFunction(const Medium& medium, double cosine) {
    const double forward = 0.5 * (1 + cosine), g = medium.eccentricity;
    switch (medium.kind) {
        case ScatteringKind::isotropic: break;
        case ScatteringKind::haze: return 0.576655375 * (1 + 9 * std::pow(forward, 8));
        case ScatteringKind::murk: return 0.495714547 * (1 + 50 * std::pow(forward, 32));
        case ScatteringKind::rayleigh: return 0.799372013 * (1 + cosine * cosine);
        case ScatteringKind::henyeyGreenstein: return (1 - g * g) / std::pow(1 + g * g - 2 * g * cosine, 1.5);
    }
    return 1;
}

Interior moved(Interior interior, const Transform& transform) {
    if (transform.identity()) return interior;
    for (std::shared_ptr<const Medium>& medium : interior.media) {
        if (medium->layers() == 0) continue;
        Medium copy = *medium;
        copy.transform = copy.transform.then(transform);
        medium = std::make_shared<const Medium>(std::move(copy));
    }
    return interior;
}

}  // namespace isoscope
