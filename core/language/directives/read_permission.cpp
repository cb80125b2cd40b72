// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/language/directives/read_permission.h"

#include <algorithm>

namespace isoscope {

namespace {

namespace fs = std::filesystem;

/// Absolute, without `.`, `..` and a slash at its end.
fs::path plain(const fs::path& path) {
    std::error_code failed;
    fs::path absolute = fs::absolute(path.empty() ? fs::path(".") : path, failed).lexically_normal();
    return absolute.has_filename() ? absolute : absolute.parent_path();
}

bool liesIn(const fs::path& file, const fs::path& folder) {
    return std::mismatch(folder.begin(), folder.end(), file.begin(), file.end()).first == folder.end();
}

/// The same with links followed; empty when that fails.
fs::path real(const fs::path& path) {
    std::error_code failed;
    const fs::path found = fs::weakly_canonical(path, failed);
    return failed ? fs::path() : found;
}

}  // namespace

bool ReadPermission::allows(const fs::path& file) const {
    if (!options_.restrictedReading) return true;
    const fs::path wanted = plain(file), linked = real(wanted);
    if (linked.empty()) return false;
    const auto chosen = [&](const fs::path& folder) {
        return liesIn(wanted, plain(folder)) || liesIn(linked, real(plain(folder)));
    };
    if (std::any_of(options_.libraryPaths.begin(), options_.libraryPaths.end(), chosen)) return true;
    if (std::any_of(options_.readableFolders.begin(), options_.readableFolders.end(), chosen)) return true;
    const fs::path own = options_.file.parent_path();
    return liesIn(linked, real(plain(own)));
}

std::string ReadPermission::refusal(const std::string& name) {
    return "The file `" + name +
           "` is not read: it lies outside the scene's folder, the library paths and the folders that you "
           "allow.";
}

std::string ReadPermission::hint() {
    return "`--allow-read FOLDER` of the command line, or the include folders of the window, allow a folder";
}

std::vector<fs::path> searchedFolders(const ParseContext& context, std::uint32_t includer) {
    std::vector<fs::path> folders;
    if (includer < context.sources.size())
        if (fs::path beside = fs::path(context.sources[includer].name()).parent_path(); !beside.empty())
            folders.push_back(std::move(beside));
    folders.push_back(context.options.file.parent_path());
    const auto& libraries = context.options.libraryPaths;
    folders.insert(folders.end(), libraries.begin(), libraries.end());
    return folders;
}

fs::path placedFile(const fs::path& place, const fs::path& name) {
    return (name.is_absolute() ? name : place / name).lexically_normal();
}

}  // namespace isoscope
