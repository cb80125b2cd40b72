// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/language/textures/warp_parser.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/language/expressions/expression_parser.h"

namespace isoscope {

namespace {

std::array<double, 3> components(const glm::dvec3& v) { return {v.x, v.y, v.z}; }

/// Blocks are made so large, and the hole is moved so far in, that it lies within its block. POV-Ray does so
/// at each word, with what it has read until then (measured).
void fitBlocks(BlackHoleWarp& warp) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
        if (!(warp.repeat[axis] > 0)) continue;
        warp.center[axis] = std::max(warp.center[axis], warp.radius);
        warp.repeat[axis] =
            std::max(warp.repeat[axis], warp.center[axis] + warp.radius + warp.turbulence[axis]);
    }
}

}  // namespace

std::optional<PatternWarp> WarpParser::parse() {
    if (!tokens_.expect("{", "to begin `warp`")) return std::nullopt;
    const Token kind = tokens_.next();
    std::optional<PatternWarp> warp;
    if (kind.is("repeat"))
        warp = parseRepeat();
    else if (kind.is("turbulence"))
        warp = parseTurbulence();
    else if (kind.is("black_hole"))
        warp = parseBlackHole();
    else if (kind.is("planar"))
        warp = parsePlanar();
    else if (kind.is("spherical"))
        warp = parseRound(RoundWarp::Kind::spherical);
    else if (kind.is("cylindrical"))
        warp = parseRound(RoundWarp::Kind::cylindrical);
    else if (kind.is("toroidal"))
        warp = parseRound(RoundWarp::Kind::toroidal);
    const SourceRange place = warp ? tokens_.peek().range : kind.range;
    if (warp && tokens_.accept("}")) return warp;
    tokens_.context().error(
        "unknown-warp", place,
        warp ? "This does not belong to the `warp`." : "Expected the name of a warp here.");
    if (!kind.is("}")) tokens_.skipBlock();
    return std::nullopt;
}

PatternWarp WarpParser::parseRepeat() {
    RepeatWarp warp;
    const SourceRange start = tokens_.peek().range;
    const glm::dvec3 step = ExpressionParser(tokens_).parseVector();
    int count = 0;
    for (int axis = 0; axis < 3; ++axis) {
        if (step[axis] == 0) continue;
        ++count;
        warp.axis = axis;
    }
    warp.width = step[warp.axis];
    if (count != 1 || !std::isfinite(warp.width)) {
        tokens_.context().error("bad-value", start,
                                count > 1 ? "The step of `repeat` must go along one axis."
                                          : "The step of `repeat` must not be 0.");
        warp.width = 1;
    }
    for (;;) {
        if (tokens_.accept("offset"))
            warp.offset = components(ExpressionParser(tokens_).parseVector());
        else if (tokens_.accept("flip")) {
            const glm::dvec3 axes = ExpressionParser(tokens_).parseVector();
            warp.flip = {axes.x != 0, axes.y != 0, axes.z != 0};
        } else
            return warp;
    }
}

PatternWarp WarpParser::parseTurbulence() {
    TurbulenceWarp warp;
    ExpressionParser expressions(tokens_);
    warp.amount = components(expressions.parseVector());
    for (;;) {
        if (tokens_.accept("octaves")) {
            const double octaves = expressions.parseFloat();
            warp.octaves = octaves >= 10 ? 10 : octaves >= 1 ? static_cast<int>(octaves) : 1;
        } else if (tokens_.accept("lambda"))
            warp.lambda = expressions.parseFloat();
        else if (tokens_.accept("omega"))
            warp.omega = expressions.parseFloat();
        else
            return warp;
    }
}

PatternWarp WarpParser::parseBlackHole() {
    BlackHoleWarp warp;
    ExpressionParser expressions(tokens_);
    warp.center = components(expressions.parseVector());
    tokens_.accept(",");
    warp.radius = expressions.parseFloat();
    for (;;) {
        if (tokens_.accept("strength"))
            warp.strength = expressions.parseFloat();
        else if (tokens_.accept("falloff"))
            warp.falloff = expressions.parseFloat();
        else if (tokens_.accept("inverse"))
            warp.inverse = true;
        else if (tokens_.accept("repeat")) {
            warp.repeat = components(expressions.parseVector());
            fitBlocks(warp);
        } else if (tokens_.accept("turbulence")) {
            warp.turbulence = components(expressions.parseVector());
            fitBlocks(warp);
        } else
            return warp;
    }
}

std::array<double, 3> WarpParser::parseOrientation() {
    const SourceRange start = tokens_.peek().range;
    const glm::dvec3 direction = ExpressionParser(tokens_).parseVector();
    const double size = glm::length(direction);
    if (size > 0 && std::isfinite(size)) return components(direction / size);
    tokens_.context().error("bad-value", start, "An orientation must not be 0.");
    return {0, 0, 1};
}

PatternWarp WarpParser::parsePlanar() {
    PlanarWarp warp;
    if (tokens_.peek().is("}")) return warp;
    warp.orientation = parseOrientation();
    tokens_.accept(",");
    if (!tokens_.peek().is("}")) warp.distance = ExpressionParser(tokens_).parseFloat();
    return warp;
}

PatternWarp WarpParser::parseRound(RoundWarp::Kind kind) {
    RoundWarp warp;
    warp.kind = kind;
    for (;;) {
        if (tokens_.accept("orientation"))
            warp.orientation = parseOrientation();
        else if (tokens_.accept("dist_exp"))
            warp.distanceExponent = ExpressionParser(tokens_).parseFloat();
        else if (tokens_.accept("major_radius"))
            warp.majorRadius = ExpressionParser(tokens_).parseFloat();
        else
            return warp;
    }
}

}  // namespace isoscope
