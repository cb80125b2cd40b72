// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/language/image_map_parser.h"

#include <algorithm>
#include <array>

#include "core/language/asset_file.h"
#include "core/language/expression_parser.h"
#include "core/language/scene_draft.h"
#include "core/texture/image_file.h"

namespace isoscope {

std::shared_ptr<const ImageMap> ImageMapParser::parse() {
    if (!tokens_.expect("{", "to begin `image_map`")) return nullptr;
    auto image = std::make_shared<ImageMap>();
    bool understood = parseFile(*image);
    while (understood && !tokens_.peek().is("}")) understood = parseSetting(*image);
    if (understood) {
        tokens_.next();
        return image;
    }
    tokens_.skipBlock();
    return nullptr;
}

bool ImageMapParser::parseFile(ImageMap& image) {
    static constexpr std::array<const char*, 9> read{"png", "bmp",  "gif",  "tga", "pgm",
                                                     "ppm", "jpeg", "tiff", "sys"};
    static constexpr std::array<const char*, 4> notRead{"exr", "hdr", "iff", "function"};
    for (const char* word : read)
        if (tokens_.accept(word)) break;
    for (const char* word : notRead)
        if (tokens_.peek().is(word)) {
            reportLeftOut(tokens_.context(), tokens_.peek().range,
                          "Images of the kind `" + std::string(word) + "` are not shown.");
            return false;
        }
    const SourceRange start = tokens_.peek().range;
    ExpressionParser expressions(tokens_);
    if (!expressions.atExpression()) {
        reportLeftOut(tokens_.context(), start, "This image is not shown.");
        return false;
    }
    const std::string name = expressions.parseString();
    const SourceRange range = rangeSince(start, tokens_);
    const auto file = findAsset(tokens_.context(), name, range);
    if (!file) {
        tokens_.context().error("no-file", range, "There is no file `" + name + "`.");
        return false;
    }
    std::shared_ptr<const ImageMap>& known = tokens_.context().images[file->string()];
    if (known) {
        image = *known;
        return true;
    }
    std::string problem;
    // assumed_gamma may follow later in the text; scenes of version 3.7 say it first.
    std::optional<ImageMap> content = readImageMap(*file, tokens_.context().assumedGamma, problem);
    if (content) {
        image = std::move(*content);
        known = std::make_shared<const ImageMap>(image);
        return true;
    }
    reportLeftOut(tokens_.context(), range, "The image `" + name + "` is not shown: " + problem + ".");
    return false;
}

bool ImageMapParser::parseSetting(ImageMap& image) {
    ExpressionParser expressions(tokens_);
    const Token word = tokens_.peek();
    if (tokens_.accept("once")) {
        image.once = true;
    } else if (tokens_.accept("map_type")) {
        const double type = expressions.parseFloat();
        image.type = type == 1   ? ImageMapType::spherical
                     : type == 2 ? ImageMapType::cylindrical
                     : type == 5 ? ImageMapType::torus
                                 : ImageMapType::planar;
        if (image.type == ImageMapType::planar && type != 0) leftOut_.emplace_back("map_type");
    } else if (tokens_.accept("interpolate")) {
        const double kind = expressions.parseFloat();
        image.interpolation = kind >= 2 ? ImageInterpolation::bilinear : ImageInterpolation::none;
        if (kind > 2)
            leftOut_.emplace_back("interpolate " + std::to_string(static_cast<int>(std::min(kind, 9.0))));
    } else if (tokens_.accept("filter")) {
        parseTransparency(3, image);
    } else if (tokens_.accept("transmit")) {
        parseTransparency(4, image);
    } else if (tokens_.accept("use_color") || tokens_.accept("use_colour") || tokens_.accept("use_index")) {
        return true;
    } else if (tokens_.accept("gamma") || tokens_.accept("premultiplied")) {
        leftOut_.emplace_back(word.text);
        if (!tokens_.accept("srgb") && expressions.atExpression()) expressions.parseFloat();
    } else {
        tokens_.context().error("unknown-item", word.range,
                                describe(word) + " is not understood in `image_map`.");
        return false;
    }
    return true;
}

/// `filter all 0.5` or `filter INDEX, 0.5`.
void ImageMapParser::parseTransparency(std::size_t channel, ImageMap& image) {
    ExpressionParser expressions(tokens_);
    const bool all = tokens_.accept("all");
    if (!all) expressions.parseFloat();
    tokens_.accept(",");
    const double amount = expressions.parseFloat();
    if (!all) {
        leftOut_.emplace_back(channel == 3 ? "filter" : "transmit");
        return;
    }
    auto samples = std::make_shared<std::vector<ImageMap::Sample>>(*image.samples);
    // What the alpha channel lets through is let through as well.
    for (ImageMap::Sample& sample : *samples) sample[channel] += static_cast<float>(amount);
    image.samples = std::move(samples);
}

}  // namespace isoscope
