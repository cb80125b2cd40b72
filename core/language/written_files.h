// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace isoscope {

/// Writes what a text says by `#write` (ParseResult::writtenFiles), in the folder of its own file `scene` and
/// nowhere else: names that are absolute or lead out of it are refused, and so are the scene itself and what
/// is no plain file. Folders are not made. Call it only where the user has allowed it. Returns the names that
/// could not be written.
std::vector<std::string> writeBeside(const std::filesystem::path& scene,
                                     const std::map<std::string, std::string>& files);

}  // namespace isoscope
