// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <vector>

namespace isoscope {

/// Where an installed POV-Ray keeps its include files, most recent version first: the folders named by the
/// environment variable POVRAY_LIBRARY_PATH (separated by `:`), then `povray*/include` in each of `shares`.
/// Empty when there is none. Never throws.
std::vector<std::filesystem::path> installedLibraryPaths(const std::vector<std::filesystem::path>& shares = {
                                                             "/usr/local/share", "/usr/share", "/opt/share"});

}  // namespace isoscope
