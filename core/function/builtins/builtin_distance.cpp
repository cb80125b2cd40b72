// SPDX-License-Identifier: GPL-3.0-or-later
// Functions that measure distances and angles.
#include <cmath>
#include <numbers>

#include "core/function/builtins/builtin.h"
#include "core/function/builtins/builtin_formulas.h"

namespace isoscope {

namespace {

using std::numbers::pi;

Expression comma(const BuiltinCall& call) {
    const Expression &y = call.y, &z = call.z, &size = call.p[0];
    const Expression x = offAxis(call.x, z, 0.0001);
    const Expression r = length(x + size / 4, z);
    const Expression tail = lesser(z, size / 2 * cos(atan2(z, x) / 2) - length(r - 3 * size / 4, y));
    const Expression head = size / 2 - length(x - size / 2, y, z);
    return -max(tail, head);
}

Expression ellipsoid(const BuiltinCall& call) {
    const auto& [x, y, z, p, generator] = call;
    return length(p[0] * x, p[1] * y, p[2] * z);
}

/// A place in a lattice of hexagons: how far it is from a centre, along both axes, and from the nearest
/// centre of the other half of them. Whichever of the two is the nearer, what hexX and hexY measure is least
/// there: so neither has to ask, nor for the angle, and both are free of jumps.
struct HexagonPlace {
    Expression a, b, otherA, otherB;
};
HexagonPlace hexagonPlace(const BuiltinCall& call) {
    const double q = std::sqrt(3.0);
    const Expression a = offMiddle(call.x, call.x.number(q)), b = offMiddle(call.y, call.y.number(3));
    return {a, b, q / 2 - a, 1.5 - b};
}

/// From the centre of the hexagon to its side that is 0 or 60 degrees away.
Expression hexX(const BuiltinCall& call) {
    const auto [a, b, otherA, otherB] = hexagonPlace(call);
    const auto toSide = [](const Expression& across, const Expression& along) {
        return max(across, std::cos(pi / 3) * across + std::sin(pi / 3) * along);
    };
    return min(toSide(a, b), toSide(otherA, otherB));
}

/// From the nearest line through centres, at 0 or 60 degrees; the latter go through those of both halves.
Expression hexY(const BuiltinCall& call) {
    const auto [a, b, otherA, otherB] = hexagonPlace(call);
    return min(min(b, otherB), abs(std::cos(pi / 3) * b - std::sin(pi / 3) * a));
}

/// Distance from the nearest thread of a set that is `spacing` * 2 apart, times `thickness`.
Expression threadDistance(Expression t, Expression spacing, Expression thickness) {
    return offMiddle(t, 2 * spacing) * thickness;
}

Expression mesh1(const BuiltinCall& call) {
    const auto& [x, y, z, p, generator] = call;
    const Expression a = threadDistance(x, p[0], p[2]), b = threadDistance(x - p[0], p[0], p[2]);
    const Expression d = threadDistance(z, p[1], p[2]), f = threadDistance(z - p[1], p[1], p[2]);
    const Expression c = p[3] * cos(z * (pi / p[1]));
    const Expression e = p[3] * cos(x * (pi / p[0]));
    const Expression alongZ = lesser(length(a, p[4] * (y - c)), length(b, p[4] * (y + c)));
    const Expression alongX = lesser(length(d, p[4] * (y + e)), length(f, p[4] * (y - e)));
    return lesser(alongZ, alongX);
}

Expression polarAngle(const BuiltinCall& call) { return atan2(length(call.x, call.z), call.y); }

Expression poly4(const BuiltinCall& call) {
    const auto& [x, y, z, p, generator] = call;
    const Expression profile = p[0] + p[1] * y + p[2] * sq(y) + p[3] * sq(y) * y + p[4] * powi(y, 4);
    return length(x, z) - max(y.number(-5), profile);
}

Expression polytubes(const BuiltinCall& call) {
    const auto& [x, y, z, p, generator] = call;
    const Expression axis = p[1] + p[2] * y + p[3] * sq(y) + p[4] * sq(y) * y + p[5] * powi(y, 4);
    const bool known = isConstant(p[0]);
    const double count = std::trunc(std::min(constantOr(p[0], variableCountLimit), double(tubeLimit)));
    Expression nearest = x.number(10000);
    for (int i = 0; i < count; ++i) {
        const Expression angle = 2 * pi * i / p[0];
        const Expression tube = lesser(length(x - axis * sin(angle), z - axis * cos(angle)), nearest);
        nearest = known ? tube : select(p[0] - (i + 1), nearest, tube);
    }
    return nearest;
}

Expression radius(const BuiltinCall& call) { return length(call.x, call.y, call.z); }

Expression roundedBox(const BuiltinCall& call) {
    const auto& p = call.p;
    const Expression zero = call.x.number(0);
    const auto outside = [&](Expression t, Expression extent) {
        return max(max(zero, t - (extent - p[0])), p[0] - extent - t);
    };
    return length(outside(call.x, p[1]), outside(call.y, p[2]), outside(call.z, p[3])) - p[0] - 1e-6;
}

Expression sphere(const BuiltinCall& call) { return radius(call) - call.p[0]; }

Expression superellipsoid(const BuiltinCall& call) {
    const auto& [x, y, z, p, generator] = call;
    const Expression across = pow(abs(x), 2 / p[0]) + pow(abs(y), 2 / p[0]);
    return 1 - pow(pow(across, p[0] / p[1]) + pow(abs(z), 2 / p[1]), p[1] / 2);
}

Expression azimuth(const BuiltinCall& call) { return atan2(call.x, call.z); }

Expression torus(const BuiltinCall& call) {
    const auto& [x, y, z, p, generator] = call;
    return length(length(x, z) - p[0], y) - p[1];
}

constexpr NumberedFormula formulas[] = {
    {9, comma},       {17, ellipsoid},      {27, hexX},      {28, hexY},   {40, mesh1},
    {47, polarAngle}, {51, poly4},          {52, polytubes}, {57, radius}, {60, roundedBox},
    {61, sphere},     {68, superellipsoid}, {69, azimuth},   {70, torus},
};

}  // namespace

std::span<const NumberedFormula> distanceFormulas() { return formulas; }

}  // namespace isoscope
