// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

#include "core/mesh/isosurface_mesh.h"
#include "core/scene/scene.h"

namespace isoscope {

/// An isosurface where it stands in a scene.
struct PlacedIsosurface {
    std::shared_ptr<const Isosurface> shape;
    Transform transform;  ///< from its own coordinates to the world
    MaterialId material = noMaterial;
    SourceRange range;  ///< its statement; of an object around it where that is not known
    /// Other shapes cut something of it off, or it is the hollow of a solid: a mesh shows it whole.
    bool cut = false;
};

/// All isosurfaces of a scene that are shown, in the order of its objects; one that stands in several places
/// once for each of them.
std::vector<PlacedIsosurface> placedIsosurfaces(const Scene& scene);

/// What is to be meshed of a scene.
struct SceneMeshSettings {
    /// In world coordinates; not positive: the usual one of each isosurface.
    double tolerance = 0;
    std::size_t cellLimit = MeshSettings().cellLimit;  ///< for each isosurface
    std::size_t memory = MeshSettings().memory;        ///< for all together
    std::size_t bytesOfTriangle = 0;                   ///< MeshSettings::bytesOfTriangle
    bool colors = true;
    int threads = 0;
};

/// Meshes of isosurfaces, in world coordinates.
struct SceneMesh {
    TriangleMesh mesh;  ///< an object for each of them
    MeshReport report;  ///< of all of them; lengths in world coordinates
    std::vector<MeshReport> parts;
    std::string problem;  ///< a sentence; empty where there is a mesh with triangles
};

/// Meshes these isosurfaces of the scene, with the colours of their textures. Different isosurfaces are not
/// cut where they meet. `progress` and `stop` as for meshIsosurface().
SceneMesh meshScene(const Scene& scene, const std::vector<PlacedIsosurface>& surfaces,
                    const SceneMeshSettings& settings, const std::function<void(double)>& progress = {},
                    const std::stop_token& stop = {});

}  // namespace isoscope
