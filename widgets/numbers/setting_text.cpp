// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/numbers/setting_text.h"

#include <algorithm>

#include "widgets/numbers/number_text.h"

namespace isoscope {

std::optional<TextChange> settingChange(const ParseResult& parsed, std::size_t isosurface, ParameterRole role,
                                        double value) {
    return settingChange(parsed, isosurface, role, numberText(value).toStdString());
}

std::vector<TextChange> settingChanges(const ParseResult& parsed, ParameterRole role, double value) {
    std::vector<TextChange> changes;
    const std::size_t count = parsed.scene ? parsed.scene->isosurfaces.size() : 0;
    for (std::size_t i = 0; i < count; ++i) {
        auto change = settingChange(parsed, i, role, value);
        // Loops and macros make several isosurfaces of one statement.
        const bool known =
            change && std::any_of(changes.begin(), changes.end(), [&](const TextChange& other) {
                return other.range.begin == change->range.begin;
            });
        if (change && !known) changes.push_back(std::move(*change));
    }
    std::sort(changes.begin(), changes.end(),
              [](const TextChange& a, const TextChange& b) { return a.range.begin > b.range.begin; });
    return changes;
}

}  // namespace isoscope
