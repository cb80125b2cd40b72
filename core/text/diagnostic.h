// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "core/text/source_text.h"

namespace isoscope {

/// How grave a diagnostic is. Only `error` makes hasErrors() true.
enum class Severity {
    error,    ///< the text is wrong there; the statement was not understood
    warning,  ///< understood, but probably not what was meant
    leftOut,  ///< valid scene language that this program does not simulate
    note,     ///< said by the text itself (#debug) or worth knowing
};

/// A change of the user's text that would mend what a diagnostic is about.
struct QuickFix {
    std::string title;        ///< what it does, as short as a button: "Use `function`"
    SourceRange range;        ///< of file 0; empty where something is only added
    std::string replacement;  ///< what shall stand there

    bool operator==(const QuickFix&) const = default;
};

/// What is wrong, or worth saying, about a place in a text.
struct Diagnostic {
    Severity severity = Severity::error;
    std::string id;       ///< stable identifier, e.g. "unknown-name"
    SourceRange range;    ///< the tokens it is about
    std::string message;  ///< one sentence: what is wrong and what was expected
    std::string hint;     ///< what to do about it; may be empty
    /// Where the place was reached from, innermost first: `#include` statements and macro calls.
    std::vector<SourceRange> reachedFrom;
    /// What a person may choose to have done about it, the likeliest first. The first ones of all diagnostics
    /// with the same id may be done together.
    std::vector<QuickFix> fixes{};

    bool operator==(const Diagnostic&) const = default;
};

using Diagnostics = std::vector<Diagnostic>;

/// Whether one of them has Severity::error: warnings, what was left out and notes do not count.
bool hasErrors(const Diagnostics& diagnostics);

/// `file:line:column: error: message (hint)`.
std::string toString(const Diagnostic& diagnostic, const SourceLibrary& sources);

/// What the command line prints: the same, the line with the place marked, and each `#include` and macro call
/// that led there with its line, as compilers do. Every line ends in a newline.
std::string toReport(const Diagnostic& diagnostic, const SourceLibrary& sources);

/// How a place of Diagnostic::reachedFrom leads on: "in macro `Ball`, called at", or "included at".
std::string callText(const SourceRange& site, const SourceLibrary& sources);

/// `message` with its code words, which stand in backticks, put between `open` and `close`. A backtick
/// without a partner stays.
std::string withCodeWords(const std::string& message, const std::string& open, const std::string& close);

}  // namespace isoscope
