// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <functional>
#include <span>
#include <stop_token>
#include <string>

#include "core/mesh/triangle_mesh.h"
#include "core/shapes/isosurface/isosurface.h"

namespace isoscope {

/// What a mesh is to be like, and what it may cost.
struct MeshSettings {
    /// How far the mesh and the surface may be from each other, in the coordinates of the surface. What is
    /// not positive and finite stands for a part of the container's longest side (usualTolerance()).
    double tolerance = 0;
    /// Boxes of space that may be looked at.
    std::size_t cellLimit = 12'000'000;
    /// Bytes that the boxes may take with what belongs to them and with the mesh, about. Like the other limit
    /// it keeps boxes from being split; where the mesh would still take more there is none.
    std::size_t memory = 800'000'000;
    /// Of `memory`, for each triangle: what the caller makes of the mesh, a file say.
    std::size_t bytesOfTriangle = 0;
    int threads = 0;  ///< 0 means all; the mesh is the same, bit by bit
};

/// Why there is no mesh where it would exceed MeshSettings::memory: a sentence.
std::string tooLargeText(std::size_t memory);

/// The tolerance for a container that is asked for no other: a five hundredth of its longest side.
double usualTolerance(const Container& container);

/// What is known of a mesh of one isosurface or several.
struct MeshReport {
    MeshForm form;
    double tolerance = 0;  ///< that was asked for
    /// No sample of the mesh or of the surface is farther from the other (MeshDistance): sampled, not proven.
    double distance = 0;
    std::size_t samples = 0;
    std::size_t wallTriangles = 0;  ///< on the container's wall
    bool open = false;              ///< the wall is left out, so that the mesh may have borders
    bool limited = false;           ///< the limit of cells or of memory kept it from being finer
    std::size_t cells = 0;          ///< boxes that were looked at
    /// Boxes that hold no triangle, and which no proof shows to be empty; all others without triangles are
    /// proven to hold none of the surface.
    std::size_t doubtfulCells = 0;
    double widestDoubtful = 0;  ///< the longest side of the largest of them

    /// Whether the tolerance is kept, as far as the samples tell.
    bool keepsTolerance() const { return distance <= tolerance; }
    /// Takes in what is known of a further isosurface, but for the form.
    void add(const MeshReport& other);
};

/// A mesh, or why there is none.
struct IsosurfaceMesh {
    TriangleMesh mesh;
    MeshReport report;
    std::string problem;    ///< a sentence; empty where there is a mesh, perhaps one without triangles
    bool tooLarge = false;  ///< the problem is MeshSettings::memory
};

/// Meshes an isosurface in its own coordinates by dual contouring on an octree of its container: proofs by
/// intervals dismiss what is empty, cells are split until their tangent planes fit, and again where samples
/// of the mesh are too far from the surface. The mesh is closed and manifold whatever the function does; the
/// container's wall closes it as in POV-Ray, unless the isosurface is open: then the mesh ends there.
/// docs/mesh.md has the method.
///
/// `progress` (which may be empty) is told from this thread how much is done, about, from 0 to 1. A stop ends
/// it soon, with a problem that says so.
IsosurfaceMesh meshIsosurface(const Isosurface& surface, std::span<const double> parameters,
                              const MeshSettings& settings, const std::function<void(double)>& progress = {},
                              const std::stop_token& stop = {});

}  // namespace isoscope
