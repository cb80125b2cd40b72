// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/exchange/read_scene.h"

#include <fstream>
#include <sstream>

#include "core/virtualight/scene_reader.h"

namespace isoscope {

ParseResult readScene(std::string text, ParseOptions options) {
    if (virtualight::isVirtualight(options.file, text))
        return virtualight::parseVirtualight(std::move(text), std::move(options));
    return parseScene(std::move(text), std::move(options));
}

ParseResult readSceneFile(const std::filesystem::path& file, ParseOptions options) {
    try {
        std::ostringstream text;
        std::ifstream input(file, std::ios::binary);
        if (input && std::filesystem::is_regular_file(file) && (text << input.rdbuf(), !input.bad()) &&
            virtualight::isVirtualight(file, text.view())) {
            if (options.file.empty()) options.file = file;
            return virtualight::parseVirtualight(std::move(text).str(), std::move(options));
        }
    } catch (const std::exception&) {
        // Whatever the reason, the reader below says that the file cannot be read.
    }
    return parseSceneFile(file, std::move(options));
}

}  // namespace isoscope
