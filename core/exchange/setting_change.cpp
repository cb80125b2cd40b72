// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/exchange/setting_change.h"

#include <string_view>

#include "core/language/tokens/lexer.h"
#include "core/text/number_format.h"

namespace isoscope {

namespace {

std::string_view keywordOf(ParameterRole role) {
    if (role == ParameterRole::maxGradient) return "max_gradient";
    return role == ParameterRole::accuracy ? "accuracy" : "";
}

/// A setting behind `function { ... }`: the settings must come before the modifiers of the object.
std::optional<TextChange> behindFunction(const ParseResult& parsed, const SceneIsosurface& statement,
                                         const std::string& setting) {
    const SourceRange& function = statement.functionRange;
    if (function.file != 0 || function.end <= statement.range.begin || function.end >= statement.range.end)
        return {};
    if (parsed.sources->slice({0, function.end, function.end + 1}) != "}") return {};
    return TextChange{{0, function.end + 1, function.end + 1}, "\n  " + setting};
}

/// What follows `keyword` in the statement, blanks in front of it left out: up to a word behind an operand.
/// Nothing where it is followed by no such thing, or by directives.
std::optional<SourceRange> numbersBehind(const ParseResult& parsed, const SceneIsosurface& statement,
                                         std::string_view keyword) {
    const std::uint32_t file = statement.range.file;
    Lexer lexer((*parsed.sources)[file].text(), file, statement.functionRange.end, statement.range.end);
    Token token = lexer.next();
    while (!token.is(keyword))
        if ((token = lexer.next()).kind == TokenKind::end) return {};
    token = lexer.next();
    SourceRange numbers{file, token.range.begin, token.range.begin};
    bool operand = false;
    for (int depth = 0; token.kind != TokenKind::end; token = lexer.next()) {
        const bool opens = token.is("(") || token.is("[");
        const bool closes = token.is(")") || token.is("]");
        const bool value = token.kind == TokenKind::number || token.kind == TokenKind::word;
        if (depth == 0 && ((operand && value) || token.is("}") || token.is("#") || token.is("{"))) break;
        depth += opens - closes;
        operand = value || closes;
        numbers.end = token.range.end;
    }
    return numbers;
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
    return behindFunction(parsed, statement, std::string(keyword) + " " + number);
}

std::optional<TextChange> evaluateChange(const ParseResult& parsed, std::size_t isosurface,
                                         const std::array<double, 3>& numbers) {
    if (!parsed.scene || !parsed.sources || isosurface >= parsed.scene->isosurfaces.size()) return {};
    const SceneIsosurface& statement = parsed.scene->isosurfaces[isosurface];
    if (statement.range.file != 0 || statement.range.begin >= statement.range.end) return {};
    const std::string text =
        shortestNumber(numbers[0]) + ", " + shortestNumber(numbers[1]) + ", " + shortestNumber(numbers[2]);
    if (const auto known = numbersBehind(parsed, statement, "evaluate")) return TextChange{*known, text};
    return behindFunction(parsed, statement, "evaluate " + text);
}

std::optional<TextChange> gradientChangeAnywhere(const ParseResult& parsed, std::size_t isosurface,
                                                 const std::string& number) {
    if (auto own = settingChange(parsed, isosurface, ParameterRole::maxGradient, number)) return own;
    if (!parsed.scene || !parsed.sources || isosurface >= parsed.scene->isosurfaces.size()) return {};
    const SceneIsosurface& statement = parsed.scene->isosurfaces[isosurface];
    const SourceRange &whole = statement.range, &function = statement.functionRange;
    // The function and its statement stand in one file, which was read from disk.
    if (whole.file == 0 || whole.file >= parsed.sources->size() || function.file != whole.file ||
        function.end <= whole.begin || function.end >= whole.end)
        return {};
    if (const auto known = numbersBehind(parsed, statement, "max_gradient"))
        return TextChange{*known, number};
    const SourceRange behind{whole.file, function.end + 1, function.end + 1};
    if (parsed.sources->slice({whole.file, function.end, function.end + 1}) != "}") return {};
    return TextChange{behind, "\n  max_gradient " + number};
}

}  // namespace isoscope
