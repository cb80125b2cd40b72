// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/exchange/setting_change.h"

#include <string_view>

namespace isoscope {

namespace {

std::string_view keywordOf(ParameterRole role) {
    if (role == ParameterRole::maxGradient) return "max_gradient";
    return role == ParameterRole::accuracy ? "accuracy" : "";
}

}  // namespace

std::optional<TextChange> settingChange(const ParseResult& parsed, std::size_t isosurface, ParameterRole role,
                                        const std::string& number) {
    const std::string_view keyword = keywordOf(role);
    if (keyword.empty()) return {};
    if (!parsed.scene || !parsed.sources || isosurface >= parsed.scene->isosurfaces.size()) return {};
    const SceneIsosurface& statement = parsed.scene->isosurfaces[isosurface];
    if (statement.range.file != 0 || statement.range.begin >= statement.range.end) return {};
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
    return TextChange{{0, function.end + 1, function.end + 1}, "\n  " + std::string(keyword) + " " + number};
}

}  // namespace isoscope
