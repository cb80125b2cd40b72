// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/exchange/output_guard.h"

#include <fstream>
#include <string_view>

namespace isoscope {

namespace {

namespace fs = std::filesystem;

constexpr std::string_view exportMark = "// Exported by Isoscope";
constexpr std::string_view pngSignature = "\x89PNG\r\n\x1a\n";
/// The first entry of the statistics that `render --statistics` writes.
constexpr std::string_view statisticsMark = "{\n  \"render_cpu_seconds\"";

/// The first columns of what `roots --proof` writes.
constexpr std::string_view proofMark = "case_id,rule,from,to,";

struct Expected {
    std::string_view beginning;
    const char* whatItIsNot;
};

Expected expectedOf(OutputKind kind) {
    switch (kind) {
        case OutputKind::picture: return {pngSignature, "stands there already and is no PNG picture"};
        case OutputKind::statistics:
            return {statisticsMark, "stands there already and holds no statistics of a picture"};
        case OutputKind::proof: return {proofMark, "stands there already and is no table of proofs"};
        case OutputKind::scene: break;
    }
    return {exportMark, "stands there already and is no scene that Isoscope exported"};
}

}  // namespace

std::string whyNotReplaced(const fs::path& file, OutputKind kind) {
    std::error_code failed;
    if (!fs::is_regular_file(file, failed) || fs::file_size(file, failed) == 0) return {};
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
