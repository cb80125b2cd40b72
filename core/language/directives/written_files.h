// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "core/language/directives/written_record.h"

namespace isoscope {

/// What a text says by `#write` (ParseResult::writtenFiles): content by name.
using WrittenFiles = std::map<std::string, std::string>;

/// A file that was not written, and why, in words that follow its name.
struct RefusedFile {
    std::string name;
    std::string reason;
};

/// Those names of `files` under which something stands already that `scene` did not write, or that was
/// changed since; not those that are the same as they would be, or empty. They are not to be replaced unless
/// the user was asked for each.
std::set<std::string> foreignFiles(const std::filesystem::path& scene, const WrittenFiles& files,
                                   const WrittenRecord& record);

/// Writes what a text says by `#write` in the folder of its own file `scene` and nowhere else, each file
/// whole. Names that are absolute or lead out of the folder are refused, and so are the scene itself, what is
/// no plain file, and foreign files but those in `replaceable`. Folders are not made. Call it only where the
/// user has allowed it. Returns what was not written; the rest is added to `record`.
std::vector<RefusedFile> writeBeside(const std::filesystem::path& scene, const WrittenFiles& files,
                                     WrittenRecord& record, const std::set<std::string>& replaceable = {});

}  // namespace isoscope
