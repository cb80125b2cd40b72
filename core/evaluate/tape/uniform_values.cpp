// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/evaluate/tape/uniform_values.h"

#include <algorithm>
#include <bit>
#include <cstdint>

namespace isoscope {

UniformValues::UniformValues(const Tape& tape, std::span<const double> parameters)
    : values(tape.uniforms(parameters)) {
    for (const TapeLoop& loop : tape.loops()) loops.emplace_back(*loop.body, parameters);
}

bool UniformValues::sameAs(const UniformValues& other) const {
    const auto bits = [](double value) { return std::bit_cast<std::uint64_t>(value); };
    return std::ranges::equal(values, other.values, {}, bits, bits) &&
           std::ranges::equal(loops, other.loops, &UniformValues::sameAs);
}

}  // namespace isoscope
