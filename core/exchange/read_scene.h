// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>

#include "core/language/parse.h"

namespace isoscope {

/// Reads a scene in the notation that its file or text shows: POV-Ray's or VirtuaLight's. As parseScene().
ParseResult readScene(std::string text, ParseOptions options = {});

/// The same for a file; one that cannot be read is a diagnostic.
ParseResult readSceneFile(const std::filesystem::path& file, ParseOptions options = {});

}  // namespace isoscope
