// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace isoscope {

/// How far the surface is from a point, to first order, in the units of the function's space, negative
/// inside: (f - threshold) / |grad f|, of `height` = f - threshold and `slope` = |grad f| there. Exact where
/// the slope is even, rough far from the surface. 0 on the surface, infinite where f is flat, NaN with either
/// number.
double surfaceDistance(double height, double slope);

}  // namespace isoscope
