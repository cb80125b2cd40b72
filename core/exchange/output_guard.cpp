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
            return {{renderSettingsMark}, "stands there already and holds no settings that Isoscope exported"};
        case OutputKind::scene: break;
    }
    return {{exportMark}, "stands there already and is no scene that Isoscope exported"};
}

}  // namespace

std::string whyNotReplaced(const fs::path& file, OutputKind kind) {
    std::error_code failed;
    if (!fs::is_regular_file(file, failed) || fs::file_size(file, failed) == 0) return {};
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
