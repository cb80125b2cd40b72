// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/gradient/function_likeness.h"

#include "core/evaluate/tape/tape_likeness.h"
#include "core/evaluate/tape/uniform_values.h"

namespace isoscope {

bool sameContainer(const Container& a, const Container& b) {
    if (a.index() != b.index()) return false;
    if (const auto* sphere = std::get_if<ContainerSphere>(&a)) {
        const auto& other = std::get<ContainerSphere>(b);
        return sphere->center == other.center && sphere->radius == other.radius;
    }
    const auto &box = std::get<ContainerBox>(a), &other = std::get<ContainerBox>(b);
    return box.low == other.low && box.high == other.high;
}

bool sameFunction(const Tape& a, std::span<const double> parametersOfA, const Tape& b,
                  std::span<const double> parametersOfB) {
    return sameCode(a, b) && UniformValues(a, parametersOfA).sameAs(UniformValues(b, parametersOfB));
}

}  // namespace isoscope
