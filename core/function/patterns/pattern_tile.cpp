// SPDX-License-Identifier: GPL-3.0-or-later
// Patterns of discrete values: brick, checker, cubic, hexagon, square, triangular; tilings and pavements.
#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>
#include <optional>
#include <utility>

#include "core/function/patterns/kite_tiling.h"
#include "core/function/patterns/pattern_call.h"
#include "core/function/patterns/pavement.h"
#include "core/function/patterns/penrose_tiling.h"
#include "core/function/patterns/tilings.h"

namespace isoscope {

namespace {

constexpr double tiny = 1e-10;

Expression fraction(Expression t) { return t - floor(t); }

/// Where a <= b, the first value, else the second.
Expression whereAtMost(Expression a, Expression b, Expression first, Expression second) {
    return select(b - a, second, first);
}

/// A whole, non-negative number modulo another.
Expression wholeModulo(Expression number, double modulus) {
    return number - modulus * floor(number / modulus);
}

Expression brick(const PatternCall& call) {
    const auto& size = call.pattern.brickSize;
    const double mortar = singlePrecision(call.pattern.mortar - 2 * tiny);
    const Expression x = (call.x + (tiny + mortar)) / size[0];
    const Expression y = call.y + (tiny + mortar);
    const Expression z = (call.z + (tiny + mortar)) / size[2];
    const Expression zero = call.number(0), one = call.number(1), half = call.number(0.5);
    const auto row = [&](Expression u, Expression w) {
        const Expression inRow = whereAtMost(fraction(w), call.number(mortar / size[2]), zero, one);
        return whereAtMost(fraction(u), call.number(mortar / size[0]), zero, inRow);
    };
    const Expression rows = whereAtMost(fraction(y / (2 * size[1])), half, row(x, z + 0.5), row(x + 0.5, z));
    return whereAtMost(fraction(y / size[1]), call.number(mortar / size[1]), zero, rows);
}

Expression checker(const PatternCall& call) {
    const Expression sum = floor(call.x + tiny) + floor(call.y + tiny) + floor(call.z + tiny);
    return sum - 2 * floor(sum / 2);
}

/// The cells m = 1 and m = 4, which the slanted sides of the hexagons cross.
Expression slantedCell(Expression x, Expression z, double m, Expression n) {
    const Expression inner = x - m;
    const Expression odd = wholeModulo(m + n, 2);
    const Expression across = select(odd - 0.5, inner, 1 - inner);
    const Expression a = select(across, across, x.number(0.0001), across);
    const Expression below = wholeModulo(2 * n, 3), above = 2 - wholeModulo(n, 3);
    // A side where (z - n) / a is 1, which a of 0 would leave without a value.
    return select((z - n) - a, below, above);
}

/// The decimal constants are part of the definition.
Expression hexagon(const PatternCall& call) {
    const auto reduced = [](Expression t) { return t - 6 * floor(t / 6); };
    const Expression x = reduced(abs(call.x) / 0.5);
    const Expression z = reduced(select(call.z, 5.196152424 + call.z, call.z) / 0.866025404);
    const Expression n = floor(z);
    const Expression outer = floor(wholeModulo(n + 1, 6) / 2);
    const Expression middle = wholeModulo(floor(n / 2) + 2, 3);
    const Expression right = select(x - 4, middle, select(x - 5, slantedCell(x, z, 4, n), outer));
    return select(x - 1, outer, select(x - 2, slantedCell(x, z, 1, n), right));
}

/// The side of a cube around the origin that a point is seen through: +x, +y, +z, -x, -y, -z are 0 to 5.
/// Measured on POV-Ray 3.7.
Expression cubic(const PatternCall& call) {
    const auto& [pattern, x, y, z, generator] = call;
    const auto side = [](Expression t, double positive) {
        return select(t, t.number(positive + 3), t.number(positive));
    };
    const Expression yOrZ = whereAtMost(abs(z), abs(y), side(y, 1), side(z, 2));
    return whereAtMost(max(abs(y), abs(z)), abs(x), side(x, 0), yOrZ);
}

/// Squares of the xz plane in four colours, counted about a corner. Measured on POV-Ray 3.7.
Expression square(const PatternCall& call) {
    const auto odd = [](Expression t) { return floor(t) - 2 * floor(floor(t) / 2); };
    const Expression x = odd(call.x), z = odd(call.z);
    return select(x - 0.5, z, 3 - z);
}

/// Triangles of the xz plane with sides of 1 in six colours, those that point to +z and the others by turns.
/// Measured on POV-Ray 3.7.
Expression triangular(const PatternCall& call) {
    constexpr double height = std::numbers::sqrt3 / 2;
    const Expression up = call.z / height, right = call.x - up / 2;
    const Expression row = floor(up), column = floor(right);
    const Expression third = wholeModulo(column - row, 3);
    const auto ofThird = [&](double first, double second, double last) {
        return select(third - 0.5, call.number(first),
                      select(third - 1.5, call.number(second), call.number(last)));
    };
    return select((up - row) + (right - column) - 1, ofThird(0, 4, 2), ofThird(3, 5, 1));
}

/// What the pattern is at a point if it lies in a tile, and how far inside it lies, below 0 outside.
struct TileValue {
    Expression inside, value;
};

TileValue valueOf(const Tiling& tiling, const Tile& tile, Expression x, Expression z) {
    std::optional<Expression> least, leastBevels;
    for (std::size_t k = 0; k < tile.corners.size(); ++k) {
        const PlanePoint &a = tile.corners[k], &b = tile.corners[(k + 1) % tile.corners.size()];
        const double length = std::hypot(b[0] - a[0], b[1] - a[1]);
        const double nx = (a[1] - b[1]) / length, nz = (b[0] - a[0]) / length;
        const Expression depth = (x * nx + z * nz) - (a[0] * nx + a[1] * nz);
        const Expression bevels = depth / (tile.bevels.empty() ? tiling.bevel : tile.bevels[k]);
        least = least ? min(*least, depth) : depth;
        leastBevels = leastBevels ? min(*leastBevels, bevels) : bevels;
    }
    return {*least, (clamp(1 - *leastBevels, x.number(0), x.number(1)) + tile.kind) / tiling.kinds};
}

Expression tabled(const PatternCall& call, std::shared_ptr<const PointTable> table) {
    CrackleSettings settings;
    settings.table = std::move(table);
    FunctionGraph& graph = call.x.graph();
    return {graph, graph.crackle(settings, call.x.node(), call.y.node(), call.z.node())};
}

std::shared_ptr<const PointTable> penroseTable(int number) {
    static const auto pentagons = std::make_shared<const KiteTiling>(KiteTiling::Tiles::pentagons);
    static const auto kites = std::make_shared<const KiteTiling>(KiteTiling::Tiles::kites);
    static const auto rhombs = std::make_shared<const PenroseTiling>();
    if (number == pentagonTiling) return pentagons;
    if (number == kiteTiling) return kites;
    return rhombs;
}

/// Measured on POV-Ray 3.7: Tiling.
Expression tilingPattern(const PatternCall& call) {
    if (call.pattern.tiling > tilingCount) return tabled(call, penroseTable(call.pattern.tiling));
    const Tiling& tiling = tilingOf(call.pattern.tiling);
    const PlanePoint &a = tiling.across, &b = tiling.along;
    const double area = a[0] * b[1] - a[1] * b[0];
    const Expression across = floor((call.x * b[1] - call.z * b[0]) / area),
                     along = floor((call.z * a[0] - call.x * a[1]) / area);
    const Expression x = call.x - (across * a[0] + along * b[0]), z = call.z - (across * a[1] + along * b[1]);
    std::optional<Expression> result;
    for (const Tile& tile : tilesInCell(tiling)) {
        const TileValue here = valueOf(tiling, tile, x, z);
        result = result ? select(here.inside, *result, here.value) : here.value;
    }
    return *result;
}

}  // namespace

Expression tilePattern(const PatternCall& call) {
    switch (call.pattern.kind) {
        case PatternKind::brick: return brick(call);
        case PatternKind::checker: return checker(call);
        case PatternKind::cubic: return cubic(call);
        case PatternKind::square: return square(call);
        case PatternKind::tiling: return tilingPattern(call);
        case PatternKind::pavement: return tabled(call, Pavement::of(call.pattern.pavement));
        case PatternKind::triangular: return triangular(call);
        default: return hexagon(call);
    }
}

}  // namespace isoscope
