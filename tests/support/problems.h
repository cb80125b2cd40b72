// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

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

}  // namespace isoscope::test
