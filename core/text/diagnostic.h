// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "core/text/source_text.h"

namespace isoscope {

enum class Severity {
    error,    ///< the text is wrong there; the statement was not understood
    warning,  ///< understood, but probably not what was meant
    leftOut,  ///< valid scene language that this program does not simulate
    note,     ///< said by the text itself (#debug) or worth knowing
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
};

using Diagnostics = std::vector<Diagnostic>;

bool hasErrors(const Diagnostics& diagnostics);

/// `file:line:column: error: message (hint)`, the form in which the command line prints diagnostics.
std::string toString(const Diagnostic& diagnostic, const SourceLibrary& sources);

}  // namespace isoscope
