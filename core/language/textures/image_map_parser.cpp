// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/language/textures/image_map_parser.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/language/directives/asset_file.h"
#include "core/language/expressions/expression_parser.h"
#include "core/language/scene_draft.h"
#include "core/language/tokens/povray_refusals.h"
#include "core/texture/image_file.h"

namespace isoscope {

std::shared_ptr<const ImageMap> ImageMapParser::parse() {
    if (!tokens_.expect("{", "to begin `image_map`")) return nullptr;
    bool understood = parseFile();
    while (understood && !tokens_.peek().is("}")) {
        const Token word = tokens_.peek();
        understood = parseSetting();
        if (!understood)
            tokens_.context().error("unknown-item", word.range,
                                    describe(word) + " is not understood in `image_map`.");
    }
    if (!understood) {
        tokens_.skipBlock();
        return nullptr;
    }
    tokens_.next();
    return read();
}

/// False for files that cannot be read, which is reported.
bool ImageMapParser::parseKind() {
    static constexpr std::array<const char*, 9> read{"png", "bmp",  "gif",  "tga", "pgm",
                                                     "ppm", "jpeg", "tiff", "sys"};
    static constexpr std::array<const char*, 4> notRead{"exr", "hdr", "iff", "function"};
    for (const char* word : read)
        if (tokens_.accept(word)) {
            ending_ = word;
            break;
        }
    for (const char* word : notRead)
        if (tokens_.peek().is(word)) {
            reportLeftOut(tokens_.context(), tokens_.peek().range,
                          "Images of the kind `" + std::string(word) + "` are not shown.");
            return false;
        }
    return true;
}

bool ImageMapParser::parseFile() {
    if (!parseKind()) return false;
    range_ = tokens_.peek().range;
    ExpressionParser expressions(tokens_);
    if (tokens_.peek().is("}")) {
        tokens_.context().error("no-file", range_, "Expected the name of a file here.");
        return false;
    }
    if (!expressions.atExpression()) {
        reportLeftOut(tokens_.context(), range_, "This image is not shown: only those from files are.");
        return false;
    }
    name_ = expressions.parseString();
    range_ = rangeSince(range_, tokens_);
    AssetFile file = findAsset(tokens_.context(), name_, range_);
    // POV-Ray then tries the usual ending of the kind.
    if (!file && file.problem.empty())
        if (AssetFile whole = findAsset(tokens_.context(), name_ + "." + ending_, range_)) file = whole;
    if (file)
        file_ = *file;
    else
        tokens_.context().error("no-file", range_, file.whyNot("There is no file `" + name_ + "`."),
                                file.hint);
    return bool(file);
}

std::shared_ptr<const ImageMap> ImageMapParser::read() {
    ParseContext& context = tokens_.context();
    // assumed_gamma may follow later in the text; scenes of version 3.7 say it first.
    const bool isNew = context.languageVersion >= 370;
    const ImageColors colors{context.assumedGamma, gamma_, isNew || context.hasAssumedGamma, isNew,
                             premultiplied_};
    std::string key = file_.string() + "|" + std::to_string(colors.assumedGamma) + "|" +
                      std::to_string(gamma_.value_or(-1)) + (colors.trustsFile ? "|trusted" : "|") +
                      (isNew ? "|new" : "|");
    if (premultiplied_) key += *premultiplied_ ? "|darkened" : "|plain";
    std::shared_ptr<const ImageMap>& known = context.images[key];
    if (!known) {
        std::string problem;
        std::optional<ImageMap> content = readImageMap(file_, colors, problem);
        if (!content) {
            reportLeftOut(context, range_, "The image `" + name_ + "` is not shown: " + problem + ".");
            return nullptr;
        }
        known = std::make_shared<const ImageMap>(std::move(*content));
    }
    auto image = std::make_shared<ImageMap>(*known);
    image->type = settings_.type;
    image->interpolation = settings_.interpolation;
    image->once = settings_.once;
    makeTransparent(*image);
    return image;
}

bool ImageMapParser::parseSetting() {
    ExpressionParser expressions(tokens_);
    if (tokens_.accept("once")) {
        settings_.once = true;
    } else if (tokens_.accept("map_type")) {
        const double type = expressions.parseFloat();
        settings_.type = type == 1   ? ImageMapType::spherical
                         : type == 2 ? ImageMapType::cylindrical
                         : type == 5 ? ImageMapType::torus
                                     : ImageMapType::planar;
        if (settings_.type == ImageMapType::planar && type != 0) leftOut_.emplace_back("map_type");
    } else if (tokens_.accept("interpolate")) {
        const double kind = expressions.parseFloat();
        settings_.interpolation = kind == 2   ? ImageInterpolation::bilinear
                                  : kind == 3 ? ImageInterpolation::bicubic
                                  : kind == 4 ? ImageInterpolation::distance
                                              : ImageInterpolation::none;
    } else if (tokens_.accept("filter")) {
        parseTransparency(3);
    } else if (tokens_.accept("transmit")) {
        parseTransparency(4);
    } else if (tokens_.accept("use_color") || tokens_.accept("use_colour")) {
        usesIndex_ = usesAlpha_ = false;
    } else if (tokens_.accept("use_index")) {
        usesIndex_ = true;
    } else if (tokens_.accept("use_alpha")) {
        usesAlpha_ = true;
    } else if (tokens_.accept("gamma")) {
        parseGamma();
    } else if (tokens_.accept("premultiplied")) {
        premultiplied_ = !expressions.atExpression() || expressions.parseBool();
    } else {
        return false;
    }
    return true;
}

void ImageMapParser::parseGamma() {
    if (tokens_.accept("srgb")) {
        gamma_ = srgbGamma;
        return;
    }
    const double gamma = ExpressionParser(tokens_).parseFloat();
    if (gamma > 0)
        gamma_ = gamma;
    else
        tokens_.context().error("bad-value", tokens_.lastRange(), "A gamma must be greater than 0.");
}

/// `filter all 0.5` or `filter INDEX, 0.5`.
void ImageMapParser::parseTransparency(std::size_t channel) {
    ExpressionParser expressions(tokens_);
    Transparency transparency;
    transparency.channel = channel;
    if (!tokens_.accept("all"))
        transparency.index = static_cast<int>(std::clamp(expressions.parseFloat(), -1.0, 256.0));
    tokens_.accept(",");
    const double amount = expressions.parseFloat(), limit = transparencyLimit;
    if (std::isfinite(amount)) transparency.amount = static_cast<float>(std::clamp(amount, -limit, limit));
    transparencies_.push_back(transparency);
}

void ImageMapParser::makeTransparent(ImageMap& image) const {
    if (transparencies_.empty()) return;
    auto samples = std::make_shared<std::vector<ImageMap::Sample>>(*image.samples);
    for (const Transparency& transparency : transparencies_) {
        if (transparency.index && !image.indices) {
            warnOfRefusal(tokens_.context(), range_,
                          "wants a palette in `" + name_ + "` for the number of a colour.",
                          "say `all` for the whole image");
            continue;
        }
        for (std::size_t i = 0; i < samples->size(); ++i) {
            ImageMap::Sample& sample = (*samples)[i];
            const float darkening = darkeningOf(image, sample);
            float& value = sample[transparency.channel];
            // What the alpha channel lets through is let through as well; a palette's entries are replaced.
            if (!transparency.index)
                value = std::clamp(transparency.amount + (image.indices ? 0 : value), -transparencyLimit,
                                   transparencyLimit);
            else if ((*image.indices)[i] == *transparency.index)
                value = transparency.amount;
            for (std::size_t c = 0; c < 3; ++c) sample[c] *= darkening / darkeningOf(image, sample);
        }
    }
    image.samples = std::move(samples);
}

}  // namespace isoscope
