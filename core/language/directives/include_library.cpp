// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/language/directives/include_library.h"

#include <algorithm>
#include <fstream>
#include <iterator>

#include "core/language/directives/native_includes.h"
#include "core/language/directives/read_permission.h"

namespace isoscope {

namespace {

namespace fs = std::filesystem;

const NativeInclude* findNative(std::string_view name) {
    for (const NativeInclude& include : nativeIncludes())
        if (include.name == name) return &include;
    return nullptr;
}

}  // namespace

bool IncludeLibrary::isNative(std::string_view name) { return findNative(name) != nullptr; }

std::vector<std::string> IncludeLibrary::nativeNames() {
    std::vector<std::string> names;
    for (const NativeInclude& include : nativeIncludes()) names.emplace_back(include.name);
    std::sort(names.begin(), names.end());
    return names;
}

IncludeLibrary::Found IncludeLibrary::find(std::string_view name, std::uint32_t includer) {
    if (name.empty()) return {{}, "`#include` needs the name of a file.", {}};
    if (const NativeInclude* native = findNative(name)) {
        const auto [entry, isNew] = known_.try_emplace("native:" + std::string(name), 0);
        if (isNew) entry->second = context_.sources.add(std::string(name), std::string(native->text));
        return {entry->second, {}, {}};
    }
    std::string slashed(name);
    std::replace(slashed.begin(), slashed.end(), '\\', '/');
    if (slashed.find('\0') != std::string::npos) return {{}, "A file name cannot hold a NUL character.", {}};
    if (const std::string* written = context_.textFiles.written(std::string(name))) {
        const auto [entry, isNew] = known_.try_emplace("written:" + std::string(name), 0);
        if (isNew || context_.sources[entry->second].text() != *written)
            entry->second = context_.sources.add(std::string(name), *written);
        return {entry->second, {}, {}};
    }
    const fs::path wanted(slashed);
    const ReadPermission permission(context_.options);
    bool refused = false;
    for (const fs::path& place : searchedFolders(context_, includer)) {
        std::error_code failed;
        const fs::path candidate = placedFile(place, wanted);
        if (!permission.allows(candidate))
            refused = true;
        else if (fs::is_regular_file(candidate, failed))
            return read(candidate);
    }
    if (refused) return {{}, ReadPermission::refusal(std::string(name)), ReadPermission::hint()};
    const std::string close = closestName(slashed, nativeNames());
    return {{},
            "The include file \"" + std::string(name) +
                "\" was not found beside the including file, beside the scene or in the library paths.",
            close.empty() ? "put it beside the scene or add its folder to the library paths"
                          : "did you mean \"" + close + "\"?"};
}

IncludeLibrary::Found IncludeLibrary::read(const fs::path& path) {
    const auto known = known_.find(path.string());
    if (known != known_.end()) return {known->second, {}, {}};
    std::error_code failed;
    const std::uintmax_t size = fs::file_size(path, failed);
    if (!failed && size > fileSizeLimit)
        return {{}, "The include file \"" + path.string() + "\" is larger than 64 MB.", {}};
    std::ifstream input(path, std::ios::binary);
    if (failed || !input) return {{}, "The include file \"" + path.string() + "\" cannot be read.", {}};
    std::string text{std::istreambuf_iterator<char>(input), {}};
    const std::uint32_t file = context_.sources.add(path.string(), std::move(text));
    known_.emplace(path.string(), file);
    return {file, {}, {}};
}

}  // namespace isoscope
