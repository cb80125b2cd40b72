// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/numbers/setting_text.h"

#include <algorithm>

#include "widgets/numbers/number_text.h"

namespace isoscope {

namespace {

QString keywordOf(ParameterRole role) {
    if (role == ParameterRole::maxGradient) return QStringLiteral("max_gradient");
    return role == ParameterRole::accuracy ? QStringLiteral("accuracy") : QString();
}

}  // namespace

std::optional<TextChange> settingChange(const ParseResult& parsed, std::size_t isosurface, ParameterRole role,
                                        double value) {
    const QString keyword = keywordOf(role);
    if (keyword.isEmpty()) return {};
    if (!parsed.scene || !parsed.sources || isosurface >= parsed.scene->isosurfaces.size()) return {};
    const SceneIsosurface& statement = parsed.scene->isosurfaces[isosurface];
    if (statement.range.file != 0 || statement.range.begin >= statement.range.end) return {};
    const QString number = numberText(value);
    for (const SceneParameter& parameter : parsed.scene->parameters) {
        const SourceRange& range = parameter.range;
        const bool inside =
            range.file == 0 && statement.range.begin <= range.begin && range.end <= statement.range.end;
        if (inside && parameter.role == role && !parameter.implied) return TextChange{range, number};
    }
    // Behind `function { ... }`: the settings must come before the modifiers of the object.
    const SourceRange& function = statement.functionRange;
    if (function.file != 0 || function.end <= statement.range.begin || function.end >= statement.range.end)
        return {};
    if (parsed.sources->slice({0, function.end, function.end + 1}) != "}") return {};
    return TextChange{{0, function.end + 1, function.end + 1},
                      QStringLiteral("\n  %1 %2").arg(keyword, number)};
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
