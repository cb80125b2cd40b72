// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <memory>
#include <span>
#include <stop_token>
#include <string>
#include <vector>

#include "core/shapes/isosurface/isosurface.h"
#include "core/study/shape/shape_measures.h"

namespace isoscope {

/// What a solid is like, in the coordinates of its function.
struct ShapeReport {
    bool known = false;  ///< false after a stop, and for a container that is not finite
    bool empty = false;  ///< proven: there is nothing in the container
    SolidCount solid;
    SolidCount coarse;  ///< the same with half as many cells along each axis
    glm::ivec3 cells{0};
    CellCheck check;
    glm::dvec3 low{0}, high{0};  ///< nothing of the surface is outside of this box: proven
    VolumeBracket volume;
    double area = 0;       ///< of the surface, without the container's wall
    double areaError = 0;  ///< what it is probably off by
    ThinnestWall wall;
    double accuracy = 0;  ///< the setting
    std::vector<Symmetry> symmetries;
};

/// Measures all of it; `progress` (which may be empty) is told from 0 to 1.
ShapeReport shapeReport(const std::shared_ptr<const Isosurface>& surface, std::span<const double> parameters,
                        int cells = 64, const std::function<void(double)>& progress = {},
                        std::stop_token stop = {});

/// One fact of a report in a sentence or two, for reading aloud.
struct ReportLine {
    std::string topic;  ///< "Pieces", "Extent", ...
    std::string text;
    bool proven = false;  ///< else it is measured, and the text says how
};
/// The report as text; one line that says why where nothing is known.
std::vector<ReportLine> linesOf(const ShapeReport& report);

}  // namespace isoscope
