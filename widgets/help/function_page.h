// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

#include "core/function/builtins/builtin.h"

namespace isoscope {

/// The page about a built-in function, in Markdown: its picture, "picture:NAME", call, formula and
/// parameters, and the scene that shows it.
QString functionPage(const Builtin& builtin);

/// Links to the pages of all functions with a name, the numbered ones and then the patterns: the end of the
/// page about functions.
QString functionLinks();

}  // namespace isoscope
