// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/language/sliders/value_preset.h"

#include <algorithm>
#include <optional>

#include "core/language/sliders/comment_line.h"
#include "core/text/number_format.h"

namespace isoscope {

namespace {

constexpr std::string_view keyword = "preset";

std::optional<ValuePreset> readPreset(std::string_view line) {
    if (!take(line, "//") || !take(line, keyword) || !take(line, "\"")) return std::nullopt;
    const std::size_t quote = line.find('"');
    if (quote == std::string_view::npos) return std::nullopt;
    ValuePreset preset{std::string(line.substr(0, quote)), {}};
    line.remove_prefix(quote + 1);
    if (!take(line, ":")) return std::nullopt;
    for (bool more = !trimmed(line).empty(); more;) {
        const std::size_t comma = std::min(line.find(','), line.size());
        auto value = readNamedNumber(line.substr(0, comma));
        if (!value) return std::nullopt;
        preset.values.push_back(std::move(*value));
        more = comma < line.size();
        if (more) line.remove_prefix(comma + 1);
    }
    return preset;
}

/// A line with a preset.
struct PresetLine {
    TextLine line;
    ValuePreset preset;
};

std::vector<PresetLine> presetLines(std::string_view text) {
    std::vector<PresetLine> found;
    for (const TextLine& line : linesOf(text))
        if (auto preset = readPreset(text.substr(line.begin, line.end - line.begin)))
            found.push_back({line, std::move(*preset)});
    return found;
}

std::string lineOf(const ValuePreset& preset) {
    std::string line = "// " + std::string(keyword) + " \"" + presetWord(preset.name) + "\":";
    const char* between = " ";
    for (const auto& [word, value] : preset.values) {
        line += between + presetWord(word) + " = " + shortestNumber(value);
        between = ", ";
    }
    return line;
}

}  // namespace

std::vector<ValuePreset> presetsOf(std::string_view text) {
    std::vector<ValuePreset> presets;
    for (PresetLine& line : presetLines(text)) presets.push_back(std::move(line.preset));
    return presets;
}

std::string presetWord(std::string_view word) {
    std::string plain(word);
    for (char& c : plain)
        if (c == '"' || c == '=' || c == ',' || static_cast<unsigned char>(c) < ' ') c = ' ';
    return std::string(trimmed(plain));
}

TextEdit presetAdded(std::string_view text, const ValuePreset& preset) {
    const std::vector<PresetLine> lines = presetLines(text);
    return lineInserted(text, lines.empty() ? text.size() : lines.back().line.next, lineOf(preset));
}

TextEdit presetReplaced(std::string_view text, std::size_t index, const ValuePreset& preset) {
    const TextLine line = presetLines(text).at(index).line;
    return editOf(line.begin, line.end, lineOf(preset));
}

TextEdit presetRemoved(std::string_view text, std::size_t index) {
    const TextLine line = presetLines(text).at(index).line;
    return editOf(line.begin, line.next, {});
}

}  // namespace isoscope
