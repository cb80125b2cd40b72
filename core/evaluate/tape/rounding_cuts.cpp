// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/evaluate/tape/rounding_cuts.h"

#include <limits>

#include "core/evaluate/tape/tape_sources.h"

namespace isoscope {

std::vector<double> roundingCuts(const Tape& tape, std::span<const double> uniforms) {
    const auto sources = operandSources(tape);
    const auto& instructions = tape.instructions();
    constexpr double none = std::numeric_limits<double>::quiet_NaN();
    /// c, where a source is u + c.
    const auto shiftFrom = [&](TapeSource source, TapeSource u) {
        if (source == u) return 0.0;
        if (source < tape.slotCount()) return none;
        const std::size_t i = source - tape.slotCount();
        const auto& [a, b] = std::pair(sources[i][0], sources[i][1]);
        const auto uniform = [&](TapeSource which) {
            const bool isUniform = which < tape.slotCount() && tape.isUniform(static_cast<Slot>(which));
            return isUniform ? uniforms[which - tape.firstUniform()] : none;
        };
        if (instructions[i].operation == Operation::add)
            return a == u ? uniform(b) : b == u ? uniform(a) : none;
        return instructions[i].operation == Operation::subtract && a == u ? -uniform(b) : none;
    };
    std::vector<double> cuts(instructions.size(), none);
    for (std::size_t i = 0; i < cuts.size(); ++i) {
        const auto [u, whole] = std::pair(sources[i][0], sources[i][1]);
        if (instructions[i].operation != Operation::subtract || whole < tape.slotCount()) continue;
        const std::size_t rounding = whole - tape.slotCount();
        const double shift = shiftFrom(sources[rounding][0], u);
        if (instructions[rounding].operation == Operation::floor) cuts[i] = -shift;
        if (instructions[rounding].operation == Operation::ceiling) cuts[i] = -1 - shift;
    }
    return cuts;
}

}  // namespace isoscope
