// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <optional>
#include <string_view>

#include "core/language/parse_context.h"

namespace isoscope {

/// Where a file that the text names is: an image, a font. It is searched beside the text that `range` lies
/// in, beside the scene, and in the library paths, as included texts are.
std::optional<std::filesystem::path> findAsset(const ParseContext& context, std::string_view name,
                                               const SourceRange& range);

}  // namespace isoscope
