// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <glm/geometric.hpp>

#include "core/language/expressions/declared_value.h"
#include "core/language/expressions/expression_parser.h"
#include "core/language/objects/transform_parser.h"
#include "core/language/scene_draft.h"
#include "core/language/statement_description.h"
#include "core/language/textures/color_start.h"
#include "core/language/tokens/block_words.h"
#include "core/language/tokens/unknown_name.h"

namespace isoscope {

namespace {

/// `fog { ... }`.
class FogParser {
  public:
    explicit FogParser(TokenStream& tokens) : tokens_(tokens) {}

    /// The block with its braces; the word `fog` has been read.
    Fog parse();

  private:
    bool parseItem();
    bool parseNumberItem();

    TokenStream& tokens_;
    Fog fog_;
};

Fog FogParser::parse() {
    const SourceRange start = tokens_.lastRange();
    tokens_.charge(TokenStream::stepsPerItem, start);
    const SourceLibrary& sources = tokens_.context().sources;
    if (!tokens_.expect("{", "to begin `fog`")) return fog_;
    while (!tokens_.accept("}")) {
        if (parseItem()) continue;
        const Token token = tokens_.peek();
        if (token.kind == TokenKind::end) {
            tokens_.expect("}", "to close `fog`");
            break;
        }
        passUnknownItem(tokens_, "fog");
    }
    if (start.file < sources.size()) fog_.line = sources[start.file].position(start.begin).line;
    return fog_;
}

bool FogParser::parseItem() {
    if (const std::optional<Fog> declared = takeDeclared<Fog>(tokens_)) {
        fog_ = *declared;
        return true;
    }
    ExpressionParser expressions(tokens_);
    Transform transform;
    if (tokens_.accept("fog_type")) {
        fog_.ground = expressions.parseFloat() == 2;
    } else if (tokens_.accept("up")) {
        fog_.up = expressions.parseVector();
    } else if (TransformParser(tokens_).parseModifier(transform)) {
        fog_.up = transform.direction(fog_.up);
    } else if (tokens_.accept("turbulence")) {
        fog_.turbulence = expressions.parseVector();
    } else if (tokens_.accept("octaves")) {
        const double octaves = expressions.parseFloat();
        fog_.octaves = octaves >= 10 ? 10 : octaves >= 1 ? static_cast<int>(octaves) : 1;
    } else if (atColor(tokens_)) {
        warnOfBareVector(tokens_);
        fog_.color = expressions.parseColor();
    } else {
        return parseNumberItem();
    }
    return true;
}

bool FogParser::parseNumberItem() {
    struct Entry {
        const char* word;
        double Fog::*member;
    };
    static constexpr std::array<Entry, 6> entries{{{"distance", &Fog::distance},
                                                   {"fog_offset", &Fog::offset},
                                                   {"fog_alt", &Fog::altitude},
                                                   {"turb_depth", &Fog::turbulenceDepth},
                                                   {"omega", &Fog::omega},
                                                   {"lambda", &Fog::lambda}}};
    for (const Entry& entry : entries)
        if (tokens_.accept(entry.word)) {
            fog_.*entry.member = ExpressionParser(tokens_).parseFloat();
            return true;
        }
    // As POV-Ray takes it, a number alone is the distance.
    if (!ExpressionParser(tokens_).atExpression()) return false;
    fog_.distance = ExpressionParser(tokens_).parseFloat();
    return true;
}

void parse(TokenStream& tokens, SceneDraft& draft) { draft.scene.fogs.push_back(FogParser(tokens).parse()); }

std::optional<Value> parseValue(TokenStream& tokens, SceneDraft&) {
    return Value{BlockValue("a fog", FogParser(tokens).parse())};
}

}  // namespace

const StatementDescription statements::fog{
    .word = "fog",
    .itemWords = {colorWords, transformWords,
                  "fog_type distance fog_offset fog_alt up turbulence turb_depth octaves omega lambda"},
    .parse = parse,
    .parseValue = parseValue};

}  // namespace isoscope
