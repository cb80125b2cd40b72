// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

namespace isoscope::test {

/// The tutorial's sphere: POV-Ray's default max_gradient of 1.1 is too small for it.
inline const QString sphereText = QStringLiteral(
    "#version 3.7;\nglobal_settings { assumed_gamma 1 }\n"
    "camera { location <0.4, 0.6, -4> look_at 0 angle 40 }\nlight_source { <4, 6, -5> rgb 1 }\n"
    "isosurface {\n  function { x*x + y*y + z*z - 1 }\n  contained_by { sphere { 0, 1.2 } }\n  pigment { rgb "
    "0.9 }\n}\n");

}  // namespace isoscope::test
