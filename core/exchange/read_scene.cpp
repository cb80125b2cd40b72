// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/exchange/read_scene.h"

#include <optional>
#include <utility>

#include "core/text/scene_file.h"
#include "core/virtualight/scene_reader.h"

namespace isoscope {

ParseResult readScene(std::string text, ParseOptions options) {
    if (virtualight::isVirtualight(options.file, text))
        return virtualight::parseVirtualight(std::move(text), std::move(options));
    return parseScene(std::move(text), std::move(options));
}

ParseResult readSceneFile(const std::filesystem::path& file, ParseOptions options) {
    if (options.file.empty()) options.file = file;
    std::string problem;
    std::optional<std::string> text = readSceneText(file, problem);
    if (!text) return parseSceneFile(file, std::move(options));  // says why not
    if (virtualight::isVirtualight(file, *text))
        return virtualight::parseVirtualight(std::move(*text), std::move(options));
    return parseScene(std::move(*text), std::move(options));
}

}  // namespace isoscope
