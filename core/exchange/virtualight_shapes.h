// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <span>
#include <string>

#include "core/shapes/patches/height_field.h"
#include "core/virtualight/document.h"

namespace isoscope {

/// The images of height fields, which an export writes beside itself.
struct HeightImages {
    std::string stem;                          ///< their names are STEM-1.png, STEM-2.png, ...
    std::map<std::string, HeightGrid> images;  ///< by their names
};

/// A primitive of VirtuaLight as an object of POV-Ray, with its modifiers, without the closing brace, so that
/// transforms can follow. Empty when it cannot be written.
///
/// | VirtuaLight | POV-Ray |
/// |---|---|
/// | Sphere, Box | sphere, box |
/// | Cone, Cylinder | cone, cylinder, `open` |
/// | Disk, Ring | disc |
/// | Torus | torus |
/// | Paraboloid | quadric, clipped |
/// | Superquadric | superellipsoid |
/// | Polygon, TriangularPatch | polygon, smooth_triangle |
/// | Blobby | blob; with planes an isosurface of the same field |
/// | ExtrudedSurface | prism, bezier_spline for curves; an open one goes there and back |
/// | SurfaceOfRevolution | lathe |
/// | PlanarHeightField | height_field |
/// | BicubicPatch, NURBS, ParametricSurface, the other height fields | mesh2 of the same triangles |
/// | ImplicitSurface | isosurface |
/// | PolynomialSurface | poly |
///
/// The image of a PlanarHeightField goes into `images`, under the name that the text gives it.
std::string povrayPrimitive(const virtualight::Primitive& primitive,
                            const virtualight::ShapeModifiers& modifiers,
                            std::span<const double> parameterTable, HeightImages& images);

/// "<1, 2, 3>"
std::string povrayVector(const glm::dvec3& v);
/// `matrix <...>`, or nothing for the identity.
std::string povrayMatrix(const Transform& transform);

}  // namespace isoscope
