// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/gradient/function_likeness.h"

#include <algorithm>
#include <cstring>
#include <vector>

namespace isoscope {

namespace {

bool sameInstruction(const Instruction& a, const Instruction& b) {
    return a.operation == b.operation && a.operandCount == b.operandCount && a.target == b.target &&
           a.operands == b.operands && a.index == b.index;
}

/// NaN is equal to itself here.
bool sameNumbers(const std::vector<double>& a, const std::vector<double>& b) {
    return a.size() == b.size() &&
           (a.empty() || std::memcmp(a.data(), b.data(), a.size() * sizeof a[0]) == 0);
}

}  // namespace

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
    const bool sameShape = a.argumentCount() == b.argumentCount() && a.slotCount() == b.slotCount() &&
                           std::ranges::equal(a.results(), b.results()) &&
                           std::ranges::equal(a.instructions(), b.instructions(), sameInstruction);
    if (!sameShape || !sameNumbers(a.uniforms(parametersOfA), b.uniforms(parametersOfB))) return false;
    for (const Instruction& instruction : a.instructions())
        if (instruction.operation == Operation::crackle &&
            !(a.crackle(instruction.index) == b.crackle(instruction.index)))
            return false;
    return std::ranges::equal(a.loops(), b.loops(), [&](const TapeLoop& one, const TapeLoop& other) {
        return one.captured == other.captured &&
               sameFunction(*one.body, parametersOfA, *other.body, parametersOfB);
    });
}

}  // namespace isoscope
