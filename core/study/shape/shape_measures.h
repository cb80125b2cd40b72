// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <span>
#include <stop_token>
#include <string>
#include <vector>

#include "core/shapes/isosurface/isosurface.h"
#include "core/study/shape/solid_grid.h"

namespace isoscope {

/// What the volume of a solid certainly lies between.
struct VolumeBracket {
    double low = 0;
    double high = 0;  ///< infinite where nothing is known
    std::uint64_t boxes = 0;
};

/// Proves it by enclosures: boxes of the container that certainly are inside count, those that may be make
/// the difference; the largest are divided until `boxLimit`. A stop gives a bracket that is as true, and
/// wider. In cubic units of the coordinates of the surface.
VolumeBracket volumeOf(const Isosurface& surface, std::span<const double> parameters,
                       std::uint64_t boxLimit = 3'000'000, std::stop_token stop = {});

/// The area of the surface in a grid, without the container's wall: of triangles through the tetrahedra of
/// SolidGrid, with the values interpolated along their edges.
double areaOf(const SolidGrid& grid);

/// How many cells of a grid keep the criterion of Plantinga and Vegter ("Isotopic approximation of implicit
/// curves and surfaces", 2004): the function does not reach the threshold in the cell, or gradients in it
/// differ by less than a right angle, measured in cells. Where all do, the signs at the corners tell the form
/// of the surface, but for what the container's wall cuts.
struct CellCheck {
    std::uint64_t cells = 0;
    std::uint64_t open = 0;  ///< that do not keep it, or were not looked at after a stop

    /// Whether all do.
    bool complete() const { return cells > 0 && open == 0; }
};
/// Looks at blocks of cells, and halves those that do not keep it.
CellCheck checkCells(const Isosurface& surface, std::span<const double> parameters, const SolidGrid& grid,
                     std::stop_token stop = {});

/// The thinnest place that was met by going inwards from points of the surface, along the gradient, to where
/// the solid ends. An upper bound: thinner places may lie between the points.
struct ThinnestWall {
    double thickness = 0;
    glm::dvec3 place{0};       ///< where it was measured, on the surface
    std::size_t measured = 0;  ///< points; 0 where there is no surface
};
/// From the points of surfacePoints(), by the certified root finder.
ThinnestWall thinnestWall(const Isosurface& surface, std::span<const double> parameters,
                          std::stop_token stop = {});

/// A movement that maps the function onto itself, as far as points tell.
struct Symmetry {
    std::string name;  ///< "mirror x", "half turn about y", "x and y exchanged", "point"
    double error = 0;  ///< the largest difference of values that was met, in parts of their spread
};
/// Those about the middle of the container under which no value at some thousand points differs by more than
/// `tolerance` of all values' spread.
std::vector<Symmetry> symmetriesOf(const Isosurface& surface, std::span<const double> parameters,
                                   double tolerance = 1e-9);

}  // namespace isoscope
