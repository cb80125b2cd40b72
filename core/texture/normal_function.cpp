// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/texture/normal_function.h"

#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>
#include <numbers>

#include "core/function/builtins/formula_blocks.h"
#include "core/function/patterns/wave_sources.h"
#include "core/function/surface_variables.h"
#include "core/texture/tables/facet_table.h"
#include "core/texture/tables/image_table.h"
#include "core/texture/map_value.h"
#include "core/texture/surface_needs.h"

namespace isoscope {

namespace {

using Vector = std::array<Expression, 3>;

Vector unit(const Vector& v) {
    const Expression size = length(v[0], v[1], v[2]);
    return {v[0] / size, v[1] / size, v[2] / size};
}

Vector plus(const Vector& a, const Vector& b) { return {a[0] + b[0], a[1] + b[1], a[2] + b[2]}; }
Vector times(const Vector& a, Expression k) { return {a[0] * k, a[1] * k, a[2] * k}; }
Vector times(const Vector& a, double k) { return {a[0] * k, a[1] * k, a[2] * k}; }

Vector multiplied(const glm::dmat3& m, const Vector& v) {
    Vector result;
    for (int row = 0; row < 3; ++row)
        result[static_cast<std::size_t>(row)] = v[0] * m[0][row] + v[1] * m[1][row] + v[2] * m[2][row];
    return result;
}

/// The linear part of all transformations among the warps, from the outside to where the pattern is looked
/// up.
glm::dmat3 inwardMatrix(const Pattern& pattern) {
    glm::dmat3 inward(1);
    for (auto warp = pattern.warps.rbegin(); warp != pattern.warps.rend(); ++warp) {
        const auto* transform = std::get_if<TransformWarp>(&*warp);
        if (!transform) continue;
        glm::dmat3 step;
        for (int row = 0; row < 3; ++row)
            for (int column = 0; column < 3; ++column)
                step[row][column] = transform->inverse[static_cast<std::size_t>(3 * row + column)];
        inward = step * inward;
    }
    return inward;
}

Vector vectorNoise(const PatternPoint& p, double factor) {
    FunctionGraph& graph = p[0].graph();
    const auto scaled = [&](const Expression& c) { return (factor == 1 ? c : c * factor).node(); };
    const NodeId x = scaled(p[0]), y = scaled(p[1]), z = scaled(p[2]);
    return {Expression(graph, graph.ternary(Operation::noiseGradientX, x, y, z)),
            Expression(graph, graph.ternary(Operation::noiseGradientY, x, y, z)),
            Expression(graph, graph.ternary(Operation::noiseGradientZ, x, y, z))};
}

/// One normal block being turned into operations.
class NormalBuilder {
  public:
    NormalBuilder(const SurfaceNormal& normal, const PatternSettings& settings)
        : normal_(normal), pattern_(normal.pattern), settings_(settings) {
        pattern_.numberOfWaves = settings.numberOfWaves;
    }

    Vector build(const PatternPoint& point, const Vector& normal) {
        at_ = patternPoint(pattern_, normal_.onSurface ? surfacePoint(point[0].graph()) : point);
        const glm::dmat3 inward = inwardMatrix(pattern_);
        // Normals go inward by the inverse transpose, and back by the transpose.
        const Vector turned = multiplied(glm::transpose(glm::inverse(inward)), normal);
        const Vector start = normal_.scaled ? unit(turned) : turned;
        const Vector bent = normal_.flat                      ? start
                            : normal_.kind == NormalKind::map ? mapped(start)
                            : normal_.kind == NormalKind::facets
                                ? faceted(unit(start))
                                : plus(start, times(bend(start), normal_.amount));
        return unit(multiplied(glm::transpose(inward), bent));
    }

  private:
    Vector bend(const Vector& start) const {
        switch (normal_.kind) {
            case NormalKind::bumps: return vectorNoise(at_, 1);
            case NormalKind::dents: {
                const int own = pattern_.noiseGenerator;
                const Expression size =
                    noise(at_[0].number(own != 0 ? own : settings_.noiseGenerator), at_[0], at_[1], at_[2]);
                return times(vectorNoise(at_, 1), powi(size, 3));
            }
            case NormalKind::quilted: return quilted();
            case NormalKind::wrinkles: return wrinkles();
            case NormalKind::ripples: return waves(false);
            case NormalKind::waves: return waves(true);
            case NormalKind::image: return imageBumps(unit(start));
            default: return slope();
        }
    }

    /// The same all over a cell of crackle: of the normals, or of space.
    Vector faceted(const Vector& start) const {
        const auto [size, coords] = normal_.facets;
        if (!(size > 0)) return start;
        if (coords == 0) return cellPoint(times(start, 1 / size));
        const Vector random = vectorNoise(cellPoint(times(at_, 1 / size)), 1);
        const Expression along = start[0] * random[0] + start[1] * random[1] + start[2] * random[2];
        return plus(start, times(plus(random, times(start, -along)), coords));
    }

    /// The nearest cell point of crackle.
    Vector cellPoint(const Vector& point) const {
        FunctionGraph& graph = point[0].graph();
        Vector result;
        for (std::size_t axis = 0; axis < 3; ++axis) {
            CrackleSettings settings;
            settings.table = std::make_shared<const FacetTable>(axis, pattern_.crackle.metric);
            const NodeId fromCorner =
                graph.crackle(settings, point[0].node(), point[1].node(), point[2].node());
            result[axis] = floor(point[axis]) + Expression(graph, fromCorner);
        }
        return result;
    }

    /// Away from the middle of each unit cube, by the curve of the pattern of that name.
    Vector quilted() const {
        const auto fromMiddle = [](Expression t) { return t - floor(t) - 0.5; };
        const Vector way = {fromMiddle(at_[0]), fromMiddle(at_[1]), fromMiddle(at_[2])};
        const Expression r = length(way[0], way[1], way[2]), rest = 1 - r;
        const double control0 = static_cast<float>(pattern_.control0),
                     control1 = static_cast<float>(pattern_.control1);
        const Expression curve = 3 * control0 * r * sq(rest) + 3 * control1 * sq(r) * rest + powi(r, 3);
        // 2/sqrt(3) to nine digits.
        return times(way, 2 * 0.577350269 * curve);
    }

    Vector wrinkles() const {
        Vector sum = {at_[0].number(0), at_[0].number(0), at_[0].number(0)};
        double frequency = 1;
        for (int octave = 0; octave < 10; ++octave, frequency *= 2) {
            const Vector term = vectorNoise(at_, frequency);
            sum = plus(sum, times({abs(term[0]), abs(term[1]), abs(term[2])}, 1 / frequency));
        }
        return sum;
    }

    /// Against the slope of the triangle between a sample and those beside the one below, of which one edge
    /// goes around the y axis and the other upwards.
    Vector imageBumps(const Vector& n) const {
        const auto height = [&](int right, int below) {
            return imageValue(normal_.image, ImageChannel::storedGray, at_, right, below);
        };
        const Expression middle = height(0, 0), left = height(-1, 1), right = height(1, 1);
        const Expression level = sqrt(sq(n[0]) + sq(n[2])), one = level.number(1), none = level.number(0);
        const Expression upright = level - 1e-9;
        const Vector around = {select(upright, one, -n[2] / level), none,
                               select(upright, none, n[0] / level)};
        const Vector upwards = {around[1] * n[2] - around[2] * n[1], around[2] * n[0] - around[0] * n[2],
                                around[0] * n[1] - around[1] * n[0]};
        return plus(times(around, (left - right) / 2), times(upwards, (left + right) / 2 - middle));
    }

    Vector waves(bool ownFrequencies) const {
        const double frequency = static_cast<float>(pattern_.frequency.value_or(1));
        const double phase = static_cast<float>(pattern_.phase.value_or(0));
        const std::vector<WaveSource> sources = waveSources(pattern_.numberOfWaves);
        Vector sum = {at_[0].number(0), at_[0].number(0), at_[0].number(0)};
        for (const WaveSource& source : sources) {
            const Vector way = {at_[0] - source.position[0], at_[1] - source.position[1],
                                at_[2] - source.position[2]};
            const Expression measured = length(way[0], way[1], way[2]);
            const Expression distance = select(measured, measured, measured.number(1), measured);
            const double own = ownFrequencies ? source.frequency : 1;
            const Expression turns = distance * (frequency * own) + phase;
            const Expression wave = sin(2 * std::numbers::pi * (turns - floor(turns)));
            sum = plus(sum, times(way, wave / distance * (1 / own)));
        }
        return times(sum, 1.0 / static_cast<double>(sources.size()));
    }

    /// Against the slope of the pattern, which is looked up at the corners of a tetrahedron.
    Vector slope() const {
        static constexpr double corners[4][3] = {{0.942809041, -0.333333333, 0},
                                                 {-0.471404521, -0.333333333, 0.816496581},
                                                 {-0.471404521, -0.333333333, -0.816496581},
                                                 {0, 1, 0}};
        // POV-Ray's bumps are this much higher than the amount says, whatever the accuracy.
        constexpr double usualAccuracy = 0.02, height = -5;
        const double reach = normal_.accuracy;
        Vector sum = {at_[0].number(0), at_[0].number(0), at_[0].number(0)};
        for (const auto& corner : corners) {
            const PatternPoint near = {at_[0] + corner[0] * reach, at_[1] + corner[1] * reach,
                                       at_[2] + corner[2] * reach};
            const Expression value = heightAt(patternValue(pattern_, near, settings_.noiseGenerator));
            for (std::size_t axis = 0; axis < 3; ++axis)
                if (corner[axis] != 0) sum[axis] = sum[axis] + corner[axis] * value;
        }
        return times(sum, height * usualAccuracy / reach);
    }

    /// The slope map: a cubic between two entries, whose slopes are given for the way from one to the other.
    Expression heightAt(Expression value) const {
        const std::vector<SlopeEntry>& entries = normal_.slopes;
        if (entries.empty()) return value;
        Expression result = value.number(entries.back().height);
        for (std::size_t k = entries.size(); k-- > 0;) {
            const Expression here =
                k == 0 ? value.number(entries[0].height) : cubic(value, entries[k - 1], entries[k]);
            result = k + 1 == entries.size() ? here : select(entries[k].position - value, result, here);
        }
        return select(value - entries.back().position, result, value.number(entries.back().height));
    }

    static Expression cubic(Expression value, const SlopeEntry& from, const SlopeEntry& to) {
        if (!(to.position > from.position)) return value.number(to.height);
        const Expression t = (value - from.position) / (to.position - from.position);
        const double rise = to.height - from.height;
        const double second = 3 * rise - 2 * from.slope - to.slope, third = from.slope + to.slope - 2 * rise;
        return from.height + t * (from.slope + t * (second + t * third));
    }

    Vector mapped(const Vector& start) const {
        std::vector<double> positions;
        std::vector<Vector> normals;
        for (const SurfaceNormal::Entry& entry : normal_.entries) {
            positions.push_back(entry.position);
            normals.push_back(entry.normal ? NormalBuilder(*entry.normal, settings_).build(at_, start)
                                           : unit(start));
        }
        const Expression value = normal_.mapKind == MapKind::average
                                     ? at_[0].number(0)
                                     : patternValue(pattern_, at_, settings_.noiseGenerator);
        Vector result;
        for (std::size_t axis = 0; axis < 3; ++axis) {
            std::vector<Expression> choices;
            for (const Vector& normal : normals) choices.push_back(normal[axis]);
            result[axis] = mapValue(lookupOf(normal_.mapKind, pattern_), value, positions, choices);
        }
        return result;
    }

    const SurfaceNormal& normal_;
    Pattern pattern_;
    PatternSettings settings_;
    PatternPoint at_;
};

}  // namespace

Function normalFunction(const SurfaceNormal& normal, const PatternSettings& settings) {
    FunctionGraph graph;
    const auto variable = [&](int k) { return Expression(graph, graph.variable(k)); };
    const Vector result =
        NormalBuilder(normal, settings)
            .build({variable(0), variable(1), variable(2)}, {variable(3), variable(4), variable(5)});
    if (graph.overflowed()) return {};
    return finish(std::move(graph), {result[0].node(), result[1].node(), result[2].node()},
                  needsSurface(normal) ? surface_variable::count : 6);
}

}  // namespace isoscope
