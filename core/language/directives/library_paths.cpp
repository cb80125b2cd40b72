// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/language/directives/library_paths.h"

#include <algorithm>
#include <cstdlib>
#include <sstream>
#include <string>

namespace isoscope {

namespace fs = std::filesystem;

std::vector<fs::path> installedLibraryPaths(const std::vector<fs::path>& shares) {
    std::vector<fs::path> paths;
    std::error_code ignored;
    if (const char* variable = std::getenv("POVRAY_LIBRARY_PATH")) {
        std::istringstream list(variable);
        for (std::string folder; std::getline(list, folder, ':');)
            if (fs::is_directory(folder, ignored)) paths.emplace_back(folder);
    }
    for (const fs::path& share : shares) {
        std::vector<fs::path> found;
        for (fs::directory_iterator it(share, ignored), end; it != end; it.increment(ignored)) {
            const fs::path include = it->path() / "include";
            const bool isPovRay = it->path().filename().string().rfind("povray", 0) == 0;
            if (isPovRay && fs::is_directory(include, ignored)) found.push_back(include);
        }
        std::sort(found.rbegin(), found.rend());
        paths.insert(paths.end(), found.begin(), found.end());
    }
    return paths;
}

}  // namespace isoscope
