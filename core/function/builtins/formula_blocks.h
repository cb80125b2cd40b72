// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <utility>

#include "core/function/graph_builder.h"

namespace isoscope {

/// The building blocks that many built-in functions share (docs/povray/functions.md, section 1). A parameter
/// may be any expression; a constant one gives a smaller graph with the same values.

/// `a` limited to [-limit, limit]; a NaN gives +limit, and a negative limit is the value everywhere.
Expression limited(Expression a, Expression limit);
/// `a` limited to [-10, 10], the usual limit.
Expression limited(Expression a);

/// The lesser of both as the built-ins compare: the first unless the second is less, so that a NaN in second
/// place is passed over. (The minimum of the scene language passes over a NaN in first place.)
Expression lesser(Expression a, Expression b);

/// (u, v) of the "SOR" parameters: the plane point (x, y), or with a switch above 0 a half-plane turned about
/// the y axis, moved by `offset` and turned by `angle` degrees.
std::pair<Expression, Expression> latheProfile(Expression x, Expression y, Expression z,
                                               Expression latheSwitch, Expression offset, Expression angle);

/// The superelliptic distance of "cross-section type": 0 square, 1 circle, 2 diamond, 3 star.
Expression crossSection(Expression type, Expression a, Expression b);

/// `x`, or `replacement` where x and z are both 0, so that the y axis has an angle.
Expression offAxis(Expression x, Expression z, double replacement);

/// Remainder of a division by `modulus`, moved into [0, modulus).
Expression wrapped(Expression a, Expression modulus);

/// |wrapped(a, modulus) - modulus / 2|; for a positive modulus without a jump.
Expression offMiddle(Expression a, Expression modulus);

/// Euclidean lengths.
Expression length(Expression a, Expression b);
Expression length(Expression a, Expression b, Expression c);

/// The value of a constant expression, `otherwise` for others; and whether an expression is constant.
double constantOr(Expression a, double otherwise);
bool isConstant(Expression a);

}  // namespace isoscope
