// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/language/sliders/comment_line.h"

#include <algorithm>
#include <charconv>
#include <cmath>

namespace isoscope {

std::vector<TextLine> linesOf(std::string_view text) {
    std::vector<TextLine> lines;
    for (std::size_t at = 0; at < text.size();) {
        const std::size_t end = std::min(text.find_first_of("\r\n", at), text.size());
        std::size_t next = std::min(end + 1, text.size());
        if (text.substr(end, 2) == "\r\n") ++next;
        lines.push_back({at, end, next});
        at = next;
    }
    return lines;
}

std::string_view trimmed(std::string_view text) {
    const std::size_t begin = text.find_first_not_of(" \t");
    if (begin == std::string_view::npos) return {};
    return text.substr(begin, text.find_last_not_of(" \t") - begin + 1);
}

bool take(std::string_view& text, std::string_view head) {
    const std::string_view rest = trimmed(text);
    if (!rest.starts_with(head)) return false;
    text = rest.substr(head.size());
    return true;
}

std::optional<double> takeNumber(std::string_view& text) {
    const std::string_view rest = trimmed(text);
    double value = 0;
    const auto [end, error] = std::from_chars(rest.data(), rest.data() + rest.size(), value);
    if (error != std::errc() || !std::isfinite(value)) return std::nullopt;
    text = rest.substr(static_cast<std::size_t>(end - rest.data()));
    return value;
}

std::optional<std::pair<std::string, double>> readNamedNumber(std::string_view text) {
    const std::size_t sign = text.find('=');
    if (sign == std::string_view::npos) return std::nullopt;
    const std::string_view word = trimmed(text.substr(0, sign));
    text.remove_prefix(sign + 1);
    const std::optional<double> value = takeNumber(text);
    if (word.empty() || !value || !trimmed(text).empty()) return std::nullopt;
    return std::pair(std::string(word), *value);
}

TextEdit editOf(std::size_t begin, std::size_t end, std::string text) {
    return {static_cast<std::uint32_t>(begin), static_cast<std::uint32_t>(end), std::move(text)};
}

TextEdit lineInserted(std::string_view text, std::size_t at, const std::string& line) {
    const std::string lineBreak = text.find("\r\n") != std::string_view::npos ? "\r\n" : "\n";
    const bool atLineStart = at == 0 || text[at - 1] == '\n' || text[at - 1] == '\r';
    return editOf(at, at, (atLineStart ? "" : lineBreak) + line + lineBreak);
}

}  // namespace isoscope
