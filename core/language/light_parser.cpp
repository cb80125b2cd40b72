// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/language/light_parser.h"

#include <array>

#include "core/language/expressions/declared_value.h"
#include "core/language/expressions/expression_parser.h"
#include "core/language/objects/object_parser.h"
#include "core/language/objects/transform_parser.h"
#include "core/language/scene_builder.h"
#include "core/language/textures/color_start.h"
#include "core/language/tokens/block_words.h"
#include "core/language/tokens/povray_refusals.h"
#include "core/language/tokens/unknown_name.h"
#include "core/shapes/combined/placed_shape.h"

namespace isoscope {

namespace {

constexpr int mostLights = 1000;
constexpr int mostIlluminating = 1024;

}  // namespace

LightSource transformed(const LightSource& light, const Transform& transform) {
    LightSource moved = light;
    moved.location = transform.point(light.location);
    moved.pointAt = transform.point(light.pointAt);
    if (moved.projectedThrough)
        moved.projectedThrough = std::make_shared<PlacedShape>(moved.projectedThrough, transform, noMaterial);
    if (moved.area) {
        moved.area->edge = transform.direction(moved.area->edge);
        moved.area->otherEdge = transform.direction(moved.area->otherEdge);
    }
    return moved;
}

constexpr std::array<const char*, 3> LightParser::itemWords{
    transformWords, colorWords,
    "spotlight cylinder parallel shadowless point_at area_light adaptive jitter circular orient "
    "area_illumination radius falloff tightness fade_distance fade_power looks_like projected_through "
    "media_attenuation media_interaction photons"};

LightSource LightParser::parse() {
    LightSource light;
    const SourceRange start = tokens_.lastRange();
    tokens_.charge(TokenStream::stepsPerItem, start);
    const SourceLibrary& sources = tokens_.context().sources;
    if (start.file < sources.size()) light.line = sources[start.file].position(start.begin).line;
    if (!tokens_.expect("{", "to begin `light_source`")) return light;
    parseStart(light);
    hasBeam_ = light.kind == LightKind::spotlight || light.kind == LightKind::cylinder;
    while (!tokens_.peek().is("}")) {
        Transform transform;
        if (TransformParser(tokens_).parseModifier(transform)) {
            const int line = light.line;
            light = transformed(light, transform);
            light.line = line;
            moveLooks(transform);
            continue;
        }
        if (parseItem(light)) continue;
        const Token token = tokens_.peek();
        if (token.kind == TokenKind::end) {
            tokens_.expect("}", "to close `light_source`");
            return light;
        }
        passUnknownItem(tokens_, "light_source");
    }
    tokens_.next();
    if (light.area && light.area->circular && (light.area->columns == 1 || light.area->rows == 1))
        warnOfRefusal(tokens_.context(), rangeSince(start, tokens_),
                      "wants more than one light along each edge of a `circular` area.",
                      "leave `circular` out, or give both edges at least 2 lights");
    // As render/illuminating_areas.h has it.
    const bool whole = light.area && light.area->illumination;
    if (whole && (light.area->orient || light.area->columns * light.area->rows > mostIlluminating))
        reportLeftOut(tokens_.context(), start,
                      "`area_illumination` is not simulated here: surfaces are lit from the middle of the "
                      "area, and only shadows are soft.");
    return light;
}

void LightParser::parseStart(LightSource& light) {
    if (const std::optional<LightSource> declared = takeDeclared<LightSource>(tokens_)) {
        const int line = light.line;
        light = *declared;
        light.line = line;
        return;
    }
    const std::optional<ObjectPointer> object = takeDeclared<ObjectPointer>(tokens_);
    if (object && *object && (*object)->lights.size() == 1 && (*object)->parts.size() == 1) {
        const int line = light.line;
        light = (*object)->lights.front();
        light.line = line;
        looks_ = (*object)->parts.front();
        moveLooks((*object)->transform);
        return;
    }
    ExpressionParser expressions(tokens_);
    light.location = expressions.parseVector();
    tokens_.accept(",");
    if (!isWithoutColor(tokens_)) {
        light.color = expressions.parseColor();
        return;
    }
    light.color = {0, 0, 0};
    tokens_.context().warning("empty-color", tokens_.lastRange(),
                              "This light has no colour, which makes it black.",
                              "write `rgb 1` behind its place");
}

bool LightParser::parseItem(LightSource& light) {
    if (tokens_.accept(",")) warnOfLastComma(tokens_);
    const Token word = tokens_.peek();
    if (tokens_.accept("point_at")) {
        light.pointAt = ExpressionParser(tokens_).parseVector();
        if (light.kind != LightKind::parallel)
            warnWithoutBeam(word.range, "`spotlight`, `cylinder` or `parallel`");
    } else if (tokens_.accept("color") || tokens_.accept("colour"))
        light.color = ExpressionParser(tokens_).parseColor();
    else
        return parseKind(light) || parseNumberItem(light) || parseAreaItem(light) || parseMediaItem(light) ||
               parseLooks(light) || parseBlockItem(light);
    return true;
}

bool LightParser::parseKind(LightSource& light) {
    // To POV-Ray `shadowless` is a kind beside `spotlight` and `cylinder`, of which the last one holds. The
    // rays of cylinders are parallel, and stay so whatever comes later; the cone of a spotlight with parallel
    // rays has no end.
    const bool parallel = light.kind == LightKind::parallel || light.kind == LightKind::cylinder;
    const auto begin = [&](LightKind kind, double radius, double falloff) {
        light.kind = kind;
        light.radius = radius;
        light.falloff = falloff;
        light.tightness = 0;
        light.shadowless = false;
        hasBeam_ = true;
    };
    if (tokens_.accept("spotlight")) {
        begin(parallel ? LightKind::parallel : LightKind::spotlight, 30, 45);
    } else if (tokens_.accept("cylinder")) {
        begin(LightKind::cylinder, 0.75, 1);
    } else if (tokens_.accept("parallel")) {
        if (!parallel) light.kind = LightKind::parallel;
    } else if (tokens_.accept("shadowless")) {
        light.kind = parallel ? LightKind::parallel : LightKind::point;
        light.shadowless = true;
        hasBeam_ = false;
    } else {
        return false;
    }
    return true;
}

void LightParser::warnWithoutBeam(const SourceRange& start, const char* kinds) {
    if (!hasBeam_)
        warnOfRefusal(tokens_.context(), rangeSince(start, tokens_),
                      std::string("takes this only behind ") + kinds + ", and not behind `shadowless`.",
                      "put it behind the kind of the light, or leave it out");
}

bool LightParser::parseNumberItem(LightSource& light) {
    struct Entry {
        const char* word;
        double LightSource::*member;
        bool ofBeam = false;
    };
    static constexpr std::array<Entry, 5> entries{{{"radius", &LightSource::radius, true},
                                                   {"falloff", &LightSource::falloff, true},
                                                   {"tightness", &LightSource::tightness, true},
                                                   {"fade_distance", &LightSource::fadeDistance},
                                                   {"fade_power", &LightSource::fadePower}}};
    const Token word = tokens_.peek();
    for (const Entry& entry : entries)
        if (tokens_.accept(entry.word)) {
            light.*entry.member = ExpressionParser(tokens_).parseFloat();
            if (entry.ofBeam) warnWithoutBeam(word.range, "`spotlight` or `cylinder`");
            return true;
        }
    return false;
}

bool LightParser::parseArea(LightSource& light) {
    const Token word = tokens_.peek();
    if (!tokens_.accept("area_light")) return false;
    ExpressionParser expressions(tokens_);
    // What has been said before of adaptive and the like stays.
    LightArea area = light.area.value_or(areaSaid_);
    area.edge = expressions.parseVector();
    tokens_.accept(",");
    area.otherEdge = expressions.parseVector();
    std::array<double, 2> sizes{};
    for (double& size : sizes) {
        tokens_.accept(",");
        size = expressions.parseFloat();
        if (size >= 1 && size <= mostLights) continue;
        tokens_.context().error(
            "bad-area-light", rangeSince(word.range, tokens_),
            "An `area_light` has 1 to " + std::to_string(mostLights) + " lights along each edge.");
        size = 1;
    }
    area.columns = static_cast<int>(sizes[0]);
    area.rows = static_cast<int>(sizes[1]);
    light.area = area;
    return true;
}

bool LightParser::parseAreaItem(LightSource& light) {
    if (parseArea(light)) return true;
    const Token word = tokens_.peek();
    ExpressionParser expressions(tokens_);
    LightArea& area = light.area ? *light.area : areaSaid_;
    if (tokens_.accept("adaptive")) {
        const double level = expressions.parseFloat();
        area.adaptive = level >= 100 ? 100 : level > 0 ? static_cast<int>(level) : 0;
        return true;
    }
    struct Flag {
        const char* word;
        bool LightArea::*member;
    };
    static constexpr std::array<Flag, 4> flags{{{"jitter", &LightArea::jitter},
                                                {"circular", &LightArea::circular},
                                                {"orient", &LightArea::orient},
                                                {"area_illumination", &LightArea::illumination}}};
    for (const Flag& flag : flags)
        if (tokens_.accept(flag.word)) {
            const bool on = !expressions.atExpression() || expressions.parseFloat() != 0;
            area.*flag.member = on;
            return true;
        }
    return false;
}

bool LightParser::parseMediaItem(LightSource& light) {
    if (tokens_.accept("media_attenuation")) {
        ExpressionParser expressions(tokens_);
        light.mediaAttenuation = !expressions.atExpression() || expressions.parseBool();
        return true;
    }
    if (tokens_.accept("media_interaction")) {
        ExpressionParser expressions(tokens_);
        light.mediaInteraction = !expressions.atExpression() || expressions.parseBool();
        return true;
    }
    // Photons are reported themselves.
    if (!tokens_.accept("photons")) return false;
    if (tokens_.accept("{")) tokens_.skipBlock();
    return true;
}

/// The object stands where the light is and casts no shadow.
bool LightParser::parseLooks(const LightSource& light) {
    if (!draft_ || !tokens_.peek().is("looks_like")) return false;
    const ObjectPointer object = ObjectParser(tokens_, *draft_).parse();
    if (!object) return true;
    auto seen = std::make_shared<ObjectDescription>(*object);
    seen->castsShadow = false;
    looks_ = std::move(seen);
    moveLooks(Transform::translation(light.location));
    return true;
}

void LightParser::moveLooks(const Transform& transform) {
    if (!looks_) return;
    auto moved = std::make_shared<ObjectDescription>(*looks_);
    moved->transform = moved->transform.then(transform);
    looks_ = std::move(moved);
}

bool LightParser::parseBlockItem(LightSource& light) {
    const Token word = tokens_.peek();
    if (draft_ && word.is("projected_through")) {
        // It is read like `object { ... }`.
        const ObjectPointer object = ObjectParser(tokens_, *draft_).parse();
        Scene materials;
        if (object) light.projectedThrough = SceneBuilder(materials).shape(*object);
        return true;
    }
    if (!word.is("looks_like") && !word.is("projected_through")) return false;
    tokens_.next();
    if (tokens_.accept("{")) tokens_.skipBlock();
    reportLeftOut(tokens_.context(), word.range, "`" + std::string(word.text) + "` is not simulated.");
    return true;
}

}  // namespace isoscope
