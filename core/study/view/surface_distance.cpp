// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/view/surface_distance.h"

namespace isoscope {

double surfaceDistance(double height, double slope) { return height == 0 && slope == 0 ? 0 : height / slope; }

}  // namespace isoscope
