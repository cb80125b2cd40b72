// SPDX-License-Identifier: GPL-3.0-or-later
// Helices, the wound torus and the spiral.
#include <numbers>

#include "core/function/builtins/builtin_formulas.h"

namespace isoscope {

namespace {

using std::numbers::pi;

Expression helicalTorus(const BuiltinCall& call) {
    const auto& p = call.p;
    const Expression &y = call.y, &z = call.z;
    const Expression rho = length(call.x, z);
    const Expression x = offAxis(call.x, z, 1e-6);
    const Expression phi = atan2(x, z);
    const Expression psi = atan2(rho - p[0], y);
    const Expression r = length(rho - p[0], y);
    const Expression t = wrapped(phi * p[1] + psi * p[2], x.number(2 * pi)) - pi;
    const Expression g = p[4] + p[3] * cos(p[7] * atan2(p[8] * t, r - p[5]) + p[9] * phi);
    const Expression d = lesser(sqrt(sq(r - p[5]) + p[6] * sq(t)), r + p[5]);
    return -max(p[4] + p[5] - p[0] - rho, g - d);
}

Expression helix1(const BuiltinCall& call) {
    const auto& p = call.p;
    const Expression &y = call.y, &z = call.z;
    const Expression rho = length(call.x, z);
    const Expression x = offAxis(call.x, z, 1e-6);
    const Expression turns = p[0] * atan2(z, x) + p[0] * p[1] * y, whole = x.number(2 * pi);
    const Expression perTurn = p[4] * (p[1] * p[0]);
    const Expression a = rho - p[3];
    // Without a turn of the cross section the sign of b does not matter, and nothing jumps from one turn of
    // the helix to the next; a circle does not show it.
    const Expression straight = crossSection(p[5], a, offMiddle(turns, whole) / perTurn);
    const auto section = [&] {
        if (constantOr(p[5], 0) == 1 || constantOr(p[6], 1) == 0) return straight;
        const Expression b = (wrapped(turns, whole) - pi) / perTurn;
        const Expression angle = p[6] * pi / 180;
        const Expression c = cos(angle), s = sin(angle);
        const Expression turned = crossSection(p[5], a * c - b * s, a * s + b * c);
        return select(p[6], turned, straight, turned);
    };
    return lesser(p[3] + rho, section()) - p[2];
}

Expression helix2(const BuiltinCall& call) {
    const auto& p = call.p;
    const Expression c = cos(call.y * p[1]), s = sin(call.y * p[1]);
    const Expression x = call.x - p[3] * c;
    const Expression z = call.z - p[3] * s;
    return crossSection(p[5], x * c + z * s, -x * s + z * c) - p[2];
}

Expression spiral(const BuiltinCall& call) {
    const auto& p = call.p;
    const Expression &y = call.y, &z = call.z;
    const Expression rho = length(call.x, z);
    const Expression x = offAxis(call.x, z, 1e-6);
    const Expression along = rho + p[0] * atan2(z, x) / (2 * pi), middle = p[0] * 0.5;
    // How far it is to the winding, |mod(along, p0) - p0 / 2|; the sign does not matter to the cross section.
    // `along` is not below -p0 / 2, and where it is negative, so is the remainder: it goes on as it is there.
    // So only the half winding around the axis jumps, at the cut of the angle.
    const Expression away = max(middle - along, offMiddle(along, p[0]));
    const Expression stepped = abs(mod(along, p[0]) - middle);
    const Expression a = constantOr(p[0], 0) > 0 ? away : select(p[0], stepped, stepped, away);
    const Expression d = crossSection(p[5], a, y);
    const Expression r = length(x, y, z);
    return -lesser(p[2] - r, p[1] - lesser(d, r));
}

constexpr NumberedFormula formulas[] = {{24, helicalTorus}, {25, helix1}, {26, helix2}, {64, spiral}};

}  // namespace

std::span<const NumberedFormula> helicalFormulas() { return formulas; }

}  // namespace isoscope
