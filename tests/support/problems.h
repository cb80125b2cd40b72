// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <string>
#include <vector>

#include "core/language/parse.h"

namespace isoscope::test {

/// Every diagnostic of a ParseResult or ParsedFunction, a line each: what a failing test shows.
template <class Parsed>
std::string problems(const Parsed& parsed) {
    std::string text;
    for (const Diagnostic& diagnostic : parsed.diagnostics)
        text += toString(diagnostic, *parsed.sources) + "\n";
    return text;
}

/// "message [marked text]" of every diagnostic but notes.
inline std::vector<std::string> complaints(const ParseResult& parsed) {
    std::vector<std::string> all;
    for (const Diagnostic& diagnostic : parsed.diagnostics) {
        if (diagnostic.severity == Severity::note) continue;
        all.push_back(diagnostic.message + " [" + std::string(parsed.sources->slice(diagnostic.range)) + "]");
    }
    return all;
}

inline bool has(const ParseResult& parsed, Severity severity, const std::string& id) {
    return std::any_of(parsed.diagnostics.begin(), parsed.diagnostics.end(),
                       [&](const Diagnostic& d) { return d.severity == severity && d.id == id; });
}

}  // namespace isoscope::test
