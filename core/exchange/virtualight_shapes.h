// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <string>

#include "core/virtualight/document.h"

namespace isoscope {

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
/// | BicubicPatch, NURBS, ParametricSurface, height fields | mesh2 of the same triangles |
/// | ImplicitSurface | isosurface |
/// | PolynomialSurface | poly |
std::string povrayPrimitive(const virtualight::Primitive& primitive,
                            const virtualight::ShapeModifiers& modifiers,
                            std::span<const double> parameterTable);

/// "<1, 2, 3>"
std::string povrayVector(const glm::dvec3& v);
/// `matrix <...>`, or nothing for the identity.
std::string povrayMatrix(const Transform& transform);

}  // namespace isoscope
