// SPDX-License-Identifier: GPL-3.0-or-later
// Polynomial surfaces of one shape: P0 is the field strength (docs/povray/functions.md, 1.2) and nothing
// else.
#include <numbers>

#include "core/function/builtins/builtin_formulas.h"

namespace isoscope {

namespace {

Expression boySurface(const BuiltinCall& call) {
    const auto& [x, y, z, p, generator] = call;
    const Expression w = 1 - z;
    const Expression h = sq(x) + sq(y);
    constexpr double q = std::numbers::sqrt2;
    const Expression z2 = sq(z), z4 = powi(z, 4);
    const Expression e =
        64 * powi(w, 3) * powi(z, 3) - 48 * sq(w) * z2 * (3 * h + 2 * z2) +
        12 * w * z * (27 * sq(h) - 24 * z2 * h + 36 * q * y * z * (sq(y) - 3 * sq(x)) + 4 * z4) +
        (9 * h - 2 * z2) * (-81 * sq(h) - 72 * z2 * h + 108 * q * x * z * (sq(x) - 3 * sq(y)) + 4 * z4);
    return limited(p[0] * p[1] * e);
}

Expression crossedTrough(const BuiltinCall& call) {
    const auto& [x, y, z, p, generator] = call;
    return limited(p[0] * (sq(x) * sq(z) - y));
}

Expression cubicSaddle(const BuiltinCall& call) {
    const auto& [x, y, z, p, generator] = call;
    return limited(-p[0] * (powi(x, 3) - powi(y, 3) - z));
}

/// f_cushion and f_odd are one function.
Expression cushion(const BuiltinCall& call) {
    const auto& [x, y, z, p, generator] = call;
    const Expression e = sq(z) * sq(x) - powi(z, 4) - 2 * z * sq(x) + 2 * sq(z) * z + sq(x) - sq(z) -
                         sq(sq(x) - z) - powi(y, 4) - 2 * sq(x) * sq(y) - sq(y) * sq(z) + 2 * sq(y) * z +
                         sq(y);
    return limited(p[0] * e);
}

Expression devilsCurve(const BuiltinCall& call) {
    const auto& [x, y, z, p, generator] = call;
    const Expression e =
        powi(x, 4) + 2 * sq(x) * sq(z) - 0.36 * sq(x) - powi(y, 4) + 0.25 * sq(y) + powi(z, 4);
    return limited(-p[0] * e);
}

/// As POV-Ray 3.7 has it, without the constant terms of the classical equation.
Expression enneper(const BuiltinCall& call) {
    const auto& [x, y, z, p, generator] = call;
    const Expression w = select(abs(z) - 0.2, z.number(0.2), z);
    const Expression d = sq(y) - sq(x);
    const Expression a = d / (2 * w) + 2 * sq(z) / 9;
    const Expression b = d / (4 * w);
    return limited(-p[0] * (powi(a, 3) - 6 * sq(b)));
}

Expression glob(const BuiltinCall& call) {
    const auto& [x, y, z, p, generator] = call;
    const Expression x4 = powi(x, 4);
    return limited(p[0] * (0.5 * x4 * x + 0.5 * x4 - (sq(y) + sq(z))));
}

Expression heart(const BuiltinCall& call) {
    const auto& [x, y, z, p, generator] = call;
    const Expression e = powi(2 * sq(x) + sq(y) + sq(z) - 1, 3) - 0.1 * sq(x) * sq(z) * z - sq(y) * sq(z) * z;
    return limited(-p[0] * e);
}

Expression huntSurface(const BuiltinCall& call) {
    const auto& [x, y, z, p, generator] = call;
    const Expression e =
        4 * powi(sq(x) + sq(y) + sq(z) - 13, 3) + 27 * sq(3 * sq(x) + sq(y) - 4 * sq(z) - 12);
    return limited(-p[0] * e);
}

Expression kleinBottle(const BuiltinCall& call) {
    const auto& [x, y, z, p, generator] = call;
    const Expression s = sq(x) + sq(y) + sq(z);
    const Expression m = s - 2 * y - 1;
    const Expression e = (s + 2 * y - 1) * (sq(m) - 8 * sq(z)) + 16 * x * z * m;
    return limited(-p[0] * e);
}

Expression kummerSurface1(const BuiltinCall& call) {
    const auto& [x, y, z, p, generator] = call;
    const Expression e = powi(x, 4) + powi(y, 4) + powi(z, 4) - sq(x) - sq(y) - sq(z) - sq(x) * sq(y) -
                         sq(x) * sq(z) - sq(y) * sq(z) + 1;
    return limited(-p[0] * e);
}

Expression lemniscateOfGerono(const BuiltinCall& call) {
    const auto& [x, y, z, p, generator] = call;
    return limited(-p[0] * (powi(x, 4) - sq(x) + sq(y) + sq(z)));
}

Expression mitre(const BuiltinCall& call) {
    const auto& [x, y, z, p, generator] = call;
    const Expression e = 4 * sq(x) * (sq(x) + sq(y) + sq(z)) - sq(y) * (1 - sq(y) - sq(z));
    return limited(-p[0] * e);
}

Expression nodalCubic(const BuiltinCall& call) {
    const auto& [x, y, z, p, generator] = call;
    return limited(-p[0] * (powi(y, 3) + powi(z, 3) - 6 * y * z));
}

Expression paraboloid(const BuiltinCall& call) {
    const auto& [x, y, z, p, generator] = call;
    return limited(-p[0] * (sq(x) - y + sq(z)));
}

Expression pillow(const BuiltinCall& call) {
    const auto& [x, y, z, p, generator] = call;
    const Expression e = powi(x, 4) + powi(y, 4) + powi(z, 4) - (sq(x) + sq(y) + sq(z));
    return limited(p[0] * e);
}

Expression piriform(const BuiltinCall& call) {
    const auto& [x, y, z, p, generator] = call;
    return -limited(-p[0] * (powi(x, 4) - sq(x) * x + sq(y) + sq(z)));
}

Expression quarticParaboloid(const BuiltinCall& call) {
    const auto& [x, y, z, p, generator] = call;
    return limited(-p[0] * (powi(x, 4) + powi(z, 4) - y));
}

Expression quarticSaddle(const BuiltinCall& call) {
    const auto& [x, y, z, p, generator] = call;
    return limited(-p[0] * (powi(x, 4) - powi(z, 4) - y));
}

Expression steinersRoman(const BuiltinCall& call) {
    const auto& [x, y, z, p, generator] = call;
    return limited(-p[0] * (sq(x) * sq(y) + sq(x) * sq(z) + sq(y) * sq(z) + x * y * z));
}

Expression torusGumdrop(const BuiltinCall& call) {
    const auto& [x, y, z, p, generator] = call;
    const Expression h = sq(y) + sq(z);
    const Expression e = 4 * (powi(x, 4) + sq(h)) + 17 * sq(x) * h - 20 * (sq(x) + h) + 17;
    return limited(-p[0] * e);
}

Expression umbrella(const BuiltinCall& call) {
    const auto& [x, y, z, p, generator] = call;
    return limited(-p[0] * (sq(x) - y * sq(z)));
}

constexpr NumberedFormula formulas[] = {
    {8, boySurface},
    {11, crossedTrough},
    {12, cubicSaddle},
    {13, cushion},
    {14, devilsCurve},
    {18, enneper},
    {22, glob},
    {23, heart},
    {30, huntSurface},
    {35, kleinBottle},
    {36, kummerSurface1},
    {38, lemniscateOfGerono},
    {41, mitre},
    {42, nodalCubic},
    {43, cushion},
    {45, paraboloid},
    {48, pillow},
    {49, piriform},
    {54, quarticParaboloid},
    {55, quarticSaddle},
    {65, steinersRoman},
    {72, torusGumdrop},
    {73, umbrella},
};

}  // namespace

std::span<const NumberedFormula> algebraicFormulas() { return formulas; }

}  // namespace isoscope
