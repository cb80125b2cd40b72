// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/language/parse.h"
#include "core/virtualight/document.h"

namespace isoscope::virtualight {

/// Whether a text is written in VirtuaLight's notation: by the ending .vl or .vib of its file; a file that
/// ends in .pov or .inc is not; any other, and a text without a file, when it begins with one of
/// VirtuaLight's statements.
bool isVirtualight(const std::filesystem::path& file, std::string_view text);

/// The colour of everything, in place of shaders.
constexpr Color plainColor{0.8, 0.8, 0.8, 0, 0};

/// A text of VirtuaLight as a scene, with light grey for the shaders that are not simulated. Never throws,
/// never hangs, for any bytes.
ParseResult parseVirtualight(std::string text, ParseOptions options = {});

/// The statements of a text, for writers. `diagnostics` may be null.
Document readDocument(std::string text, const ParseOptions& options, Diagnostics* diagnostics = nullptr);

}  // namespace isoscope::virtualight
