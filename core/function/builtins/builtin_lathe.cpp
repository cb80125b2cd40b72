// SPDX-License-Identifier: GPL-3.0-or-later
// Plane curves that are extruded along z or turned about the y axis (docs/povray/functions.md, 1.3).
#include "core/function/builtins/builtin_formulas.h"

namespace isoscope {

namespace {

/// The profile with switch, offset and angle in the parameters `first` to `first` + 2.
std::pair<Expression, Expression> profile(const BuiltinCall& call, std::size_t first) {
    return latheProfile(call.x, call.y, call.z, call.p[first], call.p[first + 1], call.p[first + 2]);
}

Expression algebraicCylinder1(const BuiltinCall& call) {
    const auto& p = call.p;
    const auto [u, v] = profile(call, 2);
    const Expression e = powi(abs(u), 3) - sq(u) + sq(v);
    return -limited(-p[0] * e, p[1]);
}

Expression algebraicCylinder2(const BuiltinCall& call) {
    const auto& p = call.p;
    const auto [u, v] = profile(call, 2);
    const Expression e = 2 * powi(u, 4) - 3 * sq(u) * v + sq(v) - 2 * powi(v, 3) + powi(v, 4);
    return limited(-p[0] * e, p[1]);
}

Expression algebraicCylinder3(const BuiltinCall& call) {
    const auto& p = call.p;
    const auto [u, v] = profile(call, 2);
    const Expression e = powi(u, 4) + sq(u) * sq(v) - 2 * sq(u) * v - u * sq(v) + sq(v);
    return limited(-p[0] * e, p[1]);
}

Expression algebraicCylinder4(const BuiltinCall& call) {
    const auto& p = call.p;
    const auto [u, v] = profile(call, 2);
    const Expression e = powi(u, 4) + powi(v, 4) + 2 * sq(u) * sq(v) + 3 * sq(u) * v - powi(v, 3);
    return limited(-p[0] * e, p[1]);
}

Expression devilsCurve2d(const BuiltinCall& call) {
    const auto& p = call.p;
    const auto [u, v] = profile(call, 3);
    const Expression e = sq(u) * (sq(u) - sq(p[1])) - sq(v) * (sq(v) - sq(p[2]));
    return limited(-p[0] * e);
}

Expression foliumSurface2d(const BuiltinCall& call) {
    const auto& p = call.p;
    const auto [u, v] = profile(call, 3);
    const Expression e = sq(v) * (1 + (p[2] - 4 * p[1]) * u) + sq(u) * (1 + p[2]);
    return limited(-p[0] * e);
}

Expression kampyleOfEudoxus2d(const BuiltinCall& call) {
    const auto& p = call.p;
    const auto [u, v] = profile(call, 3);
    const Expression e = sq(v) - sq(p[2]) * powi(u, 4) + sq(p[2]) * p[1] * p[2] * sq(u);
    return limited(-p[0] * e);
}

Expression lemniscateOfGerono2d(const BuiltinCall& call) {
    const auto& p = call.p;
    const auto [u, v] = profile(call, 3);
    const Expression e = sq(v) - sq(p[2]) * sq(p[1]) * sq(u) + sq(p[2]) * powi(u, 4);
    return limited(-p[0] * e);
}

Expression piriform2d(const BuiltinCall& call) {
    const auto& p = call.p;
    const auto [u, v] = profile(call, 4);
    const Expression e = sq(v) - p[1] * sq(p[3]) * sq(u) * u - p[2] * sq(p[3]) * powi(u, 4);
    return limited(-p[0] * e);
}

Expression strophoid2d(const BuiltinCall& call) {
    const auto& p = call.p;
    const auto [u, v] = profile(call, 4);
    const Expression e = (p[2] - u) * sq(v) - sq(p[3]) * p[1] * sq(u) - sq(p[3]) * sq(u) * u;
    return limited(-p[0] * e);
}

Expression witchOfAgnesi2d(const BuiltinCall& call) {
    const auto& p = call.p;
    const auto [u, v] = profile(call, 3);
    const Expression e = sq(p[1]) * v + sq(u) * v - p[2];
    return limited(-p[0] * e);
}

constexpr NumberedFormula formulas[] = {
    {0, algebraicCylinder1}, {1, algebraicCylinder2}, {2, algebraicCylinder3},  {3, algebraicCylinder4},
    {15, devilsCurve2d},     {21, foliumSurface2d},   {34, kampyleOfEudoxus2d}, {39, lemniscateOfGerono2d},
    {50, piriform2d},        {67, strophoid2d},       {75, witchOfAgnesi2d},
};

}  // namespace

std::span<const NumberedFormula> latheFormulas() { return formulas; }

}  // namespace isoscope
