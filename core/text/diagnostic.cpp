// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/text/diagnostic.h"

#include <algorithm>

namespace isoscope {

namespace {

const char* name(Severity severity) {
    switch (severity) {
        case Severity::error: return "error";
        case Severity::warning: return "warning";
        case Severity::leftOut: return "left out";
        case Severity::note: return "note";
    }
    return "";
}

/// `name:line:column`, or "" for a place in no text.
std::string placeName(const SourceRange& range, const SourceLibrary& sources) {
    if (range.file >= sources.size()) return {};
    const SourceText& source = sources[range.file];
    const LineColumn at = source.position(range.begin);
    return source.name() + ":" + std::to_string(at.line) + ":" + std::to_string(at.column);
}

bool isContinuation(char byte) { return (static_cast<unsigned char>(byte) & 0xc0) == 0x80; }

/// The line in which `range` begins, with a second line below it that marks the range.
std::string excerpt(const SourceRange& range, const SourceLibrary& sources) {
    if (range.file >= sources.size()) return {};
    const std::string_view text = sources[range.file].text();
    constexpr std::size_t before = 60, behind = 50;  // of a line too long to be read
    const std::size_t at = std::min<std::size_t>(range.begin, text.size());
    const std::size_t start = at == 0 ? 0 : text.rfind('\n', at - 1) + 1;  // npos + 1 is the beginning
    const std::size_t end = std::min(text.find('\n', at), text.size());
    std::size_t first = at - start > before + behind ? at - before : start;
    std::size_t last = std::min(end, std::max(at, start + before) + behind);
    while (first < at && isContinuation(text[first])) ++first;
    while (last < end && isContinuation(text[last])) ++last;
    if (at == end && first == last) return {};
    const std::string number = std::to_string(sources[range.file].position(range.begin).line);
    std::string line = "  " + number + " | " + (first > start ? "..." : "");
    std::string marks = "  " + std::string(number.size(), ' ') + " | " + (first > start ? "   " : "");
    const std::size_t markEnd = std::max<std::size_t>(range.end, at + 1);
    for (std::size_t i = first; i < last; ++i) {
        const char c = text[i];
        // A terminal obeys control characters.
        line += c == '\t' || static_cast<unsigned char>(c) >= ' ' ? (c == '\x7f' ? ' ' : c) : ' ';
        if (isContinuation(c)) continue;
        if (i >= at)
            marks += i == at ? "^" : i < markEnd ? "~" : "";
        else
            marks += c == '\t' ? '\t' : ' ';
    }
    if (at >= last) marks += '^';
    while (line.back() == ' ') line.pop_back();
    return line + (last < end ? "..." : "") + '\n' + marks + '\n';
}

}  // namespace

bool hasErrors(const Diagnostics& diagnostics) {
    return std::any_of(diagnostics.begin(), diagnostics.end(),
                       [](const Diagnostic& d) { return d.severity == Severity::error; });
}

std::string toString(const Diagnostic& diagnostic, const SourceLibrary& sources) {
    const std::string place = placeName(diagnostic.range, sources);
    std::string text = (place.empty() ? place : place + ": ") + name(diagnostic.severity) + ": ";
    text += diagnostic.message;
    if (!diagnostic.hint.empty()) text += " (" + diagnostic.hint + ")";
    return text;
}

std::string toReport(const Diagnostic& diagnostic, const SourceLibrary& sources) {
    // A diagnostic about the text as a whole says nothing of its first line.
    const bool placed = !(diagnostic.range == SourceRange{});
    std::string text = toString(diagnostic, sources) + '\n';
    if (placed) text += excerpt(diagnostic.range, sources);
    for (const SourceRange& site : diagnostic.reachedFrom)
        text +=
            "  " + callText(site, sources) + " " + placeName(site, sources) + '\n' + excerpt(site, sources);
    return text;
}

std::string callText(const SourceRange& site, const SourceLibrary& sources) {
    const std::string_view statement = sources.slice(site);
    if (statement.starts_with('#')) return "included at";
    return "in macro `" + std::string(statement.substr(0, statement.find_first_of(" (\n"))) + "`, called at";
}

std::string withCodeWords(const std::string& message, const std::string& open, const std::string& close) {
    std::string result;
    std::size_t at = 0;
    while (at < message.size()) {
        const std::size_t begin = message.find('`', at);
        // At least one character between them: the word may be a backtick itself.
        const std::size_t end =
            begin == std::string::npos ? begin : message.find('`', std::min(begin + 2, message.size()));
        if (end == std::string::npos) break;
        result += message.substr(at, begin - at) + open + message.substr(begin + 1, end - begin - 1) + close;
        at = end + 1;
    }
    return result + message.substr(at);
}

}  // namespace isoscope
