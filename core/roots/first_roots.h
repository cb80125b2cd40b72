// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <glm/vec3.hpp>
#include <vector>

#include "core/roots/column_table.h"
#include "core/roots/line_query.h"

namespace isoscope {

/// The first roots of many lines, in no order: at most one a line. Keeps its memory from call to call.
struct FirstRoots {
    /// Of `crossings`; the normal points outwards and has unit length.
    enum Column : std::size_t { line, t, normalX, normalY, normalZ, columnCount };
    struct Other {
        std::size_t line = 0;
        Root root;
        glm::dvec3 normal{1, 0, 0};  ///< any length, possibly zero or not finite; not of walls
    };

    ColumnTable<columnCount> crossings;  ///< found in the plain way
    std::vector<std::size_t> entryWalls,
        exitWalls;              ///< lines whose root is where they begin, or where they end
    std::vector<Other> others;  ///< all other roots, crossings and walls among them

    void clear() {
        crossings.clear();
        entryWalls.clear();
        exitWalls.clear();
        others.clear();
    }
};

}  // namespace isoscope
