// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/exchange/output_guard.h"

#include <algorithm>
#include <array>
#include <fstream>
#include <string_view>
#include <vector>

namespace isoscope {

namespace {

namespace fs = std::filesystem;

constexpr std::string_view exportMark = "// Exported by Isoscope";
constexpr std::string_view pngSignature = "\x89PNG\r\n\x1a\n";
constexpr std::string_view exrSignature = "\x76\x2f\x31\x01";
/// The first entry of the statistics that `render --statistics` writes.
constexpr std::string_view statisticsMark = "{\n  \"render_cpu_seconds\"";

/// The first columns of what `roots --proof` writes.
constexpr std::string_view proofMark = "case_id,rule,from,to,";

struct Expected {
    std::vector<std::string_view> beginnings;
    const char* whatItIsNot;
};

Expected expectedOf(OutputKind kind) {
    switch (kind) {
        case OutputKind::picture:
            return {{pngSignature, exrSignature}, "stands there already and is no PNG or OpenEXR picture"};
        case OutputKind::statistics:
            return {{statisticsMark}, "stands there already and holds no statistics of a picture"};
        case OutputKind::renderSettings:
            return {{renderSettingsMark},
                    "stands there already and holds no settings that Isoscope exported"};
        case OutputKind::scene:
        case OutputKind::mesh: break;
        case OutputKind::proof: return {{proofMark}, "stands there already and is no table of proofs"};
    }
    return {{exportMark}, "stands there already and is no scene that Isoscope exported"};
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
    std::ifstream input(file, std::ios::binary);
    std::array<char, 64> bytes{};
    input.read(bytes.data(), static_cast<std::streamsize>(bytes.size()));
    const std::string_view beginning(bytes.data(), static_cast<std::size_t>(input.gcount()));
    const bool ours = std::any_of(expected.beginnings.begin(), expected.beginnings.end(),
                                  [&](std::string_view one) { return beginning.starts_with(one); });
    return ours ? std::string() : expected.whatItIsNot;
}

std::string markedExport(const std::string& text) {
    if (text.starts_with(exportMark)) return text;
    return std::string(exportMark) + "; the next export to this file replaces it.\n" + text;
}

}  // namespace isoscope
