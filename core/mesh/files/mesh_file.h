// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>

#include "core/mesh/triangle_mesh.h"

namespace isoscope {

/// Notations of meshes.
enum class MeshFormat {
    stl,      ///< binary: triangles and nothing else
    obj,      ///< text: points with colours, normals of corners, an object each
    ply,      ///< binary, little-endian: points with normals and colours
    threeMf,  ///< a zip archive for printers: points with colours, an object each, in millimetres
    gltf,     ///< .glb: points with normals and colours; those at sharp edges once for each side
    povray    ///< a `mesh2` of POV-Ray 3.7, with normals and colours
};

/// The one that a file's name ends with: .stl, .obj, .ply, .3mf, .glb, and .inc or .pov for POV-Ray.
std::optional<MeshFormat> meshFormat(const std::filesystem::path& file);

/// Which way is up in the file. POV-Ray's coordinates are left-handed, with y up and z away from the viewer;
/// those of the other programs are right-handed. Files show the same solid, not its mirror image.
enum class MeshAxes {
    povray,  ///< x, y, z as they are
    yUp,     ///< x, y, -z
    zUp,     ///< x, z, y
};

/// What programs expect of a format: z up for printers (STL, 3MF) and PLY, y up for OBJ and glTF.
MeshAxes usualAxes(MeshFormat format);

/// The bytes of a file, or why there are none.
struct MeshFile {
    std::string content;
    std::string problem;  ///< a sentence; empty where there is a file
};

/// The bytes that meshFile() takes for each triangle beside the mesh, the file included, about; found by
/// trial with colours.
std::size_t bytesOfTriangle(MeshFormat format);

/// Writes a mesh with at least one triangle. Points are written in single precision. The same bytes for the
/// same mesh.
MeshFile meshFile(TriangleMesh mesh, MeshFormat format, MeshAxes axes);
/// The same with the usual axes.
MeshFile meshFile(TriangleMesh mesh, MeshFormat format);

}  // namespace isoscope
