// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <string>

#include "core/function/builtins/builtin.h"

namespace isoscope {

/// All of these are for functions with a name; internal(77) cannot be called.

/// "f_torus(x, y, z, 0.8, 0.2)": the call with the defaults.
QString callSnippet(const Builtin& builtin);

/// "f_torus(x, y, z, Major Radius, Minor Radius)", for call tips and lists.
QString signature(const Builtin& builtin);

/// A whole `isosurface { ... }` that shows the function as its Showing says; `placement`, lines like
/// "  translate <1, 0, 0>\n", comes last in it.
QString statementSnippet(const Builtin& builtin, const QString& placement = {});

/// The scene of the function's little picture: camera, lights and the statement.
std::string thumbnailScene(const Builtin& builtin);

}  // namespace isoscope
