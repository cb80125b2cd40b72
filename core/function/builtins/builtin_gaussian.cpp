// SPDX-License-Identifier: GPL-3.0-or-later
// Blobs and other functions of decaying exponentials.
#include <array>

#include "core/function/builtins/builtin_formulas.h"

namespace isoscope {

namespace {

/// The three crossed Gaussians of docs/povray/functions.md, 1.5, with eccentricity P0 and inverse size P1.
std::array<Expression, 3> crossedGaussians(const BuiltinCall& call) {
    const auto& [x, y, z, p, generator] = call;
    const Expression e = p[0], k = -p[1];
    const Expression x2 = sq(x), y2 = sq(y), z2 = sq(z);
    return {exp(k * (e * x2 + e * y2 + z2)), exp(k * (e * x2 + y2 + e * z2)),
            exp(k * (x2 + e * y2 + e * z2))};
}

Expression blob(const BuiltinCall& call) {
    const auto& [x, y, z, p, generator] = call;
    const Expression half = p[0] / 2;
    const Expression one = x.number(1);
    const Expression a = lesser(one, (sq(x + half) + sq(y) + sq(z)) * sq(p[2]));
    const Expression b = lesser(one, (sq(x - half) + sq(y) + sq(z)) * sq(p[4]));
    return -(p[1] * sq(1 - a) + p[3] * sq(1 - b));
}

Expression blob2(const BuiltinCall& call) {
    const auto& [x, y, z, p, generator] = call;
    const Expression q = sq(y) + sq(z);
    return p[3] - p[2] * (exp(-p[1] * (sq(x) + q)) + exp(-p[1] * (sq(x - p[0]) + q)));
}

Expression crossEllipsoids(const BuiltinCall& call) {
    const auto [g1, g2, g3] = crossedGaussians(call);
    return call.p[3] - call.p[2] * max(max(g1, g2), g3);
}

Expression flangeCover(const BuiltinCall& call) {
    const auto [g1, g2, g3] = crossedGaussians(call);
    return call.p[3] - call.p[2] * (g1 + g2 + g3);
}

Expression isectEllipsoids(const BuiltinCall& call) {
    const auto [g1, g2, g3] = crossedGaussians(call);
    return call.p[3] - call.p[2] * lesser(lesser(g1, g2), g3);
}

/// (2R)^2 (3 cos^2 - 1) as a polynomial, which has no pole in the middle.
Expression quantum(const BuiltinCall& call) {
    const Expression& y = call.y;
    const Expression across = sq(call.x) + sq(call.z);
    const Expression r = 2 * sqrt(across + sq(y));
    const Expression t = 4 * (2 * sq(y) - across) * exp(-r * 0.33333333);
    return -0.1 * (sq(t) - 12);
}

Expression spikes(const BuiltinCall& call) {
    const auto& [x, y, z, p, generator] = call;
    const auto [g1, g2, g3] = crossedGaussians(call);
    return p[2] * (g1 + g2 + g3 - p[4] * exp(-p[3] * (sq(x) + sq(y) + sq(z))));
}

Expression spikes2d(const BuiltinCall& call) {
    const auto& [x, y, z, p, generator] = call;
    return y - p[0] * cos(p[1] * x) * cos(p[2] * z) * exp(-p[3] * (sq(x) + sq(z)));
}

constexpr NumberedFormula formulas[] = {
    {6, blob},     {7, blob2},   {10, crossEllipsoids}, {19, flangeCover}, {32, isectEllipsoids},
    {53, quantum}, {62, spikes}, {63, spikes2d},
};

}  // namespace

std::span<const NumberedFormula> gaussianFormulas() { return formulas; }

}  // namespace isoscope
