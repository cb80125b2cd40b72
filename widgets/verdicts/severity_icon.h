// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QIcon>

#include "core/text/diagnostic.h"

namespace isoscope {

/// The sign of a severity, told apart by form as well as by colour, on light and dark ground: a disc with a
/// cross, a triangle, a square, a disc with an i. Drawn here, for icon themes have the same white sheet for
/// two of them.
QIcon severityIcon(Severity severity);

}  // namespace isoscope
