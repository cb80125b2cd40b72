// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/evaluate/gradient_evaluator.h"

namespace isoscope {

/// |grad f|: infinite where f is infinitely steep, NaN where it is undefined.
double slopeOf(const ValueAndGradient& at);

/// How far the surface is, to first order, negative inside: (f - threshold) / |grad f|, of `height` = f -
/// threshold. 0 on the surface, infinite where f is flat, NaN with either number.
double surfaceDistance(double height, double slope);

}  // namespace isoscope
