// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/evaluate/tape/whole_powers.h"

namespace isoscope {

std::vector<WholePower> wholePowers(const Tape& tape) {
    constexpr double greatest = 1e6;
    const std::vector<std::array<TapeSource, 4>> sources = operandSources(tape);
    std::vector<WholePower> all(sources.size());
    const auto powerOf = [&](TapeSource source) {
        const WholePower itself{source, 1};
        if (source < tape.slotCount()) return itself;
        const WholePower& made = all[source - tape.slotCount()];
        return made.exponent > 0 ? made : itself;
    };
    for (std::size_t i = 0; i < all.size(); ++i) {
        const Operation operation = tape.instructions()[i].operation;
        if (operation != Operation::square && operation != Operation::multiply) continue;
        const WholePower a = powerOf(sources[i][0]);
        const WholePower b = operation == Operation::square ? a : powerOf(sources[i][1]);
        if (a.base == b.base && a.exponent + b.exponent <= greatest)
            all[i] = {a.base, a.exponent + b.exponent};
    }
    for (WholePower& power : all)
        if (power.exponent < 3) power = {};
    return all;
}

}  // namespace isoscope
