// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/language/textures/pattern_parser.h"

#include <string>

#include "core/language/textures/pattern_reader.h"
#include "core/language/textures/pigment_parser.h"
#include "core/language/tokens/nesting_guard.h"
#include "core/texture/pigment_function.h"
#include "core/texture/surface_needs.h"

namespace isoscope {

bool PatternParser::leaveOut(const Token& word) {
    tokens_.context().report({Severity::leftOut,
                              "left-out",
                              word.range,
                              "The pattern `" + std::string(word.text) + "` is not simulated in a function.",
                              {},
                              {}});
    return false;
}

bool PatternParser::parseItems(PatternReader& reader) {
    const Token name = tokens_.peek();
    if (isPatternLeftOut(name.text)) return leaveOut(name);
    // POV-Ray knows them in pigments, normals and textures only.
    if (name.is("square") || name.is("triangular") || name.is("tiling") || name.is("pavement") ||
        name.is("slope") || name.is("aoi")) {
        tokens_.context().error("unknown-pattern", name.range,
                                "`" + std::string(name.text) + "` makes no `pattern` of its own.");
        return false;
    }
    if (!reader.parseName()) return false;
    if (reader.opensList()) {
        tokens_.context().error("unexpected-token", tokens_.peek().range,
                                "A pattern in a function has no list: expected `}` behind the object.");
        tokens_.skipBlock();
        return false;
    }
    while (!tokens_.peek().is("}"))
        if (!reader.parseModifier()) {
            tokens_.context().error("unknown-modifier", tokens_.peek().range,
                                    "Expected a modifier of the pattern or `}` here.");
            return false;
        }
    return true;
}

std::optional<NodeId> PatternParser::parse() {
    if (!tokens_.expect("{", "to begin the pattern")) return std::nullopt;
    const NestingGuard guard(tokens_);
    PatternReader reader(tokens_);
    if (!guard.ok() || !parseItems(reader)) {
        tokens_.skipBlock();
        return std::nullopt;
    }
    tokens_.next();
    return buildPattern(reader.pattern, scope_.expression(*scope_.find("x")),
                        scope_.expression(*scope_.find("y")), scope_.expression(*scope_.find("z")),
                        tokens_.context().noiseGenerator)
        .node();
}

std::vector<NodeId> PatternParser::parsePigment() {
    const Token word = tokens_.peek();
    PigmentParser parser(tokens_);
    const Pigment pigment = withoutSlopes(parser.parse(SolidPigment{}));
    if (parser.failed()) return {};
    std::vector<std::string> leftOut = notSimulatedIn(pigment);
    if (onSurface(pigment)) leftOut.emplace_back("uv_mapping");
    if (!leftOut.empty()) {
        tokens_.context().report({Severity::leftOut,
                                  "left-out",
                                  word.range,
                                  "`" + leftOut.front() + "` is not simulated in a function.",
                                  {},
                                  {}});
        return {};
    }
    const PatternPoint point{scope_.expression(*scope_.find("x")), scope_.expression(*scope_.find("y")),
                             scope_.expression(*scope_.find("z"))};
    std::vector<NodeId> results;
    for (const Expression& channel :
         pigmentColor(pigment, point, {tokens_.context().noiseGenerator, Pattern().numberOfWaves}))
        results.push_back(channel.node());
    return results;
}

}  // namespace isoscope
