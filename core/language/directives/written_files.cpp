// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/language/directives/written_files.h"

#include <algorithm>
#include <fstream>
#include <iterator>
#include <optional>

#include "core/text/whole_file.h"

namespace isoscope {

namespace {

namespace fs = std::filesystem;

const char* const notBeside = "the file cannot be written beside the scene";

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

/// Where the text may write this name; empty when nowhere.
fs::path placeOf(const fs::path& scene, const std::string& name) {
    if (scene.empty() || name.find('\0') != std::string::npos) return {};
    std::string slashed(name);
    std::replace(slashed.begin(), slashed.end(), '\\', '/');
    const fs::path wanted(slashed);
    std::error_code failed;
    const fs::path folder = fs::absolute(scene, failed).parent_path(), place = folder / wanted;
    if (failed || !staysInside(wanted) || isLink(folder, wanted)) return {};
    if (fs::equivalent(place, scene, failed)) return {};
    if (fs::exists(place, failed) && !fs::is_regular_file(place, failed)) return {};
    return place;
}

std::optional<std::string> contentOf(const fs::path& file) {
    std::ifstream input(file, std::ios::binary);
    if (!input) return std::nullopt;
    return std::string{std::istreambuf_iterator<char>(input), {}};
}

bool isForeign(const fs::path& scene, const fs::path& place, const std::string& content,
               const WrittenRecord& record) {
    std::error_code failed;
    if (!fs::exists(place, failed)) return false;
    const std::optional<std::string> before = contentOf(place);
    if (before && (before->empty() || *before == content)) return false;
    return !record.holds(scene, place);
}

/// Why not; empty when it was written.
std::string writeFile(const fs::path& scene, const std::string& name, const std::string& content,
                      WrittenRecord& record, bool replaceable) {
    const fs::path place = placeOf(scene, name);
    if (place.empty()) return notBeside;
    if (!replaceable && isForeign(scene, place, content, record))
        return "stands there already and was not written by this scene";
    if (contentOf(place) == content) return {};
    const std::string reason = writeWhole(place, content, {.durable = false});  // made again at any time
    if (!reason.empty()) return std::string(notBeside) + ": " + reason;
    record.add(scene, place, content);
    return {};
}

}  // namespace

std::set<std::string> foreignFiles(const fs::path& scene, const WrittenFiles& files,
                                   const WrittenRecord& record) {
    std::set<std::string> foreign;
    for (const auto& [name, content] : files)
        if (const fs::path place = placeOf(scene, name);
            !place.empty() && isForeign(scene, place, content, record))
            foreign.insert(name);
    return foreign;
}

std::vector<RefusedFile> writeBeside(const fs::path& scene, const WrittenFiles& files, WrittenRecord& record,
                                     const std::set<std::string>& replaceable) {
    std::vector<RefusedFile> refused;
    for (const auto& [name, content] : files) {
        std::string reason = writeFile(scene, name, content, record, replaceable.contains(name));
        if (!reason.empty()) refused.push_back({name, std::move(reason)});
    }
    return refused;
}

}  // namespace isoscope
