// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/language/light_parser.h"

#include <array>

#include "core/language/declared_value.h"
#include "core/language/expression_parser.h"
#include "core/language/transform_parser.h"

namespace isoscope {

LightSource transformed(const LightSource& light, const Transform& transform) {
    LightSource moved = light;
    moved.location = transform.point(light.location);
    moved.pointAt = transform.point(light.pointAt);
    return moved;
}

LightSource LightParser::parse() {
    LightSource light;
    const SourceRange start = tokens_.lastRange();
    const SourceLibrary& sources = tokens_.context().sources;
    if (start.file < sources.size()) light.line = sources[start.file].position(start.begin).line;
    if (!tokens_.expect("{", "to begin `light_source`")) return light;
    parseStart(light);
    while (!tokens_.peek().is("}")) {
        Transform transform;
        if (TransformParser(tokens_).parseModifier(transform)) {
            const int line = light.line;
            light = transformed(light, transform);
            light.line = line;
            continue;
        }
        if (parseItem(light)) continue;
        const Token token = tokens_.peek();
        if (token.kind == TokenKind::end) {
            tokens_.expect("}", "to close `light_source`");
            return light;
        }
        tokens_.context().error("unknown-item", token.range,
                                describe(token) + " is not understood in `light_source`.");
        tokens_.skipBlock();
        return light;
    }
    tokens_.next();
    return light;
}

bool LightParser::parseStart(LightSource& light) {
    if (const std::optional<LightSource> declared = takeDeclared<LightSource>(tokens_)) {
        const int line = light.line;
        light = *declared;
        light.line = line;
        return true;
    }
    ExpressionParser expressions(tokens_);
    light.location = expressions.parseVector();
    tokens_.accept(",");
    light.color = expressions.parseColor();
    return true;
}

bool LightParser::parseItem(LightSource& light) {
    tokens_.accept(",");
    if (tokens_.accept("spotlight"))
        light.kind = LightKind::spotlight;
    else if (tokens_.accept("cylinder"))
        light.kind = LightKind::cylinder;
    else if (tokens_.accept("parallel"))
        light.kind = LightKind::parallel;
    else if (tokens_.accept("shadowless"))
        light.shadowless = true;
    else if (tokens_.accept("point_at"))
        light.pointAt = ExpressionParser(tokens_).parseVector();
    else if (tokens_.accept("color") || tokens_.accept("colour"))
        light.color = ExpressionParser(tokens_).parseColor();
    else
        return parseNumberItem(light) || parseAreaItem() || parseBlockItem();
    return true;
}

bool LightParser::parseNumberItem(LightSource& light) {
    struct Entry {
        const char* word;
        double LightSource::*member;
    };
    static constexpr std::array<Entry, 5> entries{{{"radius", &LightSource::radius},
                                                   {"falloff", &LightSource::falloff},
                                                   {"tightness", &LightSource::tightness},
                                                   {"fade_distance", &LightSource::fadeDistance},
                                                   {"fade_power", &LightSource::fadePower}}};
    for (const Entry& entry : entries)
        if (tokens_.accept(entry.word)) {
            light.*entry.member = ExpressionParser(tokens_).parseFloat();
            return true;
        }
    return false;
}

bool LightParser::parseAreaItem() {
    const Token word = tokens_.peek();
    ExpressionParser expressions(tokens_);
    if (tokens_.accept("area_light")) {
        expressions.parseVector();
        tokens_.accept(",");
        expressions.parseVector();
        tokens_.accept(",");
        expressions.parseFloat();
        tokens_.accept(",");
        expressions.parseFloat();
        reportLeftOut(tokens_.context(), word.range,
                      "`area_light` is not simulated: the light shines from a point.");
        return true;
    }
    if (tokens_.accept("adaptive")) {
        expressions.parseFloat();
        return true;
    }
    // These only say how an area light is sampled.
    static constexpr std::array<const char*, 4> flags{"jitter", "circular", "orient", "area_illumination"};
    for (const char* flag : flags)
        if (tokens_.accept(flag)) {
            if (expressions.atExpression()) expressions.parseFloat();
            return true;
        }
    return false;
}

bool LightParser::parseBlockItem() {
    const Token word = tokens_.peek();
    const bool block = word.is("looks_like") || word.is("projected_through") || word.is("photons");
    const bool flag = word.is("media_interaction") || word.is("media_attenuation");
    if (!block && !flag) return false;
    tokens_.next();
    if (block && tokens_.accept("{"))
        tokens_.skipBlock();
    else if (flag && ExpressionParser(tokens_).atExpression())
        ExpressionParser(tokens_).parseFloat();
    reportLeftOut(tokens_.context(), word.range, "`" + std::string(word.text) + "` is not simulated.");
    return true;
}

}  // namespace isoscope
