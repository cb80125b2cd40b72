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

}  // namespace

bool hasErrors(const Diagnostics& diagnostics) {
    return std::any_of(diagnostics.begin(), diagnostics.end(),
                       [](const Diagnostic& d) { return d.severity == Severity::error; });
}

std::string toString(const Diagnostic& diagnostic, const SourceLibrary& sources) {
    std::string place;
    if (diagnostic.range.file < sources.size()) {
        const SourceText& source = sources[diagnostic.range.file];
        const LineColumn at = source.position(diagnostic.range.begin);
        place = source.name() + ":" + std::to_string(at.line) + ":" + std::to_string(at.column) + ": ";
    }
    std::string text = place + name(diagnostic.severity) + ": " + diagnostic.message;
    if (!diagnostic.hint.empty()) text += " (" + diagnostic.hint + ")";
    return text;
}

}  // namespace isoscope
