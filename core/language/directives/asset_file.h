// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "core/language/parse_context.h"

namespace isoscope {

/// Where a file is that the text names: an image, a font. Either `file` or `problem` is set, or neither when
/// there is no such file.
struct AssetFile {
    std::optional<std::filesystem::path> file;
    std::string problem;  ///< a sentence: the text may not read it
    std::string hint;     ///< what helps then

    explicit operator bool() const { return file.has_value(); }
    const std::filesystem::path& operator*() const { return *file; }
    /// Why there is none: `missing` where it was not found.
    std::string whyNot(const std::string& missing) const { return problem.empty() ? missing : problem; }
};

/// Looks for the file beside the text that `range` lies in, beside the scene, and in the library paths, as
/// for included texts, among those that the text may read (ReadPermission).
AssetFile findAsset(const ParseContext& context, std::string_view name, const SourceRange& range);

}  // namespace isoscope
