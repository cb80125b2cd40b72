// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/function/patterns/pattern.h"

#include <cmath>
#include <numbers>
#include <optional>

#include "core/function/patterns/pattern_call.h"
#include "core/function/surface_variables.h"

namespace isoscope {

namespace {

/// Bounds of what stands in place of a formula, where it is looked up or measured in cells.
struct Bounds {
    double low, high;
};
std::optional<Bounds> lookedUpBounds(const Pattern& pattern) {
    if (pattern.kind != PatternKind::function || !pattern.function.valid()) return std::nullopt;
    const FunctionGraph& graph = *pattern.function.graph;
    const Node& result = graph[pattern.function.results[0]];
    if (result.operation != Operation::crackle) return std::nullopt;
    const auto& table = graph.crackleSettings(result.index).table;
    return table ? Bounds{table->low(), table->high()} : Bounds{0, 1};
}

/// Any function in place of a pattern. Above 1 only its fraction is kept, as with gradient, unless it is
/// looked up.
Expression functionPattern(const PatternCall& call) {
    const Function& function = call.pattern.function;
    if (!function.valid()) return call.number(0);
    const NodeId point[] = {call.x.node(), call.y.node(), call.z.node()};
    const Expression value(call.x.graph(), call.x.graph().inlineCall(function, point));
    if (lookedUpBounds(call.pattern)) return value;
    return select(1 - value, mod(value, value.number(1)), value);
}

/// 0 against the direction, 1 along it: even in the angle.
Expression leaning(const std::array<Expression, 3>& normal, const std::array<Expression, 3>& direction) {
    const Expression cosine = normal[0] * direction[0] + normal[1] * direction[1] + normal[2] * direction[2];
    return apply(Operation::arcSine, clamp(cosine, cosine.number(-1), cosine.number(1))) / std::numbers::pi +
           0.5;
}

std::array<Expression, 3> surfaceVector(const PatternCall& call, int first) {
    FunctionGraph& graph = call.x.graph();
    return {surfaceVariable(graph, first, 0), surfaceVariable(graph, first, 1),
            surfaceVariable(graph, first, 2)};
}

Expression within(const SlopeSettings::Range& range, Expression value) {
    return range.low == range.high ? value : (value - range.low) / (range.high - range.low);
}

/// Measured on POV-Ray 3.7: it takes normals as they stand in the world, but altitudes in the coordinates of
/// the pattern; both count by the lengths of their directions.
Expression slopePattern(const PatternCall& call) {
    const SlopeSettings& slope = call.pattern.slope;
    const auto lengthOf = [](const std::array<double, 3>& d) { return std::hypot(d[0], d[1], d[2]); };
    const std::array<double, 3>& d = slope.direction;
    const double length = lengthOf(d);
    const double high = slope.altitude ? lengthOf(*slope.altitude) : 0;
    Expression value = call.number(0);
    if (length > 0) {
        const auto part = [&](std::size_t axis) { return call.number(d[axis] / length); };
        value = within(slope.slopes,
                       leaning(surfaceVector(call, surface_variable::normal), {part(0), part(1), part(2)}));
    }
    if (!(high > 0)) return value;
    const auto& up = *slope.altitude;
    const Expression along = call.x * (up[0] / high) + call.y * (up[1] / high) + call.z * (up[2] / high);
    return (value * length + within(slope.altitudes, along) * high) / (length + high);
}

Expression aoiPattern(const PatternCall& call) {
    const std::array<Expression, 3> view = surfaceVector(call, surface_variable::view);
    return leaning(surfaceVector(call, surface_variable::normal), {-view[0], -view[1], -view[2]});
}

Expression rawValue(const PatternCall& call) {
    switch (call.pattern.kind) {
        case PatternKind::agate:
        case PatternKind::bozo:
        case PatternKind::bumps:
        case PatternKind::dents:
        case PatternKind::granite:
        case PatternKind::marble:
        case PatternKind::spotted:
        case PatternKind::wood:
        case PatternKind::wrinkles: return noisePattern(call);
        case PatternKind::brick:
        case PatternKind::checker:
        case PatternKind::cubic:
        case PatternKind::hexagon:
        case PatternKind::square:
        case PatternKind::tiling:
        case PatternKind::pavement:
        case PatternKind::triangular: return tilePattern(call);
        case PatternKind::mandel:
        case PatternKind::julia:
        case PatternKind::magnetMandel:
        case PatternKind::magnetJulia: return fractalPattern(call);
        case PatternKind::function: return functionPattern(call);
        case PatternKind::slope: return slopePattern(call);
        case PatternKind::aoi: return aoiPattern(call);
        case PatternKind::radial:
        case PatternKind::spiral1:
        case PatternKind::spiral2: return spiralPattern(call);
        case PatternKind::ripples:
        case PatternKind::waves: return wavePattern(call);
        default: return shapePattern(call);
    }
}

/// Whether orbits are coloured by constants from 0 to 1 alone: by the share of the iterations, or a factor.
bool hasUnitColors(const FractalColoring& exterior, const FractalColoring& interior) {
    const auto isUnitFactor = [](const FractalColoring& coloring) {
        return coloring.type == 0 && coloring.factor >= 0 && coloring.factor <= 1;
    };
    return (exterior.type == 1 || isUnitFactor(exterior)) && isUnitFactor(interior);
}

/// Whether a pattern's raw value is in [0, 1], where remainder and negative fix change nothing.
bool staysInUnitRange(const Pattern& pattern) {
    if (const auto bounds = lookedUpBounds(pattern)) return bounds->low >= 0 && bounds->high <= 1;
    switch (pattern.kind) {
        case PatternKind::mandel:
        case PatternKind::julia:
        case PatternKind::magnetMandel:
        case PatternKind::magnetJulia: return hasUnitColors(pattern.exterior, pattern.interior);
        case PatternKind::function:
        case PatternKind::slope:
        case PatternKind::quilted:
        case PatternKind::gradient:
        case PatternKind::marble:
        case PatternKind::radial:
        case PatternKind::ripples:
        case PatternKind::spiral1:
        case PatternKind::spiral2:
        case PatternKind::waves:
        case PatternKind::wood: return false;
        default: return true;
    }
}

WaveForm defaultWave(PatternKind kind) {
    switch (kind) {
        case PatternKind::marble:
        case PatternKind::wood:
        case PatternKind::spiral1:
        case PatternKind::spiral2: return WaveForm::triangle;
        default: return WaveForm::ramp;
    }
}

double frequencyOf(const Pattern& pattern) {
    const bool isNone = isDiscrete(pattern.kind) || pattern.kind == PatternKind::quilted;
    return singlePrecision(pattern.frequency.value_or(isNone ? 0 : 1));
}

/// Steps 3 and 4 of the pipeline. The modulus 1.00001 lets a value of exactly 1 survive.
Expression wrappedToUnit(const Pattern& pattern, Expression value) {
    const double frequency = frequencyOf(pattern);
    const double phase = singlePrecision(pattern.phase.value_or(0));
    const bool unchanged = frequency == 1 && phase == 0;
    if (staysInUnitRange(pattern) && (unchanged || frequency == 0)) return value;
    if (!unchanged && frequency != 0) value = value * frequency + phase;
    if (frequency != 0) value = mod(value, value.number(1.00001));
    if (const auto bounds = lookedUpBounds(pattern); unchanged && bounds && bounds->low >= 0) return value;
    return select(value, value - floor(value), value);
}

Expression waved(const Pattern& pattern, Expression value) {
    switch (pattern.wave.value_or(defaultWave(pattern.kind))) {
        case WaveForm::triangle: return triangle(value);
        case WaveForm::sine: return (1 + cycle(value)) / 2;
        case WaveForm::scallop: return abs(cycle(value / 2));
        case WaveForm::cubic: return sq(value) * (3 - 2 * value);
        case WaveForm::poly: return pow(value, value.number(singlePrecision(pattern.waveExponent)));
        default: return value;
    }
}

}  // namespace

Expression cycle(Expression t) { return apply(Operation::cycle, t); }

Expression triangle(Expression t) { return apply(Operation::triangleWave, t); }

bool isDiscrete(PatternKind kind) {
    switch (kind) {
        case PatternKind::brick:
        case PatternKind::checker:
        case PatternKind::cubic:
        case PatternKind::hexagon:
        case PatternKind::square:
        case PatternKind::triangular: return true;
        default: return false;
    }
}

bool keepsWholeNumbers(const Pattern& pattern) {
    return frequencyOf(pattern) == 0 && pattern.wave.value_or(WaveForm::ramp) == WaveForm::ramp;
}

/// What is written last is nearest to the world, so it comes first; the classic turbulence is nearest to the
/// pattern, except for marble and wood, which use it in their own way.
PatternPoint patternPoint(const Pattern& pattern, const PatternPoint& point) {
    PatternPoint at = point;
    for (auto warp = pattern.warps.rbegin(); warp != pattern.warps.rend(); ++warp)
        at = warpedPoint(*warp, at);
    const bool isOwn = pattern.kind == PatternKind::marble || pattern.kind == PatternKind::wood;
    if (!pattern.turbulence || isOwn) return at;
    return warpedPoint(TurbulenceWarp{*pattern.turbulence, pattern.octaves, pattern.lambda, pattern.omega},
                       at);
}

Expression patternValue(const Pattern& pattern, const PatternPoint& at, int sceneNoiseGenerator) {
    const int generator = pattern.noiseGenerator != 0 ? pattern.noiseGenerator : sceneNoiseGenerator;
    const Expression raw = rawValue({pattern, at[0], at[1], at[2], generator});
    return waved(pattern, wrappedToUnit(pattern, raw));
}

Expression buildPattern(const Pattern& pattern, Expression x, Expression y, Expression z,
                        int sceneNoiseGenerator) {
    return patternValue(pattern, patternPoint(pattern, {x, y, z}), sceneNoiseGenerator);
}

}  // namespace isoscope
