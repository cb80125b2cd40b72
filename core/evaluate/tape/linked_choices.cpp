// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/evaluate/tape/linked_choices.h"

#include <map>
#include <utility>

#include "core/evaluate/tape/tape_sources.h"

namespace isoscope {

std::vector<LinkedChoice> linkedChoices(const Tape& tape) {
    constexpr auto nothing = static_cast<TapeSource>(-1);
    const auto sources = operandSources(tape);
    const auto& instructions = tape.instructions();
    // What is subtracted from what; a value that is no difference stands for itself less nothing.
    using Difference = std::pair<TapeSource, TapeSource>;
    const auto differenceAt = [&](TapeSource source) -> Difference {
        if (source < tape.slotCount()) return {source, nothing};
        const std::size_t i = source - tape.slotCount();
        if (instructions[i].operation != Operation::subtract) return {source, nothing};
        return {sources[i][0], sources[i][1]};
    };
    struct Leader {
        std::size_t instruction;
        bool firstAbove;  ///< whether it takes its first side where the difference is above 0
    };
    std::map<Difference, Leader> leaders;
    std::vector<LinkedChoice> links(instructions.size());
    for (std::size_t i = 0; i < instructions.size(); ++i) {
        Difference difference;
        bool firstAbove = false;
        switch (instructions[i].operation) {
            case Operation::minimum: difference = {sources[i][0], sources[i][1]}; break;
            case Operation::maximum:
                difference = {sources[i][0], sources[i][1]};
                firstAbove = true;
                break;
            case Operation::absolute:
                difference = differenceAt(sources[i][0]);
                firstAbove = true;
                break;
            case Operation::select3:
            case Operation::select4: difference = differenceAt(sources[i][0]); break;
            default: continue;
        }
        // The same either way round.
        if (difference.second < difference.first) {
            std::swap(difference.first, difference.second);
            firstAbove = !firstAbove;
        }
        const auto [leader, isNew] = leaders.try_emplace(difference, Leader{i, firstAbove});
        if (!isNew) links[i] = {leader->second.instruction, leader->second.firstAbove != firstAbove};
    }
    return links;
}

}  // namespace isoscope
