// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/text/scene_file.h"

#include <algorithm>
#include <exception>
#include <fstream>
#include <system_error>

namespace isoscope {

std::optional<std::string> readSceneText(const std::filesystem::path& file, std::string& problem) {
    problem = "The file `" + file.string() + "` cannot be read.";
    std::error_code failed;
    if (!std::filesystem::is_regular_file(file, failed)) return std::nullopt;
    const std::uintmax_t size = std::filesystem::file_size(file, failed);
    if (failed) return std::nullopt;
    if (size > sceneFileLimit) {
        problem = "The file `" + file.string() + "` is larger than 128 MB.";
        return std::nullopt;
    }
    try {
        // Files of the system say that they are empty.
        constexpr std::uintmax_t piece = 1 << 16;
        std::string text;
        std::ifstream input(file, std::ios::binary);
        while (input && text.size() <= sceneFileLimit) {
            const std::size_t before = text.size();
            text.resize(before + std::max(piece, size + 1 - std::min<std::uintmax_t>(size, before)));
            input.read(text.data() + before, static_cast<std::streamsize>(text.size() - before));
            text.resize(before + static_cast<std::size_t>(input.gcount()));
        }
        if (!input.eof() || input.bad()) return std::nullopt;
        problem.clear();
        return text;
    } catch (const std::exception&) {
        return std::nullopt;
    }
}

}  // namespace isoscope
