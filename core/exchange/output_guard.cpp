// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/exchange/output_guard.h"

#include <algorithm>
#include <fstream>
#include <string_view>

namespace isoscope {

namespace {

namespace fs = std::filesystem;

constexpr std::string_view exportMark = "// Exported by Isoscope";
constexpr std::string_view pngSignature = "\x89PNG\r\n\x1a\n";
/// The first entry of the statistics that `render --statistics` writes.
constexpr std::string_view statisticsMark = "{\n  \"render_cpu_seconds\"";

struct Expected {
    std::string_view beginning;
    const char* whatItIsNot;
};

Expected expectedOf(OutputKind kind) {
    switch (kind) {
        case OutputKind::picture: return {pngSignature, "stands there already and is no PNG picture"};
        case OutputKind::statistics:
            return {statisticsMark, "stands there already and holds no statistics of a picture"};
        case OutputKind::scene:
        case OutputKind::mesh: break;
    }
    return {exportMark, "stands there already and is no scene that Isoscope exported"};
}

/// Whether a file bears the program's name near its beginning, or at its end, where archives have a comment.
bool isOwnMesh(const fs::path& file) {
    constexpr std::string_view name = "Isoscope";
    constexpr std::size_t room = 256;
    std::ifstream input(file, std::ios::binary);
    std::string part(room, '\0');
    const auto bears = [&] {
        input.read(part.data(), room);
        return std::string_view(part).substr(0, static_cast<std::size_t>(input.gcount())).find(name) !=
               std::string_view::npos;
    };
    if (bears()) return true;
    input.clear();
    input.seekg(-std::min<std::streamoff>(room, static_cast<std::streamoff>(fs::file_size(file))),
                std::ios::end);
    return bears();
}

}  // namespace

std::string whyNotReplaced(const fs::path& file, OutputKind kind) {
    std::error_code failed;
    if (!fs::is_regular_file(file, failed) || fs::file_size(file, failed) == 0) return {};
    if (kind == OutputKind::mesh)
        return isOwnMesh(file) ? std::string() : "stands there already and is no mesh that Isoscope exported";
    const Expected expected = expectedOf(kind);
    std::string beginning(expected.beginning.size(), '\0');
    std::ifstream input(file, std::ios::binary);
    input.read(beginning.data(), static_cast<std::streamsize>(beginning.size()));
    return input && beginning == expected.beginning ? std::string() : expected.whatItIsNot;
}

std::string markedExport(const std::string& text) {
    if (text.starts_with(exportMark)) return text;
    return std::string(exportMark) + "; the next export to this file replaces it.\n" + text;
}

}  // namespace isoscope
