// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/setting_text.h"

#include "widgets/number_text.h"

namespace isoscope {

std::optional<TextChange> maxGradientChange(const ParseResult& parsed, std::size_t isosurface, double value) {
    if (!parsed.scene || !parsed.sources || isosurface >= parsed.scene->isosurfaces.size()) return {};
    const SceneIsosurface& statement = parsed.scene->isosurfaces[isosurface];
    if (statement.range.file != 0 || statement.range.begin >= statement.range.end) return {};
    const QString number = numberText(value);
    for (const SceneParameter& parameter : parsed.scene->parameters) {
        const SourceRange& range = parameter.range;
        const bool inside =
            range.file == 0 && statement.range.begin <= range.begin && range.end <= statement.range.end;
        if (inside && parameter.role == ParameterRole::maxGradient) return TextChange{range, number};
    }
    // Behind `function { ... }`: the settings must come before the modifiers of the object.
    const SourceRange& function = statement.functionRange;
    if (function.file != 0 || function.end <= statement.range.begin || function.end >= statement.range.end)
        return {};
    if (parsed.sources->slice({0, function.end, function.end + 1}) != "}") return {};
    return TextChange{{0, function.end + 1, function.end + 1}, QStringLiteral("\n  max_gradient ") + number};
}

}  // namespace isoscope
