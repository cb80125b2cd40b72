// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "core/language/parse_context.h"

namespace isoscope {

/// Which files a text may read: with ParseOptions::restrictedReading those of its own folder (the current
/// folder while it has no file), of the library paths and of the readable folders, sub-folders included.
class ReadPermission {
  public:
    explicit ReadPermission(const ParseOptions& options) : options_(options) {}

    /// Whether the text may read `file`. Links out of the scene's own folder are not followed; those of other
    /// folders, which the person chose, are.
    bool allows(const std::filesystem::path& file) const;

    /// What is said of a file that it may not read: a sentence, and what helps.
    static std::string refusal(const std::string& name);
    static std::string hint();

  private:
    const ParseOptions& options_;
};

/// Where a file that the text `includer` names is looked for, in this order: beside that text, beside the
/// scene, in the library paths. Texts without a folder (the scene's own, the program's) have none beside
/// them.
std::vector<std::filesystem::path> searchedFolders(const ParseContext& context, std::uint32_t includer);

/// `name` of a text, looked for in `place`: absolute names stand for themselves, and `..` is taken away, so
/// that the file that is opened is the one that was asked about.
std::filesystem::path placedFile(const std::filesystem::path& place, const std::filesystem::path& name);

}  // namespace isoscope
