// SPDX-License-Identifier: GPL-3.0-or-later
// Polynomial surfaces whose shape has parameters behind the field strength P0.
#include "core/function/builtins/builtin_formulas.h"

namespace isoscope {

namespace {

Expression bicorn(const BuiltinCall& call) {
    const auto& [x, y, z, p, generator] = call;
    const Expression h = sq(x) + sq(z);
    const Expression e = sq(y) * (sq(p[1]) - h) - sq(h + 2 * p[1] * y - sq(p[1]));
    return limited(p[0] * e);
}

Expression bifolia(const BuiltinCall& call) {
    const auto& [x, y, z, p, generator] = call;
    const Expression h = sq(x) + sq(z);
    return limited(-p[0] * (sq(h + sq(y)) - p[1] * h * y));
}

Expression dupinCyclide(const BuiltinCall& call) {
    const auto& [x, y, z, p, generator] = call;
    const Expression k = sq(p[5]);
    const Expression s = sq(x) + sq(y) + sq(z);
    const Expression q = sq(p[2]) - sq(p[4]) - sq(p[3] + p[1]);
    const Expression r = sq(p[2]) - sq(p[4]) - sq(p[3] - p[1]);
    const Expression m = p[3] * x + p[4] * y;
    const Expression inner =
        (sq(p[2]) + sq(p[1]) - sq(p[3]) - sq(p[4])) * (2 * m - k) - 4 * p[4] * sq(p[2]) * y;
    const Expression e = q * r * sq(s) + 2 * k * inner * s + 4 * sq(k) * m * (m - k) +
                         4 * sq(k) * sq(p[1]) * sq(y) + powi(k, 4);
    return limited(-p[0] * e);
}

Expression foliumSurface(const BuiltinCall& call) {
    const auto& [x, y, z, p, generator] = call;
    const Expression e = (sq(y) + sq(z)) * (1 + (p[2] - 4 * p[1]) * x) + sq(x) * (1 + p[2]);
    return limited(p[0] * e);
}

Expression hyperbolicTorus(const BuiltinCall& call) {
    const auto& [x, y, z, p, generator] = call;
    const Expression a = sq(p[1]), b = sq(p[2]);
    const Expression e = powi(x, 4) + 2 * sq(x) * sq(y) - 2 * sq(x) * sq(z) - 2 * (a + b) * sq(x) +
                         powi(y, 4) - 2 * sq(y) * sq(z) + 2 * (a - b) * sq(y) + powi(z, 4) +
                         2 * (a + b) * sq(z) + sq(a - b);
    return limited(-p[0] * e);
}

Expression kampyleOfEudoxus(const BuiltinCall& call) {
    const auto& [x, y, z, p, generator] = call;
    const Expression e = sq(y) + sq(z) - sq(p[2]) * powi(x, 4) + sq(p[2]) * sq(p[1]) * sq(x);
    return limited(-p[0] * e);
}

Expression kummerSurface2(const BuiltinCall& call) {
    const auto& [x, y, z, p, generator] = call;
    const Expression e = powi(x, 4) + powi(y, 4) + powi(z, 4) + p[1] * (sq(x) + sq(y) + sq(z)) +
                         p[2] * (sq(x) * sq(y) + sq(x) * sq(z) + sq(y) * sq(z)) + p[3] * x * y * z - 1;
    return limited(-p[0] * e);
}

Expression ovalsOfCassini(const BuiltinCall& call) {
    const auto& [x, y, z, p, generator] = call;
    const Expression s = sq(x) + sq(y) + sq(z) + sq(p[1]);
    const Expression e = sq(s) - p[3] * sq(p[1]) * (sq(x) + sq(z)) - sq(p[2]);
    return limited(-p[0] * e);
}

Expression parabolicTorus(const BuiltinCall& call) {
    const auto& [x, y, z, p, generator] = call;
    const Expression a = sq(p[1]), b = sq(p[2]);
    const Expression e = powi(x, 4) + 2 * sq(x) * sq(y) - 2 * sq(x) * z - (a + b) * sq(x) + powi(y, 4) -
                         2 * sq(y) * z + (a - b) * sq(y) + sq(z) + (a + b) * z + sq(a - b);
    return limited(-p[0] * e);
}

Expression quarticCylinder(const BuiltinCall& call) {
    const auto& [x, y, z, p, generator] = call;
    const Expression h = sq(x) + sq(z);
    const Expression e = h * sq(y) + sq(p[2]) * h - sq(p[2]) * sq(p[1]);
    return limited(-p[0] * e);
}

Expression strophoid(const BuiltinCall& call) {
    const auto& [x, y, z, p, generator] = call;
    const Expression e = (p[2] - x) * (sq(y) + sq(z)) - sq(p[3]) * p[1] * sq(x) - sq(p[3]) * sq(x) * x;
    return limited(-p[0] * e);
}

Expression torus2(const BuiltinCall& call) {
    const auto& [x, y, z, p, generator] = call;
    const Expression a = sq(p[1]), b = sq(p[2]);
    const Expression e = powi(x, 4) + powi(y, 4) + powi(z, 4) + 2 * sq(x) * sq(y) + 2 * sq(x) * sq(z) +
                         2 * sq(y) * sq(z) - 2 * (a + b) * sq(x) + 2 * (a - b) * sq(y) - 2 * (a + b) * sq(z) +
                         sq(a - b);
    return limited(-p[0] * e);
}

Expression witchOfAgnesi(const BuiltinCall& call) {
    const auto& [x, y, z, p, generator] = call;
    return limited(-p[0] * (p[1] * (y - 1) + (sq(x) + sq(z)) * y));
}

constexpr NumberedFormula formulas[] = {
    {4, bicorn},           {5, bifolia},           {16, dupinCyclide},   {20, foliumSurface},
    {31, hyperbolicTorus}, {33, kampyleOfEudoxus}, {37, kummerSurface2}, {44, ovalsOfCassini},
    {46, parabolicTorus},  {56, quarticCylinder},  {66, strophoid},      {71, torus2},
    {74, witchOfAgnesi},
};

}  // namespace

std::span<const NumberedFormula> shapedFormulas() { return formulas; }

}  // namespace isoscope
