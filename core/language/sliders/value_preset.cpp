// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/language/sliders/value_preset.h"

#include <algorithm>
#include <charconv>
#include <optional>

#include "core/text/number_format.h"

namespace isoscope {

namespace {

constexpr std::string_view keyword = "preset";

std::string_view trimmed(std::string_view text) {
    const std::size_t begin = text.find_first_not_of(" \t");
    if (begin == std::string_view::npos) return {};
    return text.substr(begin, text.find_last_not_of(" \t") - begin + 1);
}

/// Takes `head` from the front of the text, blanks before it too.
bool take(std::string_view& text, std::string_view head) {
    const std::string_view rest = trimmed(text);
    if (!rest.starts_with(head)) return false;
    text = rest.substr(head.size());
    return true;
}

std::optional<std::pair<std::string, double>> readValue(std::string_view text) {
    const std::size_t sign = text.find('=');
    if (sign == std::string_view::npos) return std::nullopt;
    const std::string_view number = trimmed(text.substr(sign + 1));
    double value = 0;
    const auto [end, error] = std::from_chars(number.data(), number.data() + number.size(), value);
    const std::string_view word = trimmed(text.substr(0, sign));
    if (word.empty() || error != std::errc() || end != number.data() + number.size()) return std::nullopt;
    return std::pair(std::string(word), value);
}

std::optional<ValuePreset> readPreset(std::string_view line) {
    if (!take(line, "//") || !take(line, keyword) || !take(line, "\"")) return std::nullopt;
    const std::size_t quote = line.find('"');
    if (quote == std::string_view::npos) return std::nullopt;
    ValuePreset preset{std::string(line.substr(0, quote)), {}};
    line.remove_prefix(quote + 1);
    if (!take(line, ":")) return std::nullopt;
    for (bool more = !trimmed(line).empty(); more;) {
        const std::size_t comma = std::min(line.find(','), line.size());
        auto value = readValue(line.substr(0, comma));
        if (!value) return std::nullopt;
        preset.values.push_back(std::move(*value));
        more = comma < line.size();
        if (more) line.remove_prefix(comma + 1);
    }
    return preset;
}

/// A line with a preset, by byte offsets.
struct PresetLine {
    std::size_t begin;
    std::size_t end;   ///< before the line break
    std::size_t next;  ///< behind the line break
    ValuePreset preset;
};

std::vector<PresetLine> presetLines(std::string_view text) {
    std::vector<PresetLine> lines;
    for (std::size_t at = 0; at < text.size();) {
        const std::size_t end = std::min(text.find_first_of("\r\n", at), text.size());
        std::size_t next = std::min(end + 1, text.size());
        if (text.substr(end, 2) == "\r\n") ++next;
        if (auto preset = readPreset(text.substr(at, end - at)))
            lines.push_back({at, end, next, std::move(*preset)});
        at = next;
    }
    return lines;
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

TextEdit edit(std::size_t begin, std::size_t end, std::string text) {
    return {static_cast<std::uint32_t>(begin), static_cast<std::uint32_t>(end), std::move(text)};
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
    const std::string lineBreak = text.find("\r\n") != std::string_view::npos ? "\r\n" : "\n";
    const std::vector<PresetLine> lines = presetLines(text);
    const std::size_t at = lines.empty() ? text.size() : lines.back().next;
    const bool atLineStart = at == 0 || text[at - 1] == '\n' || text[at - 1] == '\r';
    return edit(at, at, (atLineStart ? "" : lineBreak) + lineOf(preset) + lineBreak);
}

TextEdit presetReplaced(std::string_view text, std::size_t index, const ValuePreset& preset) {
    const PresetLine line = presetLines(text).at(index);
    return edit(line.begin, line.end, lineOf(preset));
}

TextEdit presetRemoved(std::string_view text, std::size_t index) {
    const PresetLine line = presetLines(text).at(index);
    return edit(line.begin, line.next, {});
}

}  // namespace isoscope
