// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QImage>

namespace isoscope {

class VerdictMap;

/// Hatches the pixels that show the wall of a container: where a surface was cut off there, what is seen is
/// no surface of the function, and drawings have always shown cut faces so. Null where there are none.
/// `ratio` is that of device pixels, for lines as far apart on every screen.
QImage cutImage(const VerdictMap& map, double ratio);

}  // namespace isoscope
