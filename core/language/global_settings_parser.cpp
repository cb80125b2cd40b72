// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <cmath>

#include "core/language/expressions/expression_parser.h"
#include "core/language/scene_draft.h"
#include "core/language/statement_description.h"
#include "core/language/tokens/unknown_name.h"

namespace isoscope {

namespace {

int wholeNumber(double value, int minimum, int maximum) {
    return std::isfinite(value) ? static_cast<int>(std::clamp<double>(value, minimum, maximum)) : minimum;
}

/// `global_settings { ... }`. Settings that only concern effects this program does not have are passed over
/// silently; those that would change the picture are reported.
class GlobalSettingsParser {
  public:
    GlobalSettingsParser(TokenStream& tokens, SceneDraft& draft) : tokens_(tokens), draft_(draft) {}

    /// The block with its braces; the word `global_settings` has been read.
    void parse();

  private:
    bool parseItem();
    void parseGamma();
    void parseNoiseGenerator();
    bool parseWithoutEffect();

    TokenStream& tokens_;
    SceneDraft& draft_;
};

void GlobalSettingsParser::parse() {
    if (!tokens_.expect("{", "to begin `global_settings`")) return;
    while (!tokens_.accept("}")) {
        if (parseItem()) continue;
        const Token token = tokens_.peek();
        if (token.kind == TokenKind::end) {
            tokens_.expect("}", "to close `global_settings`");
            return;
        }
        passUnknownItem(tokens_, "global_settings");
    }
}

bool GlobalSettingsParser::parseItem() {
    GlobalSettings& settings = draft_.scene.settings;
    ExpressionParser expressions(tokens_);
    if (tokens_.accept("assumed_gamma"))
        parseGamma();
    else if (tokens_.accept("noise_generator"))
        parseNoiseGenerator();
    else if (tokens_.accept("max_trace_level"))
        settings.maxTraceLevel = wholeNumber(expressions.parseFloat(), 1, 256);
    else if (tokens_.accept("number_of_waves"))
        settings.numberOfWaves = wholeNumber(expressions.parseFloat(), 1, 1000);
    else if (tokens_.accept("adc_bailout"))
        settings.adcBailout = std::max(0.0, expressions.parseFloat());
    else if (tokens_.accept("ambient_light"))
        settings.ambientLight = expressions.parseColor();
    else
        return parseWithoutEffect();
    return true;
}

void GlobalSettingsParser::parseGamma() {
    tokens_.context().hasAssumedGamma = true;
    if (tokens_.accept("srgb")) {
        tokens_.context().assumedGamma = draft_.scene.settings.assumedGamma = srgbGamma;
        return;
    }
    const SourceRange start = tokens_.peek().range;
    const double gamma = ExpressionParser(tokens_).parseFloat();
    if (gamma > 0 && std::isfinite(gamma))
        tokens_.context().assumedGamma = draft_.scene.settings.assumedGamma = gamma;
    else
        tokens_.context().error("bad-value", rangeSince(start, tokens_),
                                "`assumed_gamma` must be greater than 0.");
}

void GlobalSettingsParser::parseNoiseGenerator() {
    const SourceRange start = tokens_.peek().range;
    const double value = ExpressionParser(tokens_).parseFloat();
    if (!(value >= 1 && value < 4)) {
        tokens_.context().error("bad-value", rangeSince(start, tokens_),
                                "`noise_generator` must be 1, 2 or 3.");
        return;
    }
    const int generator = static_cast<int>(value);
    draft_.scene.settings.noiseGenerator = generator;
    tokens_.context().noiseGenerator = generator;
}

bool GlobalSettingsParser::parseWithoutEffect() {
    const Token word = tokens_.peek();
    if (tokens_.accept("irid_wavelength")) {
        draft_.scene.settings.iridWavelength = ExpressionParser(tokens_).parseColor();
        return true;
    }
    static constexpr std::array<const char*, 4> silent{"hf_gray_16", "max_intersections", "mm_per_unit",
                                                       "charset"};
    for (const char* item : silent)
        if (tokens_.accept(item)) {
            if (word.is("charset"))
                tokens_.next();
            else if (ExpressionParser(tokens_).atExpression())
                ExpressionParser(tokens_).parseValue();
            return true;
        }
    if (!word.is("radiosity") && !word.is("photons") && !word.is("subsurface")) return false;
    tokens_.next();
    if (tokens_.accept("{")) tokens_.skipBlock();
    reportLeftOut(tokens_.context(), word.range, notSimulatedSentence(word.text));
    return true;
}

void parse(TokenStream& tokens, SceneDraft& draft) { GlobalSettingsParser(tokens, draft).parse(); }

}  // namespace

const StatementDescription statements::globalSettings{
    .word = "global_settings",
    .itemWords = {"assumed_gamma max_trace_level ambient_light noise_generator number_of_waves adc_bailout "
                  "irid_wavelength radiosity photons charset max_intersections mm_per_unit subsurface"},
    .parse = parse};

}  // namespace isoscope
