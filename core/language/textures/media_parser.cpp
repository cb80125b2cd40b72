// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/language/textures/media_parser.h"

#include <algorithm>
#include <array>
#include <map>
#include <string>
#include <utility>

#include "core/language/expressions/declared_value.h"
#include "core/language/expressions/expression_parser.h"
#include "core/language/objects/transform_parser.h"
#include "core/language/statement_description.h"
#include "core/language/textures/color_start.h"
#include "core/language/textures/pigment_parser.h"
#include "core/language/tokens/block_words.h"
#include "core/language/tokens/unknown_name.h"
#include "core/texture/surface_needs.h"

namespace isoscope {

namespace {

/// Of one medium; more are passed over.
constexpr std::size_t densitiesLimit = 50;

}  // namespace

std::shared_ptr<const Medium> MediaParser::parse() {
    const SourceRange start = tokens_.lastRange();
    tokens_.charge(TokenStream::stepsPerItem, start);
    const SourceLibrary& sources = tokens_.context().sources;
    if (tokens_.expect("{", "to begin `media`"))
        while (!tokens_.accept("}")) {
            if (parseItem()) {
                begun_ = true;
                continue;
            }
            const Token token = tokens_.peek();
            if (token.kind == TokenKind::end) {
                tokens_.expect("}", "to close `media`");
                break;
            }
            passUnknownItem(tokens_, "media");
        }
    if (start.file < sources.size()) medium_.line = sources[start.file].position(start.begin).line;
    limitSamples(start);
    for (const Material& density : densities_)
        for (const std::string& word : notSimulatedIn(density.pigment))
            reportLeftOut(tokens_.context(), rangeSince(start, tokens_),
                          "The density pattern `" + word + "` counts as one colour.");
    if (!densities_.empty())
        medium_.densities = std::make_shared<const std::vector<Material>>(std::move(densities_));
    return std::make_shared<const Medium>(std::move(medium_));
}

void MediaParser::parseInto(std::vector<std::shared_ptr<const Medium>>& media) {
    const SourceRange word = tokens_.lastRange();
    std::shared_ptr<const Medium> medium = parse();
    if (media.size() < mediaLimit) return media.push_back(std::move(medium));
    reportLeftOut(tokens_.context(), word,
                  "More than " + std::to_string(mediaLimit) + " media fill one space: this one is left out.");
}

/// A ray takes so many samples and no more, so that it ends.
void MediaParser::limitSamples(const SourceRange& place) {
    const int intervals = std::max(1, Medium::allSamplesLimit / medium_.samples);
    if (medium_.intervals <= intervals) return;
    medium_.intervals = intervals;
    reportLeftOut(
        tokens_.context(), place,
        "All `samples` of all `intervals` count up to " + std::to_string(Medium::allSamplesLimit) + " here.");
}

bool MediaParser::parseItem() {
    using MediumPointer = std::shared_ptr<const Medium>;
    if (const std::optional<MediumPointer> declared = takeDeclared<MediumPointer>(tokens_)) {
        if (begun_)
            warnOfRefusal(tokens_.context(), tokens_.lastRange(), "wants a declared medium first in `media`.",
                          "move it to the front");
        if (*declared) medium_ = **declared;
        // What follows may move them or add to them.
        densities_.clear();
        for (std::size_t k = 0; k < medium_.layers(); ++k)
            densities_.push_back(moved((*medium_.densities)[k], medium_.transform));
        medium_.densities = nullptr;
        medium_.transform = Transform();
        return true;
    }
    Transform transform;
    if (TransformParser(tokens_).parseModifier(transform)) {
        for (Material& density : densities_) density = moved(std::move(density), transform);
        return true;
    }
    // As in POV-Ray, no colour is black.
    const auto parseColor = [this] {
        return isWithoutColor(tokens_) ? Color() : ExpressionParser(tokens_).parseColor();
    };
    if (tokens_.accept("absorption"))
        medium_.absorption = parseColor();
    else if (tokens_.accept("emission"))
        medium_.emission = parseColor();
    else if (tokens_.accept("scattering"))
        parseScattering();
    else if (tokens_.accept("density"))
        parseDensity();
    else
        return parseSampling() || parseIgnored();
    return true;
}

void MediaParser::parseScattering() {
    if (!tokens_.expect("{", "to begin `scattering`")) return;
    const SourceRange place = tokens_.peek().range;
    const double kind = ExpressionParser(tokens_).parseFloat();
    if (kind >= 1 && kind < 6)
        medium_.kind = static_cast<ScatteringKind>(static_cast<int>(kind));
    else
        reportLeftOut(tokens_.context(), place,
                      "Scattering types are numbers from 1 to 5; another one counts as 1.");
    tokens_.accept(",");
    medium_.scattering = ExpressionParser(tokens_).parseColor();
    while (!tokens_.accept("}")) {
        if (tokens_.accept("eccentricity")) {
            if (medium_.kind != ScatteringKind::henyeyGreenstein)
                warnOfRefusal(tokens_.context(), tokens_.lastRange(),
                              "takes `eccentricity` with scattering type 5 only.", "leave it out");
            medium_.eccentricity = ExpressionParser(tokens_).parseFloat();
        } else if (tokens_.accept("extinction")) {
            medium_.extinction = ExpressionParser(tokens_).parseFloat();
        } else if (tokens_.peek().kind == TokenKind::end) {
            tokens_.expect("}", "to close `scattering`");
            return;
        } else {
            passUnknownItem(tokens_, "scattering");
        }
    }
}

void MediaParser::parseDensity() {
    Material density;
    density.pigment = withoutSlopes(PigmentParser(tokens_).parse(SolidPigment{{1, 1, 1}, {}}));
    if (densities_.size() < densitiesLimit) densities_.push_back(std::move(density));
}

/// A number of samples and the like; more than `limit` would hardly differ and take for ever.
int MediaParser::parseCount(const char* name, int limit) {
    const SourceRange place = tokens_.peek().range;
    const double count = ExpressionParser(tokens_).parseFloat();
    if (!(count >= 1))
        warnOfRefusal(tokens_.context(), place, "wants at least 1 as `" + std::string(name) + "`.",
                      "write 1 or more");
    if (count > limit)
        reportLeftOut(tokens_.context(), place,
                      "`" + std::string(name) + "` counts up to " + std::to_string(limit) + " here.");
    return count >= 1 ? static_cast<int>(std::min<double>(count, limit)) : 1;
}

bool MediaParser::parseSampling() {
    if (tokens_.accept("method")) {
        const SourceRange place = tokens_.peek().range;
        const double method = ExpressionParser(tokens_).parseFloat();
        if (!(method >= 1 && method < 4))
            warnOfRefusal(tokens_.context(), place, "wants 1, 2 or 3 as `method`.", "write 3");
        medium_.adaptive = method >= 3;
    } else if (tokens_.accept("intervals")) {
        medium_.intervals = parseCount("intervals", Medium::intervalsLimit);
    } else if (tokens_.accept("samples")) {
        medium_.samples = parseCount("samples", Medium::samplesLimit);
        // The most that POV-Ray's other methods may take where samples differ; here the least will do.
        tokens_.accept(",");
        const SourceRange place = tokens_.peek().range;
        if (ExpressionParser most(tokens_); most.atExpression() && most.parseFloat() < medium_.samples)
            warnOfRefusal(tokens_.context(), place, "wants no less than the first number here.",
                          "leave it out");
    } else if (tokens_.accept("aa_level")) {
        medium_.refinements = parseCount("aa_level", Medium::refinementsLimit);
    } else if (tokens_.accept("aa_threshold")) {
        const SourceRange place = tokens_.peek().range;
        medium_.threshold = ExpressionParser(tokens_).parseFloat();
        if (!(medium_.threshold > 0))
            warnOfRefusal(tokens_.context(), place, "wants an `aa_threshold` above 0.", "write 0.1");
    } else {
        return false;
    }
    return true;
}

/// What steers how POV-Ray takes samples at random, and photons.
bool MediaParser::parseIgnored() {
    static constexpr std::array words{"confidence", "variance", "ratio", "jitter"};
    for (const char* word : words)
        if (tokens_.accept(word)) {
            if (ExpressionParser expressions(tokens_); expressions.atExpression()) expressions.parseFloat();
            return true;
        }
    if (!tokens_.accept("collect")) return false;
    if (ExpressionParser expressions(tokens_); expressions.atExpression()) expressions.parseBool();
    return true;
}

namespace {

void parse(TokenStream& tokens, SceneDraft& draft) { MediaParser(tokens).parseInto(draft.scene.atmosphere); }

std::optional<Value> parseValue(TokenStream& tokens, SceneDraft&) {
    return Value{BlockValue("a medium", MediaParser(tokens).parse())};
}

/// Media may be declared ones, which stay as they were written; those that share densities go on sharing
/// them.
void addMaterials(Scene& scene, std::vector<Material*>& materials) {
    std::map<const std::vector<Material>*, std::shared_ptr<const std::vector<Material>>> compiled;
    const auto add = [&](std::shared_ptr<const Medium>& medium) {
        if (medium->layers() == 0) return;
        const auto [found, isNew] = compiled.try_emplace(medium->densities.get());
        if (isNew) {
            auto densities = std::make_shared<std::vector<Material>>(*medium->densities);
            for (Material& density : *densities) materials.push_back(&density);
            found->second = std::move(densities);
        }
        Medium copy = *medium;
        copy.densities = found->second;
        medium = std::make_shared<const Medium>(std::move(copy));
    };
    for (std::shared_ptr<const Medium>& medium : scene.atmosphere) add(medium);
    for (Interior& interior : scene.interiors)
        for (std::shared_ptr<const Medium>& medium : interior.media) add(medium);
}

}  // namespace

const StatementDescription statements::media{
    .word = "media",
    .itemWords = {"absorption emission scattering density method intervals samples aa_level aa_threshold "
                  "confidence variance ratio jitter collect",
                  transformWords},
    .parse = parse,
    .parseValue = parseValue,
    .addMaterials = addMaterials};

}  // namespace isoscope
