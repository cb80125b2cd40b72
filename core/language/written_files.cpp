// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/language/written_files.h"

#include <algorithm>
#include <fstream>

namespace isoscope {

namespace {

namespace fs = std::filesystem;

bool staysInside(const fs::path& name) {
    return !name.empty() && name.is_relative() && name.has_filename() &&
           std::none_of(name.begin(), name.end(), [](const fs::path& part) { return part == ".."; });
}

/// Links could lead anywhere.
bool isLink(const fs::path& folder, const fs::path& name) {
    fs::path place = folder;
    std::error_code failed;
    return std::any_of(name.begin(), name.end(), [&](const fs::path& part) {
        place /= part;
        return fs::is_symlink(place, failed);
    });
}

bool writeFile(const fs::path& scene, const std::string& name, const std::string& content) {
    if (scene.empty() || name.find('\0') != std::string::npos) return false;
    std::string slashed(name);
    std::replace(slashed.begin(), slashed.end(), '\\', '/');
    const fs::path wanted(slashed);
    std::error_code failed;
    const fs::path folder = fs::absolute(scene, failed).parent_path(), place = folder / wanted;
    if (failed || !staysInside(wanted) || isLink(folder, wanted)) return false;
    if (fs::equivalent(place, scene, failed)) return false;
    if (fs::exists(place, failed) && !fs::is_regular_file(place, failed)) return false;
    std::ofstream output(place, std::ios::binary | std::ios::trunc);
    output << content;
    return static_cast<bool>(output.flush());
}

}  // namespace

std::vector<std::string> writeBeside(const fs::path& scene, const std::map<std::string, std::string>& files) {
    std::vector<std::string> refused;
    for (const auto& [name, content] : files)
        if (!writeFile(scene, name, content)) refused.push_back(name);
    return refused;
}

}  // namespace isoscope
