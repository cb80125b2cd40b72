// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <glm/vec3.hpp>
#include <limits>
#include <span>
#include <vector>

#include "core/numeric/fill_numbers.h"
#include "core/roots/column_table.h"
#include "core/roots/line_query.h"
#include "core/roots/verdict.h"

namespace isoscope {

/// The first roots of many lines, in no order: at most one a line. Keeps its memory from call to call.
struct FirstRoots {
    /// The columns of `crossings`; the normal points outwards and has unit length.
    enum Column : std::size_t { t, normalX, normalY, normalZ, columnCount };
    static constexpr double none = std::numeric_limits<double>::infinity();
    struct Other {
        std::size_t line = 0;
        Root root;
        glm::dvec3 normal{1, 0, 0};  ///< any length, possibly zero or not finite; not of walls
        bool hasNormal = false;      ///< whether it is known to the finder already
    };

    /// Row k is the crossing that is the first root of line k. Its t is `none` where the line has no root, or
    /// has it in one of the lists below.
    ColumnTable<columnCount> crossings;
    std::vector<std::size_t> entryWalls,
        exitWalls;              ///< lines whose root is where they begin, or where they end
    std::vector<Other> others;  ///< all other roots, crossings and walls among them

    /// None of so many lines has a root.
    void clear(std::size_t lines) {
        crossings.reserve(lines);
        crossings.setSize(lines);
        fillNumbers(crossings[t], lines, none);
        entryWalls.clear();
        exitWalls.clear();
        others.clear();
    }

    /// The lines that have an entry in `crossings` have this verdict.
    void noteCrossings(Verdict found, std::span<Verdict> verdicts) const;
};

}  // namespace isoscope
