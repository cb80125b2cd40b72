// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "core/language/parse.h"
#include "core/mesh/scene_mesh.h"

namespace isoscope::test {

/// The meshes of all isosurfaces of a text, which may call all built-ins.
inline SceneMesh meshOf(const std::string& text, double tolerance, int threads = 2) {
    const ParseResult parsed = parseScene("#version 3.7; #include \"functions.inc\"\n" + text);
    SceneMesh failed;
    if (!parsed.ok()) {
        failed.problem = parsed.diagnostics.front().message;
        return failed;
    }
    SceneMeshSettings settings;
    settings.tolerance = tolerance;
    settings.threads = threads;
    return meshScene(*parsed.scene, placedIsosurfaces(*parsed.scene), settings);
}

/// An isosurface of this function in a container, with further items.
inline std::string statement(const std::string& function, const std::string& container,
                             const std::string& items = {}) {
    return "isosurface { function { " + function + " } contained_by { " + container + " } " + items + " }\n";
}

}  // namespace isoscope::test
