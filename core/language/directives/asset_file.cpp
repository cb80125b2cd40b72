// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/language/directives/asset_file.h"

#include <algorithm>

#include "core/language/directives/read_permission.h"

namespace isoscope {

AssetFile findAsset(const ParseContext& context, std::string_view name, const SourceRange& range) {
    namespace fs = std::filesystem;
    std::string slashed(name);
    std::replace(slashed.begin(), slashed.end(), '\\', '/');
    if (slashed.empty() || slashed.find('\0') != std::string::npos) return {};
    const fs::path wanted(slashed);
    const ReadPermission permission(context.options);
    AssetFile asset;
    for (const fs::path& place : searchedFolders(context, range.file)) {
        std::error_code failed;
        const fs::path candidate = placedFile(place, wanted);
        if (!permission.allows(candidate)) {
            asset.problem = ReadPermission::refusal(std::string(name));
            asset.hint = ReadPermission::hint();
        } else if (fs::is_regular_file(candidate, failed)) {
            return {candidate, {}, {}};
        }
    }
    return asset;
}

}  // namespace isoscope
