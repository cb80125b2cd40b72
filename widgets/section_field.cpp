// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/section_field.h"

#include <cmath>

namespace isoscope {

SectionAxes sectionAxes(int axis) {
    switch (axis) {
        case 0: return {2, 1};
        case 1: return {0, 2};
        default: return {0, 1};
    }
}

Bounds containerBounds(const Container& container) {
    if (const auto* sphere = std::get_if<ContainerSphere>(&container))
        return {sphere->center - sphere->radius, sphere->center + sphere->radius};
    const auto& box = std::get<ContainerBox>(container);
    return {box.low, box.high};
}

double roundedUp(double value) {
    if (!(value > 0) || !std::isfinite(value)) return 1;
    const double power = std::pow(10.0, std::floor(std::log10(value)));
    // Without some slack 0.2 / 0.1 rounds up to 5.
    const double digit = value / power * (1 - 1e-9);
    return power * (digit <= 1 ? 1 : digit <= 2 ? 2 : digit <= 5 ? 5 : 10);
}

}  // namespace isoscope
